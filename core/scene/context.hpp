// What the builders of a scene's layers share.
#pragma once

#include <algorithm>

#include "core/base/deadline.hpp"
#include "core/debug/kept.hpp"
#include "core/debug/sample_in_hand.hpp"
#include "core/scene/coverage.hpp"
#include "core/scene/digest.hpp"
#include "core/scene/edge_bins.hpp"
#include "core/scene/field.hpp"
#include "core/scene/first_path.hpp"
#include "core/scene/open_cells.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/size_zone.hpp"

namespace replan {

struct SceneMemory::Parts {
  RunDigest digest;
  MapCoverage coverage;
  FieldRanges ranges;
  OpenCells open;
  SizeZone zone;
  FirstPath first_path;
  NearestVertex nearest_vertex;
  EdgeBins edges;
  KeptInReplan kept;

  /// What the latest replan before a position kept of a tree or a population; nullptr if there was no replan, or if the
  /// planner keeps neither.
  const KeptInReplan* kept_by_replan(const Run& run, std::size_t position);
};

/// Words about a cell that are put where they hide least, once all else is drawn.
struct Note {
  Cell about;
  std::vector<std::string> lines;
  Colour colour = 0;
  bool inside = false;  ///< they stay in the cell's height, else they go beside it
};

/// One scene in the making. Cells and points are by the coordinates of its view: what comes from the run, the scenario or
/// the view settings goes through seen() first.
struct SceneContext {
  const Run& run;
  const View& view;
  const Palette& palette;
  SceneMemory::Parts& memory;
  Scene& scene;

  SeenBox lattice{run.lattice(), view.slice.along};
  const SearchState& state = run.timeline().state();
  std::size_t cursor = run.timeline().cursor();
  double zoom = scene.camera.zoom;                                   ///< device pixels per cell
  int slice = std::clamp(view.slice.layer, 0, lattice.depth() - 1);  ///< the layer that is shown
  // Cells of it in sight, the upper ends excluded.
  int left = 0, top = 0, right = 0, bottom = 0;
  std::vector<Note> notes = {};           ///< for build_notes()
  std::optional<Cell> written = {};       ///< the cell that is tinted as just written
  Deadline deadline = Deadline::never();  ///< by when the field's range should be there
  static constexpr double kTint = 0.25;   ///< how much it is

  [[nodiscard]] bool has(Overlay overlay) const { return view.overlays.has(overlay); }
  /// Device pixels of a length in the design.
  [[nodiscard]] float pixels(double design) const { return static_cast<float>(design * view.scale); }
  /// World units of a length in the design.
  [[nodiscard]] double world(double design) const { return design * view.scale / zoom; }
  /// 0 where cells are smaller than `from` design pixels, 1 where larger than `to`, between them a ramp.
  [[nodiscard]] double grown(double from, double to) const {
    return std::clamp((zoom / view.scale - from) / (to - from), 0.0, 1.0);
  }
  /// Device pixels of a line that runs across cells: the design's, but never much wider than they are.
  [[nodiscard]] float line_width(double design) const {
    return pixels(std::clamp(zoom / view.scale * 0.6, std::min(1.2, design), design));
  }
  [[nodiscard]] bool in_sight(Cell cell) const {
    return cell.z == slice && cell.x >= left && cell.x < right && cell.y >= top && cell.y < bottom;
  }
  /// The node of a cell of the slice.
  [[nodiscard]] NodeId node(int x, int y) const { return lattice.node({x, y, slice}); }
  /// The colour of a thing of so many layers: faint if it does not meet the slice.
  [[nodiscard]] Colour seen_at(const Point& middle, Colour colour, int thickness = 1) const;
  /// The radius of the circle in which a ball cuts the slice; 0 if it does not.
  [[nodiscard]] double cut_radius(const Point& centre, double radius) const;
  [[nodiscard]] Cell seen(Cell cell) const { return lattice.seen(cell); }
  [[nodiscard]] Point seen(const Point& point) const { return lattice.seen(point); }
  static Point centre(Cell cell) { return centre_of(cell); }
  [[nodiscard]] Point centre(NodeId node) const { return centre_of(lattice.position(node)); }
  void add(Shape shape) { scene.shapes.push_back(std::move(shape)); }
};

/// Adds the way of something of so many layers: faint where it does not meet the slice.
void add_through_layers(SceneContext& context, Polyline line, int thickness = 1);

// What is always there, from the lowest up; the layers of marks (overlay.hpp) lie between the rim and the routes. Over all
// of them lie the numbers (numbers.hpp) and the notes.
void build_raster(SceneContext& context);
/// The field alone, a texel a cell over the whole slice: 0 where it has no value. For a view in space.
void build_field_sheet(SceneContext& context);
void build_rim(SceneContext& context);
void build_routes(SceneContext& context);
void build_things(SceneContext& context);
void build_notes(SceneContext& context, Viewport viewport);

}  // namespace replan
