// What an orbit view shows beside the faces of obstacles, as plain lists in the world's units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/scene/orbit.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/solid_mesh.hpp"

namespace replan {

/// A small cube, or what else is a box: 28 bytes, as they go to the graphics card.
struct SolidBox {
  float low[3], high[3];
  Colour colour;
};
/// A piece of a line, so many pixels wide: 32 bytes.
struct SolidLine {
  float from[3], to[3];
  Colour colour;
  float width;
};

/// A picture on the plane of the slice, a texel a cell; no texels: there is none.
struct SolidSheet {
  int columns = 0, rows = 0;
  std::vector<Colour> texels;  ///< 0: nothing is drawn there
  Point corner, right, down;   ///< of its first texel, and at the ends of its first row and column
};

/// A thing that stands in the world, drawn over it.
struct SolidMark {
  enum class Shape : std::uint8_t { star, diamond, robot } shape;
  Point at;
  Colour fill;
};

/// What an orbit view lets one choose.
struct SolidOptions {
  bool cut = false;          ///< what lies beyond the slice, towards the viewer, is left out
  bool see_through = false;  ///< obstacles hide nothing
  bool slice_alone = false;  ///< the world is too large for more than what a cut lays open
  friend bool operator==(const SolidOptions&, const SolidOptions&) = default;
};

/// Half of the world: the side of a layer on which everything shows.
struct SolidCut {
  Axis across = Axis::z;
  double at = 0;            ///< the coordinate of the plane
  bool keeps_lower = true;  ///< else what is above it
  [[nodiscard]] bool shows(const Point& point) const {
    const double place = coordinate(point, across);
    return keeps_lower ? place <= at : place >= at;
  }
};

struct SolidScene {
  std::vector<SolidFace> cut_faces;  ///< what the cut lays open
  std::vector<SolidBox> boxes;
  std::vector<SolidLine> lines;
  std::vector<SolidMark> marks;
  std::vector<Point> path;  ///< the line of the path, where it is drawn
  Sheet slice;
  SolidSheet sheet;  ///< the field on it
  // What a legend tells of that field, as in Scene.
  std::optional<Overlay> field;
  std::optional<FieldRange> range;
  std::string field_words;
  std::optional<SolidCut> cut;
  float opacity = 1;          ///< of the obstacles
  bool shows_unknown = true;  ///< obstacles that the robot does not know of too
  bool left_out = false;      ///< some of the open list: it is too long
  bool behind = false;        ///< some of it is not there yet: built once more it has more of it
  int every_edge = 1;         ///< as in Scene
  SignSet signs;              ///< of a legend, as in Scene
};

/// Whether obstacles that the robot does not know of show, as the view's overlays have it.
bool shows_unknown(const View& view);

/// Where a world is cut by a slice, seen from `eye`: what is on the eye's side of it is left out.
SolidCut cut_at(const Sheet& slice, const Point& eye);

/// What `view` shows of the run at its cursor in an orbit view; `eye` is where it is seen from, and matters for the side
/// that a cut leaves out alone. Built with a deadline, some of a long open list may be missing, and the ends of the field's
/// colours may still move. The slice is drawn as a frame, and is where a cut is made.
SolidScene build_solid_scene(const Run& run, const View& view, const SolidOptions& options, const Point& eye,
                             const Palette& palette, SceneMemory& memory,
                             const Deadline& deadline = Deadline::never());

/// The cell of what a ray meets first of what the scene shows: an obstacle, a small cube of the open list, the path, or a
/// value of the field on the slice. The path is met from `reach` beside it on, in cells at a depth of one. Where one sees
/// through obstacles, they come last.
std::optional<Cell> cell_on_ray(const Run& run, const SolidScene& scene, const EyeRay& ray, double reach = 0);

}  // namespace replan
