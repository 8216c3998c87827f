// What a view of a session shows: plain settings, kept apart from the document.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"

namespace replan {

/// What can be laid over the world. Fields colour whole cells, one at a time; marks are drawn on top, any
/// number.
enum class Overlay : std::uint8_t {
  // Fields
  g,
  rhs,
  dist,
  key,
  order,
  times,
  // Marks
  consistency,
  queue,
  repair,
  numbers,
  lp,
  rp,
  path,
  trail,
  sensor,
  unknown,
  sight,
  script,
  grid,
  count
};
inline constexpr int kFieldOverlays = 6;

struct OverlayInfo {
  Overlay overlay;
  std::string_view id;     ///< as in `--overlay` and scenario files
  std::string_view label;  ///< as in the window
  std::string_view help;   ///< a sentence that teaches
  [[nodiscard]] bool is_field() const { return static_cast<int>(overlay) < kFieldOverlays; }
};

/// All overlays in the order of the enumeration.
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
};

/// Reads ids as written by a user; the error for an unknown one suggests the nearest.
Result<OverlaySet> parse_overlays(std::span<const std::string> ids);
/// What the window shows at first: g, lp, rp, path, trail, sensor, repair, unknown, script, grid.
OverlaySet default_overlays();

/// Which part of the world a view shows. Zero zoom: fit the whole world.
struct Camera {
  double x = 0, y = 0;  ///< world coordinates (cells; cell (0, 0) covers 0..1) in the middle of the view
  double zoom = 0;      ///< device pixels per cell
  friend bool operator==(const Camera&, const Camera&) = default;
};

/// The view settings of one pane.
struct View {
  OverlaySet overlays = default_overlays();
  Camera camera;
  int slice = 0;  ///< the layer that is shown, of a world of more than one
  std::optional<Cell> hovered;
  std::optional<Cell> pinned;
  // By their numbers in the scenario.
  std::optional<std::size_t> selected_mover;
  std::optional<std::size_t> selected_surprise;
  double scale = 1;  ///< device pixels per design pixel
};

}  // namespace replan
