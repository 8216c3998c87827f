// What a view of a session shows: plain settings, kept apart from the document.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/debug/length_unit.hpp"
#include "core/drive/motion.hpp"
#include "core/lattice/seen_box.hpp"
#include "core/scene/pixel_box.hpp"

namespace replan {

class CellSet;
struct ShownFamily;

/// What can be laid over the world (overlays.def). Fields colour whole cells, one at a time; marks are drawn on
/// top, any number.
enum class Overlay : std::uint8_t {
#define REPLAN_FIELD(ID) ID,
#define REPLAN_MARK(ID) ID,
#include "core/scene/overlays.def"
#undef REPLAN_MARK
#undef REPLAN_FIELD
  count
};
/// They stand first.
inline constexpr int kFieldOverlays = 0
#define REPLAN_FIELD(ID) +1
#define REPLAN_MARK(ID)
#include "core/scene/overlays.def"
#undef REPLAN_MARK
#undef REPLAN_FIELD
    ;

struct OverlayInfo {
  std::string_view label;            ///< as in the window
  std::string_view help;             ///< a sentence that teaches
  char key = 0;                      ///< switches it in the window; 0: none
  bool at_first = false;             ///< whether the window shows it until it is switched
  double readable_from = 0;          ///< design pixels a cell from which on all of it shows; 0: always
  Overlay overlay = Overlay::count;  ///< as listed
  std::string_view id = {};          ///< likewise; as in `--overlay` and scenario files
  [[nodiscard]] bool is_field() const { return static_cast<int>(overlay) < kFieldOverlays; }
};

/// All overlays in the order of overlays.def.
std::span<const OverlayInfo> overlays();

/// A set of overlays, with at most one field.
class OverlaySet {
 public:
  [[nodiscard]] bool has(Overlay overlay) const {
    return (bits_ >> static_cast<unsigned>(overlay) & 1u) != 0;
  }
  /// Switching a field on switches the other fields off.
  void set(Overlay overlay, bool on);
  [[nodiscard]] std::optional<Overlay> field() const;
  friend bool operator==(const OverlaySet&, const OverlaySet&) = default;

 private:
  std::uint32_t bits_ = 0;
  static_assert(static_cast<int>(Overlay::count) <= 32);
};

/// Reads ids as written by a user; the error for an unknown one suggests the nearest.
Result<OverlaySet> parse_overlays(std::span<const std::string> ids);
/// What the window shows at first.
OverlaySet default_overlays();
/// Switches on what marks the cells that the last repair touched.
void show_last_repair(OverlaySet& overlays);
/// Switches on what marks the cells of points that are chosen in a plot, and those that a cell hangs together with.
void show_brushed(OverlaySet& overlays);
void show_family(OverlaySet& overlays);

/// Which part of the world a view shows. Zero zoom: fit the whole world.
struct Camera {
  double x = 0, y = 0;  ///< columns and rows (cell (0, 0) covers 0..1) in the middle of the view
  double zoom = 0;      ///< device pixels per cell
  friend bool operator==(const Camera&, const Camera&) = default;
};

/// Over what a field's colours reach.
enum class FieldSpan : std::uint8_t {
  whole_run,  ///< all values of the run: the colours stand still while one travels through it
  so_far,     ///< the values at the moment that is shown: a search that has only begun uses all colours too
};

/// The view settings of one pane.
struct View {
  OverlaySet overlays = default_overlays();
  FieldSpan range = FieldSpan::whole_run;
  Camera camera;
  Slice slice;  ///< what is shown of a world of more than one layer
  // Cells of the world.
  std::optional<Cell> hovered;
  std::optional<Cell> pinned;
  // Of the motions that a driving robot can choose from: the one that is looked at, at every moment the arc nearest to
  // it, and the one that is pointed at.
  std::optional<Twist> motion;
  std::optional<Twist> pointed_motion;
  // Of the run that they name: cells of points that were chosen in a plot, and what a cell hangs on and what on it.
  std::shared_ptr<const CellSet> brushed;
  std::shared_ptr<const ShownFamily> family;
  // By their numbers in the scenario.
  std::optional<std::size_t> selected_mover;
  std::optional<std::size_t> selected_surprise;
  std::optional<PixelBox> taken;  ///< by something that stands over the view: words keep clear of it
  double scale = 1;               ///< device pixels per design pixel
  LengthUnit lengths;             ///< in which costs of trees and populations are told
};

}  // namespace replan
