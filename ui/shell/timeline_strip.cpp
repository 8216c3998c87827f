// The timeline: the curve of expansions, what happened when, and the playhead, which can be dragged.
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/timeline_marks.hpp"

namespace replan::ui {
namespace {

/// Expansions per event at a place between 0 and 1 of the curve, between its chunks' middles.
float density(std::span<const std::uint32_t> curve, double place) {
  const double at = std::max(0.0, place * static_cast<double>(curve.size()) - 0.5);
  const auto low = std::min(static_cast<std::size_t>(at), curve.size() - 1);
  const auto high = std::min(low + 1, curve.size() - 1);
  const auto part = static_cast<float>(at - static_cast<double>(low));
  return static_cast<float>(curve[low]) * (1 - part) + static_cast<float>(curve[high]) * part;
}

/// The mean over the chunks that a column of the strip covers.
float column(std::span<const std::uint32_t> curve, double from, double to) {
  const auto count = static_cast<double>(curve.size());
  const auto first = static_cast<std::size_t>(from * count), last = static_cast<std::size_t>(to * count);
  if (last <= first + 1) return density(curve, (from + to) * 0.5);
  double sum = 0;
  for (std::size_t i = first; i < std::min(last, curve.size()); ++i) sum += curve[i];
  return static_cast<float>(sum / static_cast<double>(last - first));
}

void draw_curve(const Look& look, ImDrawList& list, const Run& run, const TimelineScale& scale, float top,
                float bottom) {
  // The last chunk is as a rule not full; it would look like a drop.
  const std::size_t whole = run.timeline().size() / Run::kCurveChunk;
  const auto curve =
      run.expansion_curve().first(std::min(std::max<std::size_t>(whole, 1), run.expansion_curve().size()));
  if (curve.empty()) return;
  const float step = std::max(look.px(2), 1.0f);
  std::vector<float> heights;
  const auto share = [&](float x) {
    return static_cast<double>(scale.position(x)) / static_cast<double>(scale.size);
  };
  for (float x = scale.left; x < scale.right; x += step)
    heights.push_back(column(curve, share(x), share(x + step)));
  if (heights.empty()) return;  // no room for a curve
  const float highest = std::max(*std::max_element(heights.begin(), heights.end()), 1.0f);
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const float x = scale.left + static_cast<float>(i) * step;
    const float a = bottom - heights[i] / highest * (bottom - top),
                b = bottom - heights[i + 1] / highest * (bottom - top);
    list.AddQuadFilled({x, a}, {x + step, b}, {x + step, bottom}, {x, bottom}, look.theme.series);
  }
}

void draw_playhead(const Look& look, ImDrawList& list, const TimelineScale& scale, std::size_t cursor,
                   float top, float track) {
  const float x = std::round(scale.x(cursor));
  const float half = look.px(2);
  list.AddRectFilled({scale.left, track - half}, {scale.right, track + half}, look.theme.line, half);
  list.AddRectFilled({scale.left, track - half}, {x, track + half}, look.theme.accent, half);
  list.AddRectFilled({x - look.px.hair, top}, {x + look.px.hair, track}, look.theme.text);
  list.AddCircleFilled({x, track}, look.px(6), look.theme.text);
}

/// What the shapes mean, where no mark stands under the mouse.
constexpr Hint kLegend = {
    "Timeline", "",
    "Triangles: a plan begins. Diamonds: the world or the goal changes. Circle: the robot arrives. Crosses: "
    "something "
    "went wrong. Flags: a breakpoint stops. A bar under a mark: several stand at its place.\n"
    "What the planner sets up before its first expansion is pressed together at the left.\n"
    "Click or drag to go anywhere."};

constexpr Hint kHill = {"Expansions", "",
                        "The hill is high where cells are expanded one after the other, and low where the "
                        "robot drives or keys are recomputed. Click or drag to go anywhere."};

void mark_hint(const Look& look, const MarkGroup& group) {
  std::string words = "Event " + grouped(group.position) + ". Click to go there.";
  if (!group.others.empty()) words += "\n" + group.others + ".";
  hint(look, {group.title.c_str(), "", words.c_str()});
}

}  // namespace

void draw_timeline(Frame& frame, ImVec2 min, ImVec2 max) {
  const Look& look = frame.look;
  const Run& run = frame.session.run();
  const TimelineScale scale = timeline_scale(look, run, min.x, max.x);
  const float track = max.y - look.px(17);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_curve(look, list, run, scale, min.y + look.px(6), track - look.px(2));
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("timeline", {std::max(max.x - min.x, 1.0f), max.y - min.y});
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const std::vector<MarkGroup> below = happenings(look, run, scale),
                               above = stops(look, frame.session, scale);
  const MarkGroup* mark = draw_groups(look, list, below, track + look.px(11));
  if (const MarkGroup* stop = draw_groups(look, list, above, track - look.px(13))) mark = stop;
  if (active) {
    // A click on a mark goes behind its event, where its effect shows; a drag goes where the mouse is.
    const bool clicked = ImGui::IsItemActivated() && mark != nullptr;
    const std::size_t target = clicked ? mark->position : scale.position(ImGui::GetIO().MousePos.x);
    if (frame.session.playback().direction != 0) frame.commands.push_back(Play{0});
    if (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0) frame.commands.push_back(Seek{target});
  } else if (hovered && mark != nullptr) {
    mark_hint(look, *mark);
  } else if (hovered && ImGui::GetIO().MousePos.y > track - look.px(4)) {
    hint(look, kLegend);
  } else if (hovered) {
    hint(look, kHill);
  }
  draw_playhead(look, list, scale, run.timeline().cursor(), min.y, track);
}

}  // namespace replan::ui
