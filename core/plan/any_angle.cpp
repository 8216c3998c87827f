#include "core/plan/any_angle.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace replan {

AnyAngle::AnyAngle(const Grid2& lattice) : lattice_(lattice) {
  graph_.look_at_map();
  points_.resize(graph_.size());
}

double AnyAngle::distance(std::uint32_t a, std::uint32_t b) const {
  return replan::distance(point_of(graph_.at(a)), point_of(graph_.at(b)));
}

void AnyAngle::offer(std::uint32_t from, std::uint32_t to) {
  Reached& point = points_[to];
  if (point.search != search_) point = {.g = HUGE_VAL, .parent = from, .search = search_, .done = false};
  const double g = points_[from].g + distance(from, to);
  if (point.done || !(g < point.g) || !graph_.bends_taut(points_[from].parent, from, to)) return;
  if (!graph_.sees(from, to)) return;
  point.g = g;
  point.parent = from;
  open_.push_back({g + distance(to, Visibility::kGoal), g, to});
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
}

void AnyAngle::search() {
  open_.assign(1, {distance(Visibility::kStart, Visibility::kGoal), 0, Visibility::kStart});
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    const std::uint32_t point = open_.back().point;
    open_.pop_back();
    if (point == Visibility::kGoal) return;
    if (std::exchange(points_[point].done, true)) continue;
    ++expansions_;
    graph_.each_offered(point, [&](std::uint32_t to) { offer(point, to); });
  }
}

Path AnyAngle::shortest(HalfPoint from, HalfPoint to) {
  const Squares map(lattice_);
  const auto inside = [&map](HalfPoint p) {
    return p.x % 2 != 0 && map.blocked((p.x - 1) / 2, (p.y - 1) / 2);
  };
  if (inside(from) || inside(to)) return {};
  if (from == to) return Path(std::vector<Point>{point_of(from)});
  graph_.set_ends(from, to);
  ++search_;
  points_[Visibility::kStart] = {.g = 0, .parent = Visibility::kStart, .search = search_, .done = false};
  search();
  return path();
}

Path AnyAngle::path() const {
  const Reached& goal = points_[Visibility::kGoal];
  if (goal.search != search_ || std::isinf(goal.g)) return {};
  std::vector<Point> way;
  for (std::uint32_t point = Visibility::kGoal;; point = points_[point].parent) {
    way.push_back(point_of(graph_.at(point)));
    if (point == Visibility::kStart) break;
  }
  std::reverse(way.begin(), way.end());
  return Path(std::move(way));
}

}  // namespace replan
