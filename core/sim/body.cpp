#include "core/sim/body.hpp"

#include <array>

namespace replan {

// Along each axis the distance to the square falls, is 0 and grows again. Between the places where that changes the
// squared distance is a parabola of the way, and on the whole it is convex: where it still falls the least is farther on.
double squared_distance(const Point& a, const Point& b, Cell square) {
  const std::array<double, 3> from = {a.x, a.y, a.z}, way = {b.x - a.x, b.y - a.y, b.z - a.z},
                              low = {double(square.x), double(square.y), double(square.z)};
  const auto gap = [&](std::size_t i, double t) {  // negative before the square, positive behind it
    const double place = from[i] + t * way[i];
    return std::min(place - low[i], 0.0) + std::max(place - low[i] - 1, 0.0);
  };
  const auto squared = [&](double t) {
    return gap(0, t) * gap(0, t) + gap(1, t) * gap(1, t) + gap(2, t) * gap(2, t);
  };
  const auto slope = [&](double t) {  // of half of it
    return gap(0, t) * way[0] + gap(1, t) * way[1] + gap(2, t) * way[2];
  };
  double begin = 0, end = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    if (way[i] == 0) continue;
    for (const double side : {low[i], low[i] + 1}) {
      const double t = (side - from[i]) / way[i];
      if (begin < t && t < end) (slope(t) > 0 ? end : begin) = t;
    }
  }
  const double middle = (begin + end) / 2;
  double bend = 0;
  for (std::size_t i = 0; i < 3; ++i) bend += gap(i, middle) != 0 ? way[i] * way[i] : 0;
  const double lowest = bend > 0 ? std::clamp(middle - slope(middle) / bend, begin, end) : middle;
  return std::min({squared(begin), squared(end), squared(lowest)});
}

bool hits(const Box& world, std::span<const std::uint8_t> truth, double radius, const Point& from,
          const Point& to) {
  return hits(world, truth, radius, std::array{from, to});
}

bool hits(const Box& world, std::span<const std::uint8_t> truth, double radius, std::span<const Point> way) {
  const double before = Body(world, radius, way.front(), way.front()).nearest(truth);
  double after = before;
  for (std::size_t i = 1; i < way.size(); ++i)
    after = std::min(after, Body(world, radius, way[i - 1], way[i]).nearest(truth));
  return after < before && std::sqrt(before) - std::sqrt(after) > Body::kTouch;
}

}  // namespace replan
