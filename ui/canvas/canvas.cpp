#include "ui/canvas/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/canvas/chips.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/canvas/hand.hpp"
#include "ui/canvas/overlay.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// In a world of another size, what was selected is no longer where it was.
void forget_places(ViewState& state) {
  while (let_go(state)) {
  }
  state.view.pinned.reset();
}

}  // namespace

struct Canvas::Parts {
  /// What a scene was built from: equal keys, equal scenes.
  struct SceneKey {
    std::uint64_t revision = 0, log_id = 0;
    OverlaySet overlays;
    Camera camera;
    std::optional<Cell> hovered, pinned;
    std::optional<std::size_t> mover, surprise;
    double scale = 0;
    Viewport viewport;
    ImU32 free = 0;
    friend bool operator==(const SceneKey&, const SceneKey&) = default;
  };

  /// A zoom on its way: towards `target`, with `anchor` staying where it is on the screen.
  struct Glide {
    double target = 0;
    Point anchor;
    ImVec2 at;
    bool active = false;
  };

  explicit Parts(ImGuiRenderer& its_renderer) : renderer(its_renderer) {}

  void prepare(const Look& look, const Session& session, const Run& run, const ViewState& state,
               Viewport viewport);
  void upload();
  void navigate(const Run& run, ViewState& state, ImVec2 min, bool hovered);
  void glide(ViewState& state, ImVec2 min);
  void point(const Session& session, const Run& run, ViewState& state, ImVec2 min, bool hovered,
             std::vector<Command>& commands);
  bool title(const Look& look, const Session& session, std::size_t pane, std::vector<Command>& commands);

  ImGuiRenderer& renderer;
  SceneMemory memory;
  FreshPlans plans;
  Scene scene;
  std::optional<SceneKey> key;
  ImTextureID texture = nullptr;
  int texture_width = 0, texture_height = 0;
  int columns = 0, rows = 0;  // of the world that was fitted
  bool fit = false;
  bool panning = false;
  Glide zooming;
  Hand hand;
  std::optional<Cell> hovered;
  ImVec2 title_min, title_max;  // of the chip that names the planner, as drawn last
};

Canvas::Canvas(ImGuiRenderer& renderer) : parts_(std::make_unique<Parts>(renderer)) {}

Canvas::~Canvas() {
  if (parts_->texture != nullptr) parts_->renderer.destroy_texture(parts_->texture);
}

void Canvas::fit() {
  parts_->fit = true;
}

bool Canvas::animating() const {
  return parts_->zooming.active || parts_->plans.busy();
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
                            Viewport viewport) {
  View view = state.view;
  view.selected_mover = state.editing.mover;
  view.selected_surprise = state.editing.surprise;
  const SceneKey now{session.revision(), run.log_id(), view.overlays,       view.camera,
                     view.hovered,       view.pinned,  view.selected_mover, view.selected_surprise,
                     view.scale,         viewport,     look.theme.free};
  if (key == now) return;
  scene = build_scene(run, view, viewport, scene_palette(look.theme), memory);
  key = now;
  upload();
}

void Canvas::Parts::glide(ViewState& state, ImVec2 min) {
  if (!zooming.active) return;
  Camera& camera = state.view.camera;
  const double rest = std::log(zooming.target / camera.zoom);
  const double step = 1 - std::exp(-18.0 * static_cast<double>(ImGui::GetIO().DeltaTime));
  zooming.active = std::abs(rest) > 0.004;
  camera.zoom = zooming.active ? camera.zoom * std::exp(rest * step) : zooming.target;
  camera.x = zooming.anchor.x - (zooming.at.x - min.x - scene.width / 2.0) / camera.zoom;
  camera.y = zooming.anchor.y - (zooming.at.y - min.y - scene.height / 2.0) / camera.zoom;
}

void Canvas::Parts::navigate(const Run& run, ViewState& state, ImVec2 min, bool is_hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const Viewport viewport{scene.width, scene.height};
  const int world_columns = run.lattice().width(), world_rows = run.lattice().height();
  if (is_hovered && io.MouseWheel != 0) {
    const double fitted = resolve({}, world_columns, world_rows, viewport).zoom;
    state.view.camera = resolve(state.view.camera, world_columns, world_rows, viewport);
    const double from = zooming.active ? zooming.target : state.view.camera.zoom;
    const double most = std::max(fitted, 200 * state.view.scale);
    zooming.target = std::clamp(from * std::pow(1.25, static_cast<double>(io.MouseWheel)),
                                std::min(fitted, 1.0) / 2, most);
    Projection screen(scene, min);
    screen.camera = state.view.camera;
    zooming.anchor = screen.world(io.MousePos);
    zooming.at = io.MousePos;
    zooming.active = true;
  }
  const bool space = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space)) && !io.WantTextInput;
  const bool grabs = ImGui::IsMouseClicked(ImGuiMouseButton_Middle) ||
                     (space && ImGui::IsMouseClicked(ImGuiMouseButton_Left));
  if (is_hovered && grabs && !hand.busy()) panning = true;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Middle) && !ImGui::IsMouseDown(ImGuiMouseButton_Left))
    panning = false;
  if (panning || (is_hovered && space)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  if (!panning || (io.MouseDelta.x == 0 && io.MouseDelta.y == 0)) return;
  zooming.active = false;
  Camera& camera = state.view.camera;
  if (camera.zoom <= 0) camera = resolve(camera, world_columns, world_rows, viewport);
  camera.x -= static_cast<double>(io.MouseDelta.x) / camera.zoom;
  camera.y -= static_cast<double>(io.MouseDelta.y) / camera.zoom;
}

void Canvas::Parts::point(const Session& session, const Run& run, ViewState& state, ImVec2 min,
                          bool is_hovered, std::vector<Command>& commands) {
  Projection screen(scene, min);
  screen.camera =
      resolve(state.view.camera, run.lattice().width(), run.lattice().height(), {scene.width, scene.height});
  const Point at = screen.world(ImGui::GetIO().MousePos);
  const Cell cell{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
  const bool inside = is_hovered && !panning && run.lattice().contains(cell);
  if (inside) {
    state.view.hovered = hovered = cell;
  } else {
    // Another pane may point elsewhere since; what this one pointed at is over in any case.
    if (hovered && state.view.hovered == hovered) state.view.hovered.reset();
    hovered.reset();
  }
  // The right button erases; with Shift it asks for the cell's menu instead.
  const bool menu = ImGui::GetIO().KeyShift && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (menu && inside && !hand.busy()) state.menu = cell;
  const double radius = 9 * state.view.scale / screen.camera.zoom;
  const Pointer pointer{.cell = cell,
                        .inside = inside,
                        .left_pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left),
                        .right_pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Right) && !menu,
                        .left_down = ImGui::IsMouseDown(ImGuiMouseButton_Left),
                        .right_down = ImGui::IsMouseDown(ImGuiMouseButton_Right),
                        .reach = std::max(0.5, radius)};
  if (hand.holds() || hand.could_hold(run, state, pointer)) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  hand.update(session, run, state, pointer, commands);
}

/// The hands on the chip that names the planner, which lies over the last item: it makes its pane lead, and
/// changes the planner of the one that does. Whether the mouse is over it.
bool Canvas::Parts::title(const Look& look, const Session& session, std::size_t pane,
                          std::vector<Command>& commands) {
  const bool over = ImGui::IsItemHovered() && ImGui::IsMouseHoveringRect(title_min, title_max, false);
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
  ImGui::SetNextWindowPos({title_min.x, title_max.y + look.px.xs});
  if (!ImGui::BeginPopup("planner")) return over;
  bool exercises = false;
  for (const PlannerInfo& info : planners()) {
    if (info.exercise && !std::exchange(exercises, true)) ImGui::Separator();
    if (ImGui::MenuItem(info.name.data(), nullptr, session.runs()[pane]->choice().id == info.id))
      commands.emplace_back(ChoosePlanner{pane, std::string(info.id)});
    hint(look, {"", "", info.summary.data()});
  }
  ImGui::EndPopup();
  return over;
}

void Canvas::draw(const Look& look, const Session& session, std::size_t pane, ViewState& state, ImVec2 min,
                  ImVec2 max, bool interactive, std::vector<Command>& commands) {
  Parts& parts = *parts_;
  const Viewport viewport{static_cast<int>(max.x - min.x), static_cast<int>(max.y - min.y)};
  if (viewport.width <= 0 || viewport.height <= 0 || pane >= session.runs().size()) return;
  const Run& run = *session.runs()[pane];
  state.view.scale = static_cast<double>(look.px.scale);
  const bool other_world = run.lattice().width() != parts.columns || run.lattice().height() != parts.rows;
  if (parts.fit || (other_world && parts.columns != 0)) {
    state.view.camera = {};
    parts.zooming.active = false;
    if (other_world) forget_places(state);
  }
  parts.fit = false;
  parts.columns = run.lattice().width();
  parts.rows = run.lattice().height();
  parts.scene.width = viewport.width;
  parts.scene.height = viewport.height;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (interactive) {
    ImGui::SetCursorScreenPos(min);
    ImGui::PushID(static_cast<int>(pane));
    ImGui::InvisibleButton("canvas", {max.x - min.x, max.y - min.y},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    const bool over_title = parts.title(look, session, pane, commands);
    const bool hovered = ImGui::IsItemHovered() && !over_title;
    ImGui::PopID();
    if (hovered && state.tools.kind().leads && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
        pane != session.lead())
      commands.emplace_back(Lead{pane});
    if (hovered) ImGui::SetMouseCursor(state.tools.kind().cursor);
    parts.navigate(run, state, min, hovered);
    parts.glide(state, min);
    if (parts.panning)
      parts.point(session, run, state, min, false, commands);
    else
      parts.point(session, run, state, min, hovered, commands);
  }
  parts.prepare(look, session, run, state, viewport);
  list.PushClipRect(min, max, true);
  list.AddRectFilled(min, max, look.theme.background);
  const Raster& raster = parts.scene.raster;
  const ImVec2 used(static_cast<float>(raster.columns) / static_cast<float>(std::max(1, parts.texture_width)),
                    static_cast<float>(raster.rows) / static_cast<float>(std::max(1, parts.texture_height)));
  draw_scene(list, look, parts.scene, min, {parts.texture, used});
  if (interactive) {
    const Projection screen(parts.scene, min);
    const bool idle = !parts.hand.holds() && !parts.panning;
    const auto hovered = idle ? parts.hovered : std::nullopt;
    draw_editing(CellPen(look, list, screen, session.scenario().map), state,
                 parts.hand.preview(state, hovered), hovered);
  }
  const bool leads = interactive && session.runs().size() > 1 && pane == session.lead();
  if (leads) list.AddRectFilled(min, {max.x, min.y + look.px(2)}, look.theme.accent);
  const ImVec2 title =
      draw_chips(look, list, run, parts.scene, parts.memory, parts.plans, state, min, max, interactive);
  parts.title_min = {min.x + look.px.m, min.y + look.px.m};
  parts.title_max = {parts.title_min.x + title.x, parts.title_min.y + title.y};
  list.PopClipRect();
}

}  // namespace replan::ui
