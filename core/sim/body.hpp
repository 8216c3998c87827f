// The robot's body: a disc (in space a ball) around its centre, and what it meets on its way.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/point.hpp"
#include "core/lattice/box.hpp"

namespace replan {

/// How near the straight way from `a` to `b` comes to the square (cube) of a cell, squared: 0 if it enters it.
double squared_distance(const Point& a, const Point& b, Cell square);

/// A body that goes straight from one point to another, or stands where both are one.
class Body {
 public:
  Body(const Box& world, double radius, const Point& from, const Point& to)
      : world_(world), radius_(radius), from_(from), to_(to) {}

  /// Calls visit(node, squared distance of the way) for each cell whose square is nearer to the way than the radius.
  /// What is no nearer than a billionth of a cell less than that only touches, since points on a slanting way are
  /// rounded.
  template <class Visit>
  void each_cell(Visit&& visit) const {
    const double reach = radius_ - kTouch;
    if (reach <= 0) return;
    const auto low = [reach](double a, double b) {
      return static_cast<int>(std::floor(std::min(a, b) - reach));
    };
    const auto high = [reach](double a, double b) {
      return static_cast<int>(std::floor(std::max(a, b) + reach));
    };
    const int layers = world_.depth() - 1;  // in a plane both ends are in the middle of the only one
    for (int z = std::max(0, low(from_.z, to_.z)); z <= std::min(layers, high(from_.z, to_.z)); ++z)
      for (int y = std::max(0, low(from_.y, to_.y)); y <= std::min(world_.height() - 1, high(from_.y, to_.y));
           ++y)
        for (int x = std::max(0, low(from_.x, to_.x));
             x <= std::min(world_.width() - 1, high(from_.x, to_.x)); ++x)
          if (const double squared = squared_distance(from_, to_, {x, y, z}); squared < reach * reach)
            visit(world_.node({x, y, z}), squared);
  }
  /// How near the way comes to the cells that are not free (cells[node] is nonzero), squared; the radius' square if no nearer.
  template <class Cells>
  [[nodiscard]] double nearest(const Cells& cells) const {
    double least = radius_ * radius_;
    each_cell([&](NodeId node, double squared) {
      if (cells[node] != 0) least = std::min(least, squared);
    });
    return least;
  }

  static constexpr double kTouch = 1e-9;

 private:
  const Box& world_;
  double radius_;
  Point from_, to_;
};

/// Whether a body that goes from `from` to `to` runs into something: comes nearer to it than its radius, and nearer
/// than it stood before. So one that something came too near to may drive away from it.
bool hits(const Box& world, std::span<const std::uint8_t> truth, double radius, const Point& from,
          const Point& to);
/// The same of a way with corners.
bool hits(const Box& world, std::span<const std::uint8_t> truth, double radius, std::span<const Point> way);

}  // namespace replan
