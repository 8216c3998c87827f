// A place in the world that need not be the middle of a cell.
#pragma once

#include <cmath>

#include "core/base/cell.hpp"

namespace replan {

/// World coordinates in cells: cell (x, y, z) covers x..x+1, y..y+1, z..z+1. In a plane z is 0.5 for what lies in
/// a cell and is not looked at by what draws.
struct Point {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

constexpr Point centre_of(Cell cell) {
  return {cell.x + 0.5, cell.y + 0.5, cell.z + 0.5};
}

/// The cell that it lies in; of several that meet there, the last.
inline Cell cell_of(const Point& point) {
  return {static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y)),
          static_cast<int>(std::floor(point.z))};
}

inline double distance(const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace replan
