// What overlays draw with in a view from outside. Everything is in the world's coordinates.
#pragma once

#include <vector>

#include "core/base/deadline.hpp"
#include "core/scene/context.hpp"
#include "core/scene/solid_scene.hpp"

namespace replan {

/// One solid scene in the making.
class SolidPen {
 public:
  /// `context` is of a view along z, whose coordinates are the world's. What belongs to a layer lies on `slice`.
  SolidPen(SceneContext& context, const Sheet& slice, bool slice_alone, const Deadline& deadline,
           SolidScene& scene)
      : context_(context), slice_(slice), slice_alone_(slice_alone), deadline_(deadline), scene_(scene) {}

  [[nodiscard]] const SceneContext& context() const { return context_; }
  [[nodiscard]] const Palette& palette() const { return context_.palette; }
  [[nodiscard]] const SearchState& state() const { return context_.state; }
  [[nodiscard]] const Sheet& slice() const { return slice_; }
  /// Whether the world is too large for more than the slice.
  [[nodiscard]] bool slice_alone() const { return slice_alone_; }
  /// By when all should be drawn; what takes longer goes on when the scene is built next.
  [[nodiscard]] const Deadline& deadline() const { return deadline_; }
  void go_on() { scene_.behind = true; }
  void show(Sign sign) { context_.scene.show(sign); }
  void draws_every_edge(int every) { scene_.every_edge = every; }

  /// Where what belongs to the slice lies: in the middle of its layer, or, cut there, on the cut.
  [[nodiscard]] double sheet() const { return scene_.cut ? scene_.cut->at : slice_.layer + 0.5; }
  /// A point of the world put there.
  [[nodiscard]] Point on_sheet(Point point) const;

  /// So many design pixels wide.
  void line(const Point& a, const Point& b, Colour colour, float width);
  void polyline(const std::vector<Point>& points, Colour colour, float width);
  /// The edges of a box between two opposite corners.
  void edges(const Point& low, const Point& high, Colour colour, float width);
  /// A small cube; nothing where a cut has left out the place. False if there are too many already.
  bool cube(const Point& centre, double half, Colour colour);
  /// The field's picture on the slice.
  void field(Overlay field);
  /// What a click on the path's line is to meet.
  void path(const std::vector<Point>& points) { scene_.path = points; }

 private:
  SceneContext& context_;
  const Sheet& slice_;
  bool slice_alone_;
  const Deadline& deadline_;
  SolidScene& scene_;
};

/// Half of the side of the small cube of a cell that waits in the open list.
inline constexpr double kWaitingHalf = 0.2;

}  // namespace replan
