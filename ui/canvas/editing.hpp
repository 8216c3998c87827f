// What the editing tools remember between one press and the next; no part of the document.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/world/scenario.hpp"

namespace replan::ui {

/// What the mouse does on the canvas.
enum class Tool : std::uint8_t {
  select,
  paint,
  erase,
  rectangle,
  start,
  goal,
  surprise,
  line,
  fill,
  mover,
  measure,
};

/// A rectangle of cells, both ends included.
struct CellRect {
  Cell low, high;
  friend bool operator==(const CellRect&, const CellRect&) = default;
};

/// When a surprise that is drawn happens.
enum class SurpriseTime : std::uint8_t { now, step, near };

/// What the stroke under way does.
enum class StrokeKind : std::uint8_t {
  none,
  paints,
  erases,
  erases_wall,  ///< because it began on an obstacle
};

/// A distance between two cells.
struct Measure {
  Cell from, to;
  friend bool operator==(const Measure&, const Measure&) = default;
};

struct Editing {
  bool round = false;  ///< the brush
  SurpriseTime surprise_time = SurpriseTime::now;
  std::int64_t surprise_step = 10;
  double surprise_within = 4;       ///< cells from the middle of what is drawn
  double mover_speed = 2;           ///< of the next moving obstacle
  WayEnd mover_end = WayEnd::back;  ///< likewise
  std::vector<Cell> way;            ///< corners drawn so far; the middle of the box goes through them
  std::optional<CellRect> region;   ///< selected cells
  std::optional<Measure> measure;
  // Numbers in the scenario; at most one is selected.
  std::optional<std::size_t> mover;
  std::optional<std::size_t> surprise;
  StrokeKind stroke = StrokeKind::none;

  /// Lets go of what is selected or half drawn, the latest first. False if there was nothing.
  bool escape() {
    if (!way.empty()) return way.clear(), true;
    if (mover || surprise) return mover.reset(), surprise.reset(), true;
    if (measure) return measure.reset(), true;
    if (region) return region.reset(), true;
    return false;
  }
  [[nodiscard]] bool holds_something() const {
    return !way.empty() || mover || surprise || measure || region;
  }
};

}  // namespace replan::ui
