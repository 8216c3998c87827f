#include "ui/canvas/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "ui/canvas/camera_hand.hpp"
#include "ui/canvas/chips.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/canvas/hand.hpp"
#include "ui/canvas/minimap.hpp"
#include "ui/canvas/number_key.hpp"
#include "ui/canvas/orbit_pane.hpp"
#include "ui/canvas/overlay.hpp"
#include "ui/canvas/planner_menu.hpp"
#include "ui/canvas/slice_bar.hpp"
#include "ui/tools/cells.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// What one notch of the wheel zooms by.
constexpr double kWheelStep = 1.25;

/// In a world of another size, what was selected is no longer where it was.
void forget_places(ViewState& state) {
  while (let_go(state)) {
  }
  state.slices.forget();
  state.view.pinned.reset();
  state.view.motion.reset();
  state.view.hovered.reset();
  state.pointed.reset();
}

}  // namespace

struct Canvas::Parts {
  /// What a scene was built from: equal keys, equal scenes.
  struct SceneKey {
    std::uint64_t revision = 0, log_id = 0;
    OverlaySet overlays;
    FieldSpan range = FieldSpan::whole_run;
    Camera camera;
    Slice slice;
    std::optional<Cell> hovered, pinned;
    std::optional<Twist> motion, pointed_motion;
    std::shared_ptr<const CellSet> brushed;
    std::shared_ptr<const ShownFamily> family;
    std::optional<std::size_t> mover, surprise;
    std::optional<PixelBox> taken;
    double scale = 0;
    Viewport viewport;
    ImU32 free = 0;
    FieldColours colours = FieldColours::viridis;
    LengthUnit lengths;
    friend bool operator==(const SceneKey&, const SceneKey&) = default;
  };

  explicit Parts(ImGuiRenderer& its_renderer) : renderer(its_renderer), minimap(its_renderer) {}

  void prepare(const Look& look, const Session& session, const Run& run, const ViewState& state,
               const Camera& camera, bool may_wait);
  void upload();
  [[nodiscard]] CameraField field(ImVec2 min) const { return {sheet.box, viewport, min}; }
  void turn_to(const Run& run, std::size_t pane, ViewState& state);
  OrbitPane& orbit_pane() {
    if (!orbit) orbit = std::make_unique<OrbitPane>(renderer);
    return *orbit;
  }
  void draw_slice(const Look& look, const Run& run, const ViewState& state, ImVec2 min, bool interactive);
  void navigate(const Look& look, std::size_t pane, ViewState& state, ImVec2 min, bool hovered);
  void take_answer(ViewState& state, const Session& session, std::size_t pane,
                   std::vector<Command>& commands);
  void point(const Session& session, std::size_t pane, ViewState& state, ImVec2 min, bool hovered,
             std::vector<Command>& commands);
  bool title(const Look& look, const Session& session, std::size_t pane, std::vector<Command>& commands);
  void draw_minimap(const Look& look, const Session& session, const Run& run, ViewState& state, ImVec2 foot);
  void take_hands(const Look& look, const Session& session, std::size_t pane, ViewState& state, ImVec2 min,
                  ImVec2 max, std::vector<Command>& commands);

  ImGuiRenderer& renderer;
  SceneMemory memory;
  std::optional<FreshPlans> plans;  // once the session has told where they are made
  Scene scene;
  std::optional<SceneKey> key;
  ImTextureID texture = nullptr;
  int texture_width = 0, texture_height = 0;
  Box world;    // that was fitted
  Sheet sheet;  // that shows
  Viewport viewport;
  CardFold card;
  bool behind = false;  // it shows what was, or nothing yet
  bool fit = false;
  CameraHand camera_hand;
  Hand hand;
  std::unique_ptr<OrbitPane> orbit;  // once the pane has shown the world from outside
  bool orbits = false;
  std::optional<Cell> hovered;
  ChipsDrawn chips;  // as drawn last
  Minimap minimap;
};

Canvas::Canvas(ImGuiRenderer& renderer) : parts_(std::make_unique<Parts>(renderer)) {}

Canvas::~Canvas() {
  if (parts_->texture != nullptr) parts_->renderer.destroy_texture(parts_->texture);
}

void Canvas::fit() {
  parts_->fit = true;
}

void Canvas::take_over(const Box& world, ViewState& state) {
  if (parts_->world != world) forget_places(state);
  state.fit_cameras();
  parts_->world = world;
  parts_->fit = false;
  parts_->camera_hand.stop();
}

bool Canvas::behind() const {
  return parts_->behind;
}

bool Canvas::animating() const {
  const bool fills_in = parts_->orbits && parts_->orbit && parts_->orbit->behind();
  return parts_->camera_hand.gliding() || (parts_->plans && parts_->plans->busy()) || parts_->behind ||
         fills_in;
}

const Scene& Canvas::scene() const {
  return parts_->scene;
}

void Canvas::Parts::upload() {
  const Raster& raster = scene.raster;
  if (raster.columns == 0 || raster.rows == 0) return;
  if (raster.columns > texture_width || raster.rows > texture_height) {
    // With room to spare: while the view moves, the number of cells in sight changes by a few.
    const auto roomy = [this](int n) { return std::min((n + 255) / 256 * 256, renderer.max_texture_size()); };
    if (texture != nullptr) renderer.destroy_texture(texture);
    texture_width = roomy(std::max(raster.columns, texture_width));
    texture_height = roomy(std::max(raster.rows, texture_height));
    texture = renderer.create_texture(texture_width, texture_height, {}, Filter::nearest);
  }
  renderer.update_texture(texture, 0, 0, raster.columns, raster.rows, raster.texels);
}

void Canvas::Parts::prepare(const Look& look, const Session& session, const Run& run, const ViewState& state,
                            const Camera& camera, bool may_wait) {
  View view = state.view;
  view.slice = {sheet.box.along(), sheet.layer};
  view.camera = camera;
  view.selected_mover = state.editing.mover;
  view.selected_surprise = state.editing.surprise;
  const SceneKey now{session.revision(),
                     run.log_id(),
                     view.overlays,
                     view.range,
                     view.camera,
                     view.slice,
                     view.hovered,
                     view.pinned,
                     view.motion,
                     view.pointed_motion,
                     view.brushed,
                     view.family,
                     view.selected_mover,
                     view.selected_surprise,
                     view.taken,
                     view.scale,
                     viewport,
                     look.theme.free,
                     state.colours,
                     view.lengths};
  behind = key != now && may_wait;
  if (key == now || behind) return;
  scene = build_scene(run, view, viewport, scene_palette(look.theme, state.colours), memory);
  key = now;
  upload();
}

void Canvas::Parts::navigate(const Look& look, std::size_t pane, ViewState& state, ImVec2 min,
                             bool is_hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  if (is_hovered && look.pinch) return camera_hand.pinch(field(min), state, *look.pinch);
  if (is_hovered && io.MouseWheel != 0 && io.KeyShift && world.solid())
    return move_slice(state.slices, pane, world, io.MouseWheel > 0 ? 1 : -1,
                      io.KeyCtrl ? SlicePanes::alone : SlicePanes::alike);
  if (is_hovered && io.MouseWheel != 0)
    camera_hand.zoom_by(field(min), state, std::pow(kWheelStep, static_cast<double>(io.MouseWheel)),
                        io.MousePos);
  camera_hand.pan(field(min), state, is_hovered, !hand.busy());
}

/// Which sheet it shows: the pane's slice of the run's world, of which it forgets what was another one's.
void Canvas::Parts::turn_to(const Run& run, std::size_t pane, ViewState& state) {
  const bool other_world = run.lattice() != world;
  if (fit || (other_world && world.width() != 0)) {
    state.fit_cameras();
    camera_hand.stop();
    if (other_world) forget_places(state);
  }
  fit = false;
  if (!state.slices.chosen()) state.slices.set_all({Axis::z, run.scenario().start.z});
  world = run.lattice();
  orbits = world.solid() && state.slices.orbits(pane);
  if (state.slices.follows_robot) state.slices.show(pane, robot_cell(run), SlicePanes::alone);
  sheet = sheet_of(world, state.slices.of(pane));
}

void Canvas::Parts::point(const Session& session, std::size_t pane, ViewState& state, ImVec2 min,
                          bool is_hovered, std::vector<Command>& commands) {
  const Run& run = *session.runs()[pane];
  Projection screen(scene, min);
  screen.camera = CameraHand::resolved(field(min), state.camera(sheet.box.along()));
  const Point at = screen.world(ImGui::GetIO().MousePos);
  const Cell cell = sheet.cell(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
  const bool over = is_hovered && !camera_hand.panning();
  const bool inside = over && run.lattice().contains(cell);
  if (inside) {
    state.view.hovered = hovered = cell;
    state.pointed = {cell, pane};
  } else {
    // Another pane may point elsewhere since; what this one pointed at is over in any case.
    if (hovered && state.view.hovered == hovered) state.view.hovered.reset();
    hovered.reset();
  }
  // Shift and the right button ask for the cell's menu, whatever the tool does with the right button alone.
  const bool menu = ImGui::GetIO().KeyShift && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (menu && inside && !hand.busy()) state.menu = cell;
  const double radius = 9 * state.view.scale / screen.camera.zoom;
  const Pointer pointer{.sheet = sheet,
                        .cell = cell,
                        .over = over,
                        .inside = inside,
                        .left_pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left),
                        .right_pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Right) && !menu,
                        .left_down = ImGui::IsMouseDown(ImGuiMouseButton_Left),
                        .right_down = ImGui::IsMouseDown(ImGuiMouseButton_Right),
                        .place = at,
                        .pixel = state.view.scale / screen.camera.zoom,
                        .reach = std::max(0.5, radius)};
  if (hand.holds() || hand.could_hold(run, state, pointer)) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  hand.update(session, run, state, pointer, commands);
}

/// The hands on the chip that names the planner, which lies over the last item: it makes its pane lead, and
/// changes the planner of the one that does. Whether the mouse is over it.
bool Canvas::Parts::title(const Look& look, const Session& session, std::size_t pane,
                          std::vector<Command>& commands) {
  const bool over = ImGui::IsItemHovered() && chips.title.holds(ImGui::GetIO().MousePos);
  const bool leads = pane == session.lead();
  if (over) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    hint(look, {session.runs()[pane]->info().name.data(), "",
                leads ? "Click to choose another planner for this pane."
                      : "A click makes this pane lead: the transport shows its run, and the others follow."});
  }
  if (over && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    if (leads)
      ImGui::OpenPopup("planner");
    else
      commands.emplace_back(Lead{pane});
  }
  // On the side of the chip with more room, and no longer than that: it scrolls then.
  const float below = ImGui::GetIO().DisplaySize.y - chips.title.max.y, above = chips.title.min.y;
  const float side = below >= above ? chips.title.max.y + look.px.xs : chips.title.min.y - look.px.xs;
  ImGui::SetNextWindowPos({chips.title.min.x, side}, ImGuiCond_Always, {0, below >= above ? 0.0f : 1.0f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {look.px(600), std::max(below, above) - 2 * look.px.s});
  if (!ImGui::BeginPopup("planner")) return over;
  planner_items(look, session, pane, commands);
  ImGui::EndPopup();
  return over;
}

/// Mouse and keys on the pane: navigation, pointing, and the tool.
void Canvas::Parts::take_hands(const Look& look, const Session& session, std::size_t pane, ViewState& state,
                               ImVec2 min, ImVec2 max, std::vector<Command>& commands) {
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("canvas", {max.x - min.x, max.y - min.y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  const bool over_title = title(look, session, pane, commands);
  // What is said over the world is not the world.
  const bool is_hovered =
      ImGui::IsItemHovered() && !over_title && !chips.message.holds(ImGui::GetIO().MousePos);
  const bool pressed =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (is_hovered && state.tools.kind().leads && pressed && pane != session.lead())
    commands.emplace_back(Lead{pane});
  if (orbits) {
    hand.let_go();
    if (hovered && state.view.hovered == hovered) state.view.hovered.reset();
    hovered.reset();
    return orbit_pane().take_hands(look, *session.runs()[pane], {min, viewport}, state, is_hovered, pane);
  }
  if (is_hovered) ImGui::SetMouseCursor(state.tools.kind().cursor);
  camera_hand.take_wishes(field(min), state);
  navigate(look, pane, state, min, is_hovered);
  camera_hand.glide(field(min), state);
  point(session, pane, state, min, is_hovered && !camera_hand.panning(), commands);
}

/// What a click on the card of the last replan asked for.
void Canvas::Parts::take_answer(ViewState& state, const Session& session, std::size_t pane,
                                std::vector<Command>& commands) {
  if (chips.card == CardAnswer::close) card.close();
  if (chips.card == CardAnswer::open) card.open();
  if (chips.card != CardAnswer::repair) return;
  state.repair_asked = true;
  if (pane != session.lead()) commands.emplace_back(Lead{pane});
}

/// Above the sentence of a stop, if there is one.
void Canvas::Parts::draw_minimap(const Look& look, const Session& session, const Run& run, ViewState& state,
                                 ImVec2 foot) {
  if (!state.minimap || state.captured || orbits || !exceeds_view(scene)) return;
  const Breakpoints& breakpoints = session.breakpoints();
  if (breakpoints.hunt() || !breakpoints.stopped().empty()) foot.y -= look.px(44);
  const auto middle = minimap.draw(look, run, memory, scene, {sheet.box.along(), sheet.layer},
                                   scene_palette(look.theme, state.colours), foot);
  if (!middle) return;
  camera_hand.stop();
  state.camera(sheet.box.along()) = {middle->x, middle->y, scene.camera.zoom};
}

/// The scene, and what tools show over it.
void Canvas::Parts::draw_slice(const Look& look, const Run& run, const ViewState& state, ImVec2 min,
                               bool interactive) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Raster& raster = scene.raster;
  const ImVec2 used(static_cast<float>(raster.columns) / static_cast<float>(std::max(1, texture_width)),
                    static_cast<float>(raster.rows) / static_cast<float>(std::max(1, texture_height)));
  draw_scene(list, look, scene, min, {texture, used});
  if (interactive) {
    const Projection screen(scene, min);
    const bool idle = !hand.holds() && !camera_hand.panning();
    const auto under = idle ? hovered : std::nullopt;
    draw_editing(CellPen(look, list, screen, run, sheet), state, hand.preview(state, sheet, under), under);
  }
}

void Canvas::draw(const Look& look, const Session& session, std::size_t pane, ViewState& state, ImVec2 min,
                  ImVec2 max, bool interactive, std::vector<Command>& commands, float below, bool may_wait) {
  Parts& parts = *parts_;
  if (pane >= session.runs().size()) return;
  const Run& run = *session.runs()[pane];
  // A picture of the canvas alone has no controls: its title tells the layer.
  const bool bar = interactive && run.lattice().solid() && !state.captured;
  // A dialog over the window does not move the world.
  const bool room = bar || (state.live && run.lattice().solid() && !state.captured);
  const float above = pane_title_height(look) + (room ? slice_bar_height(look) : 0);
  const Viewport viewport{static_cast<int>(max.x - min.x), static_cast<int>(max.y - min.y),
                          static_cast<int>(above), static_cast<int>(below)};
  if (viewport.width <= 0 || viewport.height <= 0) return;
  state.view.scale = static_cast<double>(look.px.scale);
  state.view.lengths = shown_lengths(state, session.scenario().map);
  parts.turn_to(run, pane, state);
  parts.viewport = viewport;
  parts.scene.width = viewport.width;
  parts.scene.height = viewport.height;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (may_wait && !parts.key && !parts.orbits) {
    parts.behind = true;
    list.AddRectFilled(min, max, look.theme.surround);
    return;
  }
  ImGui::PushID(static_cast<int>(pane));
  if (interactive) parts.take_hands(look, session, pane, state, min, max, commands);
  if (parts.orbits)
    parts.key.reset(), parts.behind = false;
  else
    parts.prepare(look, session, run, state, state.camera(parts.sheet.box.along()), may_wait);
  list.PushClipRect(min, max, true);
  list.AddRectFilled(min, max, look.theme.surround);
  if (parts.orbits) {
    parts.orbit_pane().draw(look, session, run, {parts.sheet.box.along(), parts.sheet.layer},
                            {min, parts.viewport}, state, parts.memory);
    parts.scene = parts.orbit->legend();
  } else {
    parts.draw_slice(look, run, state, min, interactive);
  }
  const bool leads = interactive && session.runs().size() > 1 && pane == session.lead();
  if (leads) list.AddRectFilled(min, {max.x, min.y + look.px(2)}, look.theme.accent);
  if (!parts.plans) parts.plans.emplace(session.work());
  parts.chips = draw_chips(look, list, run, parts.scene, parts.memory, *parts.plans, state,
                           {parts.sheet, bar, parts.orbits}, min, max, interactive, parts.card);
  if (bar)
    draw_slice_bar(look, parts.sheet, pane, state, {min.x + look.px(12), min.y + pane_title_height(look)},
                   max.x - min.x - 2 * look.px(12));
  parts.take_answer(state, session, pane, commands);
  if (state.legend && pane == session.lead())
    draw_number_key(look, list, run.info(), parts.scene, min,
                    {static_cast<double>(look.px.m), static_cast<double>(pane_title_height(look) + look.px.s),
                     static_cast<double>(max.x - min.x - look.px.m),
                     static_cast<double>(max.y - min.y - below - look.px.s)});
  if (pane == session.lead())
    parts.draw_minimap(look, session, run, state, {max.x - look.px.m, max.y - below - look.px.s});
  list.PopClipRect();
  ImGui::PopID();
}

}  // namespace replan::ui
