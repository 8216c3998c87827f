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

/// What making faces may take of a frame in a window, all panes together.
constexpr double kMakingMs = 5;
/// And looking for all cells of the open list and for the ends of the field's colours, after a leap.
constexpr double kListMs = 2;
/// How far beside the line of the path a click still meets it, in pixels of the design.
constexpr double kPathReach = 5;

}  // namespace

void OrbitPane::take_hands(const Look& look, const Run& run, const PaneArea& area, ViewState& state,
                           bool hovered, std::size_t pane) {
  take_wishes(run, area, state);
  if (hovered && !held_ && take_compass(look, run, area, state)) return point(run, area, state, false, pane);
  if (hovered && look.pinch) pinch(*look.pinch, run, area, state);
  drag(look, run, area, state, hovered);
  if (hovered && ImGui::GetIO().MouseWheel != 0) turn_wheel(run, area, state, pane);
  point(run, area, state, hovered, pane);
}

/// By two fingers: nearer as they part, aside as they go.
void OrbitPane::pinch(const Pinch& pinch, const Run& run, const PaneArea& area, ViewState& state) const {
  const auto right = static_cast<double>(pinch.to_x - pinch.from_x),
             down = static_cast<double>(pinch.to_y - pinch.from_y);
  if (right != 0 || down != 0) move(run, area, state, -right, -down);
  if (pinch.factor != 1)
    come_nearer(run, area, state, std::log(static_cast<double>(pinch.factor)) / std::log(kStep));
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

/// A click on the name of an axis looks along it, a double click on its middle shows the whole world.
bool OrbitPane::take_compass(const Look& look, const Run& run, const PaneArea& area, ViewState& state) const {
  const auto part = compass_part(look, lens_of(run, state.orbit, area), area, ImGui::GetIO().MousePos);
  if (!part) return false;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  hint(look, {"Compass", "",
              "Where the axes of the world lead. Click x, y or z to look along that axis; double click the "
              "middle to see the whole world from a corner again."});
  if (*part == CompassPart::middle && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) state.orbit = {};
  if (*part == CompassPart::middle || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return true;
  state.orbit = *part == CompassPart::x ? side_view() : *part == CompassPart::y ? front_view() : top_view();
  return true;
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
  const double reach = kPathReach * state.view.scale * lens.pixel_angle();
  const auto cell = hovered ? cell_on_ray(run, scene_, lens.ray(x, y), reach) : std::nullopt;
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

void OrbitPane::build(const Look& look, const Session& session, const Run& run, const Slice& slice,
                      const OrbitLens& lens, const ViewState& state, SceneMemory& memory) {
  const bool whole = may_be_whole(run.lattice());
  const Palette palette = scene_palette(look.theme, state.colours);
  if (!whole && mesh_.block_count() > 0) mesh_ = {};
  SolidOptions options = state.solid;
  options.slice_alone = !whole;
  const bool lower = cut_at(sheet_of(run.lattice(), slice), lens.eye()).keeps_lower;
  const SceneKey now{session.revision(),
                     run.log_id(),
                     options,
                     (options.cut || !whole) && lower,
                     slice,
                     state.view.overlays,
                     state.view.range,
                     state.view.pinned,
                     state.view.scale,
                     look.theme.free,
                     state.colours};
  const double share = 1 / static_cast<double>(session.runs().size());
  const auto within = [&](double ms) { return state.live ? Deadline(ms * share) : Deadline::never(); };
  if (scene_key_ != now || scene_.behind) {
    View view = state.view;
    view.slice = slice;
    if (whole) mesh_.follow(run, memory.of(run).digest, palette, shows_unknown(state.view));
    scene_ = build_solid_scene(run, view, options, lens.eye(), palette, memory, within(kListMs));
    ++scene_number_;
    scene_key_ = now;
  }
  if (whole) mesh_.make(run, lens.eye(), within(kMakingMs));
}

void OrbitPane::draw_picture(const Look& look, const Run& run, const OrbitLens& lens, const PaneArea& area,
                             const ViewState& state) {
  const PictureKey now{scene_number_, mesh_.revision(), lens.orbit(), run.lattice(), area.view};
  if (picture_key_ == now) return;
  const auto drawn = solids_.draw({mesh_, scene_, scene_number_, lens, area.view.width, area.view.height,
                                   static_cast<float>(state.view.scale), look.theme.surround,
                                   mix(look.theme.obstacle, look.theme.text, state.dark ? 0.45f : 1)});
  refused_ = drawn ? "" : drawn.error();
  texture_ = drawn ? *drawn : nullptr;
  picture_key_ = now;
}

void OrbitPane::draw(const Look& look, const Session& session, const Run& run, const Slice& slice,
                     const PaneArea& area, const ViewState& state, SceneMemory& memory) {
  const OrbitLens lens = lens_of(run, state.orbit, area);
  build(look, session, run, slice, lens, state, memory);
  draw_picture(look, run, lens, area, state);
  tell_legend(run, state, lens, area.view);
  if (texture_ != nullptr) {
    const ImVec2 max(area.min.x + static_cast<float>(area.view.width),
                     area.min.y + static_cast<float>(area.view.height));
    ImGui::GetWindowDrawList()->AddImage(texture_, area.min, max, {0, 1}, {1, 0});
    draw_solid_marks(look, run, scene_, lens, area);
    draw_compass(look, lens, area, ImGui::GetIO().MousePos);
  }
  tell_state(look, run, area);
  const bool points = pointed_ && state.view.hovered == pointed_ && !(held_ && dragged_) && !state.captured;
  if (points) draw_pointed_cell(look, run, *pointed_, lens, area);
}

/// Why there is no picture, or what is not in it.
void OrbitPane::tell_state(const Look& look, const Run& run, const PaneArea& area) const {
  std::string words = refused_;
  if (texture_ != nullptr && mesh_.waiting() > 0)
    words = "The world is being drawn: " +
            std::to_string(100 * (mesh_.block_count() - mesh_.waiting()) /
                           std::max<std::size_t>(mesh_.block_count(), 1)) +
            " % of it is there.";
  else if (texture_ != nullptr && !may_be_whole(run.lattice()))
    words =
        "This world is too large to be shown whole: these are the obstacles of the slice. Shift and "
        "the wheel move it.";
  else if (texture_ != nullptr && scene_.left_out)
    words = "More cells wait in the open list than can be shown: some are left out.";
  if (words.empty()) return;
  const TextRun text{words, refused_.empty() ? look.theme.dim : look.theme.bad, look.fonts.ui};
  chip_message(look, *ImGui::GetWindowDrawList(),
               {area.min.x + look.px(12), area.min.y + static_cast<float>(area.view.above)}, text,
               static_cast<float>(area.view.width) - 2 * look.px(12));
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
  legend_.signs = scene_.signs | mesh_.signs();
  legend_.every_edge = scene_.every_edge;
  legend_.field = scene_.field;
  legend_.range = scene_.range;
  legend_.field_words = scene_.field_words;
  if (scene_.range && state.view.hovered)
    legend_.pointed = field_value(run, *scene_.field, *state.view.hovered);
}

}  // namespace replan::ui
