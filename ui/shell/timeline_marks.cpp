#include "ui/shell/timeline_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

/// Kinds of marks, the one that matters most first: it stands for a crowd.
enum class MarkKind : std::uint8_t {
  collision,
  gave_up,
  arrival,
  put_down,
  new_goal,
  surprise,
  first_plan,
  replan,
  count
};

std::optional<MarkKind> kind_of(const Milestone& milestone) {
  switch (milestone.kind) {
    case EventKind::plan_begin:
      return milestone.payload == 0 ? MarkKind::first_plan : MarkKind::replan;
    case EventKind::surprise:
      return MarkKind::surprise;
    case EventKind::new_goal:
      return MarkKind::new_goal;
    case EventKind::put_down:
      return MarkKind::put_down;
    case EventKind::arrival:
      return MarkKind::arrival;
    case EventKind::collision:
      return MarkKind::collision;
    case EventKind::gave_up:
      return MarkKind::gave_up;
    default:
      return std::nullopt;
  }
}

MarkStyle style_of(const Theme& theme, MarkKind kind) {
  switch (kind) {
    case MarkKind::collision:
      return {MarkShape::cross, theme.bad, "The robot would hit an obstacle", "collision", "collisions"};
    case MarkKind::gave_up:
      return {MarkShape::cross, theme.bad, "The mission ends without arrival", "end", "ends"};
    case MarkKind::arrival:
      return {MarkShape::circle, theme.goal, "The robot arrives", "arrival", "arrivals"};
    case MarkKind::put_down:
      return {MarkShape::diamond, theme.start, "The robot is put down elsewhere", "time put down",
              "times put down"};
    case MarkKind::new_goal:
      return {MarkShape::diamond, theme.goal, "The goal moves: a plan from scratch", "move of the goal",
              "moves of the goal"};
    case MarkKind::surprise:
      return {MarkShape::diamond, theme.surprise, "A surprise: the world changes", "surprise", "surprises"};
    case MarkKind::first_plan:
      return {MarkShape::triangle, theme.start, "The first plan begins", "first plan", "first plans"};
    default:
      return {MarkShape::triangle, theme.surprise, "A replan begins", "replan", "replans"};
  }
}

using Counts = std::array<std::int64_t, static_cast<std::size_t>(MarkKind::count)>;

/// "Here too: 4 replans, 1 surprise" for what a crowd holds besides its head.
std::string others_text(const Theme& theme, Counts counts, MarkKind head) {
  --counts[static_cast<std::size_t>(head)];
  std::string words;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) {
      const MarkStyle style = style_of(theme, static_cast<MarkKind>(i));
      words += (words.empty() ? "Here too: " : ", ") + count_text(counts[i], style.one, style.many);
    }
  return words;
}

std::string title_of(const Milestone& milestone, const MarkStyle& style) {
  const std::uint64_t number = milestone.payload;
  if (milestone.kind == EventKind::plan_begin && number != 0) return "Replan " + grouped(number) + " begins";
  return style.name;
}

/// Half of what a mark is wide, and the least that two of a lane stand apart.
constexpr float kRadius = 5, kApart = 11;

void draw_flag(const Look& look, ImDrawList& list, ImVec2 at, ImU32 colour) {
  const float r = look.px(kRadius), foot = at.y + r * 2.4f, half = look.px(1);
  list.AddRectFilled({at.x - half, at.y - r}, {at.x + half, foot}, colour);
  list.AddRectFilled({at.x - half, at.y - r}, {at.x + r * 1.6f, at.y + r * 0.7f}, colour);
}

void draw_mark(const Look& look, ImDrawList& list, ImVec2 at, const MarkStyle& style) {
  const float r = look.px(kRadius);
  switch (style.shape) {
    case MarkShape::triangle:
      list.AddTriangleFilled({at.x, at.y - r}, {at.x + r, at.y + r}, {at.x - r, at.y + r}, style.colour);
      break;
    case MarkShape::diamond:
      list.AddQuadFilled({at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y},
                         style.colour);
      break;
    case MarkShape::circle:
      list.AddCircleFilled(at, r, style.colour);
      break;
    case MarkShape::cross:
      list.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, style.colour, look.px(2));
      list.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, style.colour, look.px(2));
      break;
    case MarkShape::flag:
      draw_flag(look, list, at, style.colour);
      break;
  }
}

MarkGroup breach_group(const Look& look, const TimelineScale& scale, const FirstBreach& breach) {
  const std::size_t event = breach.position == 0 ? 0 : breach.position - 1;
  const char* title =
      breach.law ? "The first breach of a law" : "The first plan that the oracle disagrees with";
  return {{MarkShape::cross, look.theme.bad, title, "", ""}, scale.x(event), breach.position, title, ""};
}

}  // namespace

TimelineScale timeline_scale(const Look& look, const Run& run, float left, float right) {
  TimelineScale scale{left, right, run.timeline().size()};
  const auto curve = run.expansion_curve();
  const auto first = std::find_if(curve.begin(), curve.end(), [](std::uint32_t count) { return count > 0; });
  if (first == curve.end()) return scale;
  scale.setup = static_cast<std::size_t>(first - curve.begin()) * Run::kCurveChunk;
  const float even = (right - left) * static_cast<float>(scale.setup) / static_cast<float>(scale.size);
  scale.narrow = std::min(even, look.px(10));
  return scale;
}

float TimelineScale::x(std::size_t position) const {
  if (position < setup) return left + narrow * static_cast<float>(position) / static_cast<float>(setup);
  if (size == setup) return left + narrow;
  const double part = static_cast<double>(position - setup) / static_cast<double>(size - setup);
  return left + narrow + static_cast<float>(part) * (right - left - narrow);
}

std::size_t TimelineScale::position(float x) const {
  if (x < left + narrow)
    return static_cast<std::size_t>(std::max(0.0f, (x - left) / narrow) * static_cast<float>(setup));
  const double part = std::clamp((x - left - narrow) / std::max(right - left - narrow, 1.0f), 0.0f, 1.0f);
  return setup + static_cast<std::size_t>(std::llround(part * static_cast<double>(size - setup)));
}

std::vector<MarkGroup> happenings(const Look& look, const Run& run, const TimelineScale& scale) {
  std::vector<MarkGroup> groups;
  const std::span<const Milestone> milestones = run.milestones();
  for (std::size_t i = 0; i < milestones.size();) {
    const std::optional<MarkKind> first = kind_of(milestones[i]);
    if (!first) {
      ++i;
      continue;
    }
    const float begin = scale.x(milestones[i].event);
    Counts counts{};
    MarkKind head = *first;
    std::size_t head_at = i, all = 0;
    for (; i < milestones.size() && scale.x(milestones[i].event) < begin + look.px(kApart); ++i) {
      const std::optional<MarkKind> kind = kind_of(milestones[i]);
      if (!kind) continue;
      ++all;
      ++counts[static_cast<std::size_t>(*kind)];
      if (*kind < head) head = *kind, head_at = i;
    }
    const MarkStyle style = style_of(look.theme, head);
    groups.push_back({style, scale.x(milestones[head_at].event), milestones[head_at].event + 1,
                      title_of(milestones[head_at], style),
                      all > 1 ? others_text(look.theme, counts, head) : ""});
  }
  return groups;
}

// Of a million hits only those that begin a group are looked at.
std::vector<MarkGroup> stops(const Look& look, const Session& session, const TimelineScale& scale) {
  std::vector<MarkGroup> groups;
  const std::span<const Hit> hits = session.breakpoints().hits();
  const std::span<const Breakpoint> list = session.breakpoints().list();
  const MarkStyle style{MarkShape::flag, look.theme.bad, "A breakpoint stops here", "stop", "stops"};
  for (auto first = hits.begin(); first != hits.end();) {
    const float begin = scale.x(first->position), end = begin + look.px(kApart);
    const auto next =
        std::partition_point(first, hits.end(), [&](const Hit& hit) { return scale.x(hit.position) < end; });
    const auto more = next - first - 1;
    const std::string title =
        first->breakpoint < list.size() ? list[first->breakpoint].condition : std::string(style.name);
    groups.push_back({style, begin, first->position, title,
                      more > 0 ? "Here too: " + count_text(more, "stop", "stops") : ""});
    first = next;
  }
  if (const auto breach = first_breach(session); breach && breach->pane == session.lead())
    groups.push_back(breach_group(look, scale, *breach));
  return groups;
}

const MarkGroup* draw_groups(const Look& look, ImDrawList& list, std::span<const MarkGroup> groups, float y) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const MarkGroup* hovered = nullptr;
  for (const MarkGroup& group : groups) {
    draw_mark(look, list, {group.x, y}, group.style);
    // A crowd has a bar under it, as wide as its place.
    if (!group.others.empty()) {
      const float half = look.px(kRadius), top = y + look.px(7);
      list.AddRectFilled({group.x - half, top}, {group.x + half, top + look.px(1.5f)}, group.style.colour);
    }
    if (std::abs(mouse.x - group.x) < look.px(6) && std::abs(mouse.y - y) < look.px(9)) hovered = &group;
  }
  return hovered;
}

}  // namespace replan::ui
