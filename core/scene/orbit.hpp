// From where a world in space is looked at, and what lies under a pixel.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/point.hpp"
#include "core/lattice/box.hpp"
#include "core/scene/scene.hpp"

namespace replan {

/// A view that turns around a point.
struct Orbit {
  double yaw = -0.6;   ///< radians; 0: from the front, where y is largest; against the clock, seen from above
  double pitch = 0.6;  ///< radians above the horizon
  double distance = 0;  ///< cells from the point to the eye; 0: all of the world is in sight
  Point focus = {};     ///< the point, where there is a distance; else it is the middle of the world
  static constexpr double kSteepest = 1.55;
  friend bool operator==(const Orbit&, const Orbit&) = default;
};

// The whole world, along its axes.
constexpr Orbit front_view() {
  return {0, 0, 0, {}};
}
constexpr Orbit side_view() {
  return {-std::numbers::pi / 2, 0, 0, {}};
}
constexpr Orbit top_view() {
  return {0, Orbit::kSteepest, 0, {}};
}
/// As near as to see a cell among its neighbours.
constexpr Orbit near_view(const Orbit& now, const Point& middle) {
  return {now.yaw, now.pitch, 30, middle};
}

/// A half-line.
struct EyeRay {
  Point from, direction;
  [[nodiscard]] Point at(double t) const {
    return {from.x + t * direction.x, from.y + t * direction.y, from.z + t * direction.z};
  }
};

/// An orbit as it is seen in a view of so many pixels. The world's y runs towards the viewer, as it runs down the screen
/// in a plane; z upwards.
class OrbitLens {
 public:
  OrbitLens(const Orbit& orbit, const Box& world, const Viewport& view);

  /// From the world's points to OpenGL's clip space, column by column.
  [[nodiscard]] std::array<float, 16> matrix() const;
  struct Pixel {
    double x = 0, y = 0;  ///< from the upper left corner
    double depth = 0;     ///< cells before the eye
  };
  /// Where a point is seen; nothing behind the eye.
  [[nodiscard]] std::optional<Pixel> pixel(const Point& point) const;
  [[nodiscard]] EyeRay ray(double x, double y) const;
  /// With the point and the distance that the orbit leaves open.
  [[nodiscard]] const Orbit& orbit() const { return orbit_; }
  [[nodiscard]] Point eye() const { return eye_; }
  /// In cells before the eye.
  struct Depths {
    double near = 0, far = 0;    ///< between which something is drawn
    double first = 0, last = 0;  ///< of the world's corners
    /// OpenGL's z of a depth d is deep - shift / d: -1 at `near`, 1 at `far`.
    [[nodiscard]] double deep() const { return (far + near) / (far - near); }
    [[nodiscard]] double shift() const { return 2 * far * near / (far - near); }
  };
  [[nodiscard]] const Depths& depths() const { return depths_; }
  /// How many cells a pixel is at a depth of one cell.
  [[nodiscard]] double pixel_angle() const;
  /// How many cells a pixel is, in the depth of the focus.
  [[nodiscard]] double cells_per_pixel() const;
  /// The smallest rectangle around all of the world.
  [[nodiscard]] PixelBox bounds(const Box& world) const;
  /// The focus moved by so many pixels across the view.
  [[nodiscard]] Point panned(double right, double down) const;

 private:
  static constexpr double kFieldOfView = 0.6;  // radians from top to bottom

  Orbit orbit_;
  /// The least distance from which all corners of the world lie between what is over the view's edges.
  void fit(const Box& world, const Viewport& view);
  void find_depths(const Box& world);

  int width_, height_;
  Depths depths_;
  Point eye_, right_, up_, ahead_;
};

/// Whether it meets a cube around a point, with sides of twice that.
inline bool meets_cube(const EyeRay& ray, const Point& middle, double half) {
  double enter = 0, leave = HUGE_VAL;
  const auto clip = [&](double from, double way, double at) {
    const double a = (at - half - from) / way, b = (at + half - from) / way;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  clip(ray.from.x, ray.direction.x, middle.x);
  clip(ray.from.y, ray.direction.y, middle.y);
  clip(ray.from.z, ray.direction.z, middle.z);
  return enter < leave;
}

/// The first cell that a ray meets for which `solid(cell, before)` holds, where it came from the cell `before`, which may
/// lie beside the world; nothing if there is none in the world. Cell by cell
/// along the ray: Amanatides & Woo, "A fast voxel traversal algorithm for ray tracing", Eurographics 1987.
template <class Solid>
std::optional<Cell> first_on_ray(const Box& world, const EyeRay& ray, Solid&& solid) {
  const std::array<double, 3> from = {ray.from.x, ray.from.y, ray.from.z},
                              way = {ray.direction.x, ray.direction.y, ray.direction.z};
  const std::array<int, 3> size = {world.width(), world.height(), world.depth()};
  double enter = 0, leave = HUGE_VAL;
  std::size_t entered = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0) {
      if (from[axis] < 0 || from[axis] >= size[axis]) return std::nullopt;
      continue;
    }
    const double a = -from[axis] / way[axis], b = (size[axis] - from[axis]) / way[axis];
    if (std::min(a, b) > enter) entered = axis;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter >= leave) return std::nullopt;
  std::array<int, 3> at{}, step{};
  std::array<double, 3> next{}, each{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double place = from[axis] + enter * way[axis];
    at[axis] = std::clamp(static_cast<int>(std::floor(place)), 0, size[axis] - 1);
    step[axis] = way[axis] > 0 ? 1 : -1;
    each[axis] = way[axis] == 0 ? HUGE_VAL : std::abs(1 / way[axis]);
    const double border = at[axis] + (way[axis] > 0 ? 1 : 0);
    next[axis] = way[axis] == 0 ? HUGE_VAL : (border - from[axis]) / way[axis];
  }
  std::array<int, 3> before = at;
  before[entered] -= step[entered];
  for (;;) {
    const Cell cell{at[0], at[1], at[2]};
    if (solid(cell, Cell{before[0], before[1], before[2]})) return cell;
    const auto axis = static_cast<std::size_t>(std::min_element(next.begin(), next.end()) - next.begin());
    before = at;
    at[axis] += step[axis];
    if (at[axis] < 0 || at[axis] >= size[axis]) return std::nullopt;
    next[axis] += each[axis];
  }
}

}  // namespace replan
