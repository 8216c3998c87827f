#include "ui/canvas/minimap.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/scene/cover.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Of the design: its longer side, and what the shorter one has at least.
constexpr float kLongest = 152, kShortest = 12;
/// Around it, in the window's own ground.
constexpr float kRim = 4;
/// Texels a side.
constexpr int kMostTexels = 160;

ImVec2 size_of(const Look& look, const Scene& scene) {
  const auto columns = static_cast<float>(scene.columns), rows = static_cast<float>(scene.rows);
  const float scale = look.px(kLongest) / std::max(columns, rows);
  const auto side = [&](float cells) { return std::max(look.px(kShortest), std::round(cells * scale)); };
  return {side(columns), side(rows)};
}

}  // namespace

bool exceeds_view(const Scene& scene) {
  const PixelBox world = Cover::world(scene);
  return world.left < -1 || world.top < -1 || world.right > scene.width + 1 ||
         world.bottom > scene.height + 1;
}

Minimap::~Minimap() {
  if (texture_ != nullptr) renderer_.destroy_texture(texture_);
}

void Minimap::upload() {
  const Overview& picture = keeper_.picture();
  if (texture_ == nullptr || picture.columns != width_ || picture.rows != height_) {
    if (texture_ != nullptr) renderer_.destroy_texture(texture_);
    width_ = picture.columns;
    height_ = picture.rows;
    // Few texels are cells, many the mean of some.
    const bool few = std::max(width_, height_) < kMostTexels / 4;
    texture_ = renderer_.create_texture(width_, height_, {}, few ? Filter::nearest : Filter::linear);
  }
  renderer_.update_texture(texture_, 0, 0, width_, height_, picture.texels);
}

/// World, goal and robot, and what of it the view shows.
void Minimap::paint(const Look& look, const Run& run, const Scene& scene, Axis along, ImVec2 min,
                    ImVec2 size) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  const float rim = look.px(kRim);
  list.AddRectFilled({min.x - rim, min.y - rim}, {max.x + rim, max.y + rim}, look.theme.panel, look.px.xs);
  list.AddRect({min.x - rim, min.y - rim}, {max.x + rim, max.y + rim}, look.theme.faint, look.px.xs, 0,
               look.px.hair);
  list.AddImage(texture_, min, max);
  const float across = size.x / static_cast<float>(scene.columns),
              down = size.y / static_cast<float>(scene.rows);
  const SeenBox world(run.lattice(), along);
  const auto dot = [&](NodeId node, ImU32 colour) {
    if (node == kNoNode) return;
    const Cell cell = world.position(node);
    const ImVec2 at(min.x + (static_cast<float>(cell.x) + 0.5f) * across,
                    min.y + (static_cast<float>(cell.y) + 0.5f) * down);
    list.AddCircleFilled(at, look.px(3.5f), look.theme.outline);
    list.AddCircleFilled(at, look.px(2.5f), colour);
  };
  const SearchState& state = run.timeline().state();
  const NodeId goal = state.wanted_goal(), robot = state.node(Scalar::robot);
  const Scenario& scenario = run.scenario();
  dot(goal != kNoNode ? goal : run.lattice().node(scenario.goal), look.theme.goal);
  dot(robot != kNoNode ? robot : run.lattice().node(scenario.start), look.theme.robot);
  const double half_width = scene.width / 2.0 / scene.camera.zoom,
               half_height = scene.height / 2.0 / scene.camera.zoom;
  const auto x = [&](double at) { return std::clamp(min.x + static_cast<float>(at) * across, min.x, max.x); };
  const auto y = [&](double at) { return std::clamp(min.y + static_cast<float>(at) * down, min.y, max.y); };
  const ImVec2 low(std::floor(x(scene.camera.x - half_width)), std::floor(y(scene.camera.y - half_height))),
      high(std::max(low.x + look.px(4), std::ceil(x(scene.camera.x + half_width))),
           std::max(low.y + look.px(4), std::ceil(y(scene.camera.y + half_height))));
  list.AddRectFilled(low, high, with_alpha(look.theme.accent, 0.15f));
  list.AddRect(low, high, look.theme.accent, 0, 0, look.px(1.5f));
}

std::optional<Point> Minimap::draw(const Look& look, const Run& run, SceneMemory& memory, const Scene& scene,
                                   const Slice& slice, const Palette& palette, ImVec2 foot) {
  if (keeper_.follow(run, memory, slice, palette, kMostTexels)) upload();
  const ImVec2 size = size_of(look, scene);
  const float rim = look.px(kRim);
  const ImVec2 min(std::floor(foot.x - size.x - rim), std::floor(foot.y - size.y - rim));
  const std::string id = "minimap##" + std::to_string(ImGui::GetID("minimap"));
  ImGui::SetNextWindowPos({min.x - rim, min.y - rim});
  ImGui::SetNextWindowSize({size.x + 2 * rim, size.y + 2 * rim});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::Begin(id.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar(2);
  paint(look, run, scene, slice.along, min, size);
  ImGui::InvisibleButton("world", {size.x + 2 * rim, size.y + 2 * rim});
  const bool held = ImGui::IsItemActive();
  if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (!held) hint(look, {"Minimap", "", "The whole world. A click or a drag moves the view."});
  ImGui::End();
  if (!held) return std::nullopt;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto share = [](float at, float from, float length) {
    return static_cast<double>(std::clamp((at - from) / length, 0.0f, 1.0f));
  };
  return Point{share(mouse.x, min.x, size.x) * scene.columns, share(mouse.y, min.y, size.y) * scene.rows};
}

}  // namespace replan::ui
