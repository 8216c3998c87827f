#include "ui/canvas/orbit_pane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/scene/context.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// How far a pixel of the design turns, in radians.
constexpr double kTurn = 0.008;
constexpr double kStep = 1.15, kPan = 80;

OrbitLens lens_of(const Run& run, const Orbit& orbit, const PaneArea& area) {
  return {orbit, run.lattice(), area.view};
}

/// Whether all of its obstacles are drawn: making their faces takes a second for some 30 million cells.
bool may_be_whole(const Box& world) {
  constexpr std::size_t kMost = std::size_t{1} << 25;
  return world.node_count() <= kMost && std::max({world.width(), world.height(), world.depth()}) < 65536;
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
  take_wishes(run, area, state);
  drag(look, run, area, state, hovered);
  if (hovered && ImGui::GetIO().MouseWheel != 0) turn_wheel(run, area, state, pane);
  point(run, area, state, hovered, pane);
}

void OrbitPane::come_nearer(const Run& run, const PaneArea& area, ViewState& state, double steps) const {
  const double whole = lens_of(run, {state.orbit.yaw, state.orbit.pitch, 0, {}}, area).orbit().distance;
  state.orbit = lens_of(run, state.orbit, area).orbit();
  state.orbit.distance = std::clamp(state.orbit.distance * std::pow(kStep, -steps), 2.0, 3 * whole);
}

void OrbitPane::move(const Run& run, const PaneArea& area, ViewState& state, double right,
                     double down) const {
  const OrbitLens lens = lens_of(run, state.orbit, area);
  state.orbit = lens.orbit();
  const Point to = lens.panned(right, down);
  const Box& world = run.lattice();
  const auto kept = [](double at, int side) { return std::clamp(at, -0.5 * side, 1.5 * side); };
  state.orbit.focus = {kept(to.x, world.width()), kept(to.y, world.height()), kept(to.z, world.depth())};
}

/// What keys and buttons asked for.
void OrbitPane::take_wishes(const Run& run, const PaneArea& area, ViewState& state) const {
  if (const int steps = std::exchange(state.zoom_steps, 0); steps != 0)
    come_nearer(run, area, state, 1.6 * steps);
  const int x = std::exchange(state.pan_x, 0), y = std::exchange(state.pan_y, 0);
  if (x != 0 || y != 0) move(run, area, state, kPan * x * state.view.scale, kPan * y * state.view.scale);
}

/// The left button turns the world, the middle and the right one move it.
void OrbitPane::drag(const Look& look, const Run& run, const PaneArea& area, ViewState& state, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle, ImGuiMouseButton_Right})
    if (hovered && !held_ && ImGui::IsMouseClicked(button)) {
      held_ = button;
      dragged_ = false;
    }
  const auto right = static_cast<double>(io.MouseDelta.x), down = static_cast<double>(io.MouseDelta.y);
  if (!held_ || (right == 0 && down == 0)) return;
  dragged_ = true;
  if (*held_ != ImGuiMouseButton_Left) return move(run, area, state, -right, -down);
  const double scale = static_cast<double>(look.px.scale);
  state.orbit = lens_of(run, state.orbit, area).orbit();
  state.orbit.yaw -= right / scale * kTurn;
  state.orbit.pitch =
      std::clamp(state.orbit.pitch + down / scale * kTurn, -Orbit::kSteepest, Orbit::kSteepest);
}

void OrbitPane::turn_wheel(const Run& run, const PaneArea& area, ViewState& state, std::size_t pane) const {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.KeyShift) return come_nearer(run, area, state, static_cast<double>(io.MouseWheel));
  move_slice(state.slices, pane, run.lattice(), io.MouseWheel > 0 ? 1 : -1,
             io.KeyCtrl ? SlicePanes::alone : SlicePanes::alike);
}

/// A click pins the cell under the cursor, with the right button it asks for its menu.
void OrbitPane::point(const Run& run, const PaneArea& area, ViewState& state, bool hovered,
                      std::size_t pane) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const OrbitLens lens = lens_of(run, state.orbit, area);
  const auto x = static_cast<double>(mouse.x - area.min.x), y = static_cast<double>(mouse.y - area.min.y);
  const auto cell = hovered ? cell_on_ray(run, scene_, lens.ray(x, y)) : std::nullopt;
  // Another pane may point elsewhere since; what this one pointed at is over in any case.
  if (!cell && pointed_ && state.view.hovered == pointed_) state.view.hovered.reset();
  pointed_ = cell;
  if (cell) {
    state.view.hovered = cell;
    state.pointed = {*cell, pane};
  }
  if (!held_ || ImGui::IsMouseDown(*held_)) return;
  if (!dragged_ && *held_ == ImGuiMouseButton_Left)
    state.view.pinned = state.view.pinned == cell ? std::nullopt : cell;
  if (!dragged_ && *held_ == ImGuiMouseButton_Right && cell) state.menu = cell;
  held_.reset();
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
    const bool whole = may_be_whole(run.lattice());
    SolidOptions options = state.solid;
    options.slice_alone = !whole;
    if (whole) mesh_.follow(run, memory.of(run).digest, palette);
    scene_ = build_solid_scene(run, view, options, lens.eye(), palette, memory);
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
  if (may_be_whole(run.lattice())) return;
  const TextRun words{"This world is too large to be shown whole: these are the obstacles of the slice.",
                      look.theme.text, look.fonts.ui};
  chip(look, list, {area.min.x + look.px(12), area.min.y + static_cast<float>(size.above)},
       std::span(&words, 1));
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
    const bool hidden = first_on_ray(world, back, [&](Cell cell, Cell) {
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
  const PixelBox all = lens.bounds(run.lattice());
  const PixelBox seen{std::clamp(all.left, 0.0, static_cast<double>(view.width)),
                      std::clamp(all.top, 0.0, static_cast<double>(view.height)),
                      std::clamp(all.right, 0.0, static_cast<double>(view.width)),
                      std::clamp(all.bottom, 0.0, static_cast<double>(view.height))};
  const double zoom = 1 / lens.cells_per_pixel();
  legend_.camera = {(view.width / 2.0 - seen.left) / zoom, (view.height / 2.0 - seen.top) / zoom, zoom};
  legend_.columns = static_cast<int>(seen.width() / zoom);
  legend_.rows = static_cast<int>(seen.height() / zoom);
  legend_.signs = scene_.signs;
}

}  // namespace replan::ui
