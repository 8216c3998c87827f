#include "ui/canvas/orbit_pane.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/context.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// How far a pixel of the design turns, in radians.
constexpr double kTurn = 0.008;
constexpr double kStep = 1.15;

OrbitLens lens_of(const Run& run, const Orbit& orbit, const PaneArea& area) {
  return {orbit, run.lattice(), area.view};
}

/// Points of a star, or of a square on its tip, around a middle.
void add_star(ImDrawList& list, ImVec2 at, float radius, int tips, float inner, ImU32 fill, ImU32 rim,
              float width) {
  std::array<ImVec2, 16> points{};
  const int count = tips * 2;
  for (int i = 0; i < count; ++i) {
    const float angle = static_cast<float>(i) * 3.14159265f / static_cast<float>(tips) - 1.57079633f;
    const float reach = i % 2 == 0 ? radius : radius * inner;
    points[static_cast<std::size_t>(i)] = {at.x + reach * std::cos(angle), at.y + reach * std::sin(angle)};
  }
  // Not convex: from the middle out.
  for (int i = 0; i < count; ++i)
    list.AddTriangleFilled(at, points[static_cast<std::size_t>(i)],
                           points[static_cast<std::size_t>((i + 1) % count)], fill);
  list.AddPolyline(points.data(), count, rim, ImDrawFlags_Closed, width);
}

}  // namespace

void OrbitPane::take_hands(const Look& look, const Run& run, const PaneArea& area, ViewState& state,
                           bool hovered, std::size_t pane) {
  const ImGuiIO& io = ImGui::GetIO();
  OrbitLens lens = lens_of(run, state.orbit, area);
  const bool pressed = hovered && !turning_ && !moving_;
  if (pressed && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) turning_ = true, moved_ = false;
  if (pressed &&
      (ImGui::IsMouseClicked(ImGuiMouseButton_Middle) || ImGui::IsMouseClicked(ImGuiMouseButton_Right)))
    moving_ = true, moved_ = false;
  const bool dragged = std::abs(io.MouseDelta.x) + std::abs(io.MouseDelta.y) > 0;
  if ((turning_ || moving_) && dragged) {
    moved_ = true;
    state.orbit = lens.orbit();
    const double scale = static_cast<double>(look.px.scale), right = static_cast<double>(io.MouseDelta.x),
                 down = static_cast<double>(io.MouseDelta.y);
    if (moving_) {
      state.orbit.focus = lens.panned(-right, -down);
    } else {
      state.orbit.yaw += -right / scale * kTurn;
      state.orbit.pitch =
          std::clamp(state.orbit.pitch + down / scale * kTurn, -Orbit::kSteepest, Orbit::kSteepest);
    }
    lens = lens_of(run, state.orbit, area);
  }
  if (hovered && io.MouseWheel != 0) {
    if (io.KeyShift) return move_slice(state.slices, pane, run.lattice(), io.MouseWheel > 0 ? 1 : -1);
    state.orbit = lens.orbit();
    state.orbit.distance =
        std::clamp(state.orbit.distance * std::pow(kStep, -static_cast<double>(io.MouseWheel)), 2.0, 4000.0);
  }
  const auto x = static_cast<double>(io.MousePos.x - area.min.x),
             y = static_cast<double>(io.MousePos.y - area.min.y);
  const auto cell = hovered ? cell_on_ray(run, scene_, lens.ray(x, y)) : std::nullopt;
  if (hovered) {
    state.view.hovered = cell;
    if (cell) state.pointed = {*cell, pane};
  }
  if (turning_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    turning_ = false;
    if (!moved_) state.view.pinned = state.view.pinned == cell ? std::nullopt : cell;
  }
  if (moving_ && !ImGui::IsMouseDown(ImGuiMouseButton_Middle) &&
      !ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    moving_ = false;
    if (!moved_ && cell) state.menu = cell;
  }
}

void OrbitPane::draw(const Look& look, const Session& session, const Run& run, const Slice& slice,
                     const PaneArea& area, const ViewState& state, SceneMemory& memory) {
  const OrbitLens lens = lens_of(run, state.orbit, area);
  const Viewport& size = area.view;
  const Key now{session.revision(),  run.log_id(),      state.orbit, state.solid,      slice,
                state.view.overlays, state.view.pinned, size,        state.view.scale, look.theme.free};
  if (key_ != now) {
    const Palette palette = scene_palette(look.theme, state.colours);
    View view = state.view;
    view.slice = slice;
    mesh_.follow(run, memory.of(run).digest, palette);
    scene_ = build_solid_scene(run, view, state.solid, lens.eye(), palette, memory);
    const auto drawn =
        solids_.draw({mesh_, scene_, lens.matrix(), size.width, size.height, look.theme.surround});
    refused_ = drawn ? "" : drawn.error();
    texture_ = drawn ? *drawn : nullptr;
    key_ = now;
    tell_legend(run, state, lens, size);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (texture_ == nullptr) {
    const TextRun words{refused_, look.theme.bad, look.fonts.ui};
    chip(look, list, {area.min.x + look.px.l, area.min.y + static_cast<float>(size.above) + look.px.l},
         std::span(&words, 1));
    return;
  }
  const ImVec2 max(area.min.x + static_cast<float>(size.width), area.min.y + static_cast<float>(size.height));
  list.AddImage(texture_, area.min, max, {0, 1}, {1, 0});
  draw_marks(look, run, lens, area);
  draw_compass(look, lens, area);
}

/// Start, goal and robot: strong where nothing hides them.
void OrbitPane::draw_marks(const Look& look, const Run& run, const OrbitLens& lens,
                           const PaneArea& area) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const SearchState& state = run.timeline().state();
  const Box& world = run.lattice();
  for (const SolidMark& mark : scene_.marks) {
    const auto pixel = lens.pixel(mark.at);
    if (!pixel) continue;
    const Cell own = cell_of(mark.at);
    const Point eye = lens.eye();
    const Ray back{mark.at, {eye.x - mark.at.x, eye.y - mark.at.y, eye.z - mark.at.z}};
    const bool hidden = first_on_ray(world, back, [&](Cell cell) {
                          const bool shown = !scene_.cut || scene_.cut->shows(centre_of(cell));
                          const bool inner = cell.x > 0 && cell.y > 0 && cell.z > 0 &&
                                             cell.x + 1 < world.width() && cell.y + 1 < world.height() &&
                                             cell.z + 1 < world.depth();
                          return cell != own && shown && inner && state.truly_blocked(world.node(cell));
                        }).has_value();
    const float strength = hidden && scene_.opacity >= 1 ? 0.45f : 1;
    const ImVec2 at(area.min.x + static_cast<float>(pixel->x), area.min.y + static_cast<float>(pixel->y));
    const ImU32 fill = with_alpha(mark.fill, strength), rim = with_alpha(look.theme.outline, strength);
    const float radius = look.px(9);
    if (mark.shape == SolidMark::Shape::star) {
      add_star(list, at, radius * 1.2f, 5, 0.45f, fill, rim, look.px(1.5f));
    } else if (mark.shape == SolidMark::Shape::diamond) {
      add_star(list, at, radius * 1.2f, 4, 0.72f, fill, rim, look.px(1.5f));
    } else {
      list.AddCircleFilled(at, radius * 0.8f, fill);
      list.AddCircle(at, radius * 0.8f, rim, 0, look.px(2));
    }
  }
}

/// Where the world's axes lead, in the lower left corner.
void OrbitPane::draw_compass(const Look& look, const OrbitLens& lens, const PaneArea& area) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float reach = look.px(26);
  const ImVec2 at(area.min.x + look.px(44),
                  area.min.y + static_cast<float>(area.view.height - area.view.below) - look.px(44));
  const OrbitLens small(Orbit{lens.orbit().yaw, lens.orbit().pitch, 8, {}}, Box(1, 1, 1), {100, 100});
  const auto origin = small.pixel({});
  struct Direction {
    Point tip;
    const char* name;
  };
  for (const Direction& each : {Direction{{1, 0, 0}, "x"}, {{0, 1, 0}, "y"}, {{0, 0, 1}, "z"}}) {
    const auto tip = small.pixel(each.tip);
    if (!tip || !origin) continue;
    const float scale = reach / 20.0f;
    const ImVec2 way(static_cast<float>(tip->x - origin->x) * scale,
                     static_cast<float>(tip->y - origin->y) * scale);
    const ImVec2 end(at.x + way.x, at.y + way.y);
    list.AddLine(at, end, look.theme.dim, look.px(1.5f));
    const ImVec2 half(look.px(8), look.px(8));
    const ImVec2 middle(at.x + way.x * 1.3f, at.y + way.y * 1.3f);
    draw_text_centred(list, look.fonts.small, {middle.x - half.x, middle.y - half.y},
                      {middle.x + half.x, middle.y + half.y}, look.theme.text, each.name);
  }
}

/// With the world where it is seen, so that what floats over the pane keeps clear of it.
void OrbitPane::tell_legend(const Run& run, const ViewState& state, const OrbitLens& lens,
                            const Viewport& view) {
  legend_ = Scene{};
  legend_.width = view.width;
  legend_.height = view.height;
  legend_.scale = state.view.scale;
  const PixelBox seen = lens.bounds(run.lattice());
  const double zoom = 1 / lens.cells_per_pixel();
  legend_.camera = {(view.width / 2.0 - seen.left) / zoom, (view.height / 2.0 - seen.top) / zoom, zoom};
  legend_.columns = static_cast<int>(seen.width() / zoom);
  legend_.rows = static_cast<int>(seen.height() / zoom);
  legend_.signs = scene_.signs;
}

}  // namespace replan::ui
