// What is marked on the timeline: what happened, where breakpoints stop, and the first thing that went wrong.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/shell/frame.hpp"

namespace replan::ui {

/// How a kind of mark looks: by shape and by colour.
enum class MarkShape : std::uint8_t { triangle, diamond, circle, cross, flag };
struct MarkStyle {
  MarkShape shape;
  ImU32 colour;
  const char* name;        ///< of one: "A replan begins"
  const char *one, *many;  ///< of it: "replan", "replans"
};

/// Where events stand on the strip: evenly, but for what a planner sets up before its first expansion, which may be a
/// third of all events and is pressed into a narrow stretch.
struct TimelineScale {
  float left;
  float right;
  std::size_t size;       ///< of the log
  std::size_t setup = 0;  ///< how many first events are pressed together
  float narrow = 0;       ///< width of their stretch

  [[nodiscard]] float x(std::size_t position) const;
  [[nodiscard]] std::size_t position(float x) const;
};
/// The scale of a run's whole log. Of a log that has no expansion yet all events stand evenly.
TimelineScale timeline_scale(const Look& look, const Run& run, float left, float right);

/// Marks that stand so close together that they share a place. The one that matters most stands for all.
struct MarkGroup {
  MarkStyle style;
  float x;
  std::size_t position;  ///< where a click goes: behind the event of the one that is shown
  std::string title;     ///< "Replan 3 begins", "A surprise: the world changes"
  std::string others;    ///< "and 4 replans, 2 surprises"; empty for a single one
};

/// What happened, for the lane under the track; the breakpoints' stops and the first breach, for the one over
/// it.
std::vector<MarkGroup> happenings(const Look& look, const Run& run, const TimelineScale& scale);
std::vector<MarkGroup> stops(const Look& look, const Session& session, const TimelineScale& scale);

/// Draws the groups along a line and returns the one under the mouse, or nullptr.
const MarkGroup* draw_groups(const Look& look, ImDrawList& list, std::span<const MarkGroup> groups, float y);

}  // namespace replan::ui
