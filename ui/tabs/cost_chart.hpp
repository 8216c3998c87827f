// A small chart of what paths cost, over samples or generations: axes, curves and their keys, and the mouse on it.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/debug/length_unit.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

enum class CostScale : std::uint8_t {
  linear,
  logarithmic,  ///< where the first costs are many times as high as all that is gained later
};

/// Where counts (of samples, of generations) and costs stand.
struct CostAxes {
  CostScale scale = CostScale::linear;
  ImVec2 min, max;
  double count = 1;  ///< at the right
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(double cost);
  void reach(std::int64_t to) { count = std::max(count, static_cast<double>(to)); }
  [[nodiscard]] bool empty() const { return high < low; }
  [[nodiscard]] float x(std::int64_t at) const;
  [[nodiscard]] float y(double cost) const;
  /// The count at a place of the screen, within the axes.
  [[nodiscard]] double count_at(float x) const;
};

/// A point of a curve; an infinite cost is a gap.
struct CostPoint {
  std::int64_t at = 0;
  double cost = 0;
};

enum class CurveMark : std::uint8_t { thick, thin, dashes, dot };
/// What a curve, or a mark, stands for.
struct CurveKey {
  CurveMark mark = CurveMark::thick;
  ImU32 colour = 0;
  std::string label;
};

/// One chart while it is drawn, over the width that is left: first what its axes have to hold, then lay_out(), then curves,
/// then the keys.
class CostChart {
 public:
  CostChart(Frame& frame, const char* id, float height, CostScale scale);

  CostAxes axes;

  /// Draws the axes, whose right end is called `end`. False, and nothing is there to be drawn, if they hold no cost.
  bool lay_out(LengthUnit lengths, int decimals, const std::string& end);
  /// A cost that holds until the next point's, so that the line goes in steps, the last one up to `end`.
  void steps(std::span<const CostPoint> curve, std::int64_t end, ImU32 colour, CurveMark mark);
  /// The points joined.
  void line(std::span<const CostPoint> curve, ImU32 colour, CurveMark mark);
  void level(double cost, ImU32 colour);
  void dot(const CostPoint& point, ImU32 colour);
  void playhead(std::int64_t at);
  /// Below the chart, in as many lines as they take.
  void keys(std::span<const CurveKey> keys);

  /// What the mouse is at, while it is over the chart or drags in it.
  [[nodiscard]] std::optional<double> pointed() const;
  /// Whether the user asks to go to what the mouse is at.
  [[nodiscard]] bool asks() const { return asks_; }

 private:
  [[nodiscard]] float thickness(CurveMark mark) const;

  const Look& look_;
  ImDrawList& list_;
  ImVec2 origin_;
  float width_, height_;
  bool over_ = false, asks_ = false;
};

/// The colour of a pane's curve: the leading one's stands out, those of the others differ.
ImU32 curve_colour(const Frame& frame, std::size_t pane);
/// What a pane's curve is called: its planner, with the pane's number where there are several.
std::string curve_name(const Frame& frame, std::size_t pane);

}  // namespace replan::ui
