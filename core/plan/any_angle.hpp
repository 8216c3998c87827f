// The shortest way of a point through the plane, whatever its directions: the yardstick of any-angle paths, by A* over the
// visibility graph (visibility.hpp). The planner of that name searches it too, in whole numbers and step by step; this one
// has lengths in doubles, made by + - * / and sqrt alone, and goes from corner to corner as well.
#pragma once

#include <cstdint>
#include <vector>

#include "core/plan/path.hpp"
#include "core/plan/visibility.hpp"

namespace replan {

/// Shortest ways on one map; many can be asked for.
class AnyAngle {
 public:
  explicit AnyAngle(const Grid2& lattice);

  /// From one point to another, over corners of obstacles; empty if there is none. Both are centres of cells, or both
  /// corners (Visibility::set_ends).
  [[nodiscard]] Path shortest(HalfPoint from, HalfPoint to);
  /// Points taken from the list, since it was made.
  [[nodiscard]] std::int64_t expansions() const { return expansions_; }

 private:
  /// What is known of a point.
  struct Reached {
    double g = 0;
    std::uint32_t parent = 0;
    std::uint32_t search = 0;
    bool done = false;
  };
  struct Entry {
    double f, g;
    std::uint32_t point;
    friend bool operator>(const Entry& a, const Entry& b) {
      return a.f != b.f ? a.f > b.f : a.g != b.g ? a.g < b.g : a.point > b.point;
    }
  };

  [[nodiscard]] double distance(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Path path() const;
  void search();
  void offer(std::uint32_t from, std::uint32_t to);

  const Grid2& lattice_;
  Visibility graph_{lattice_};
  std::vector<Reached> points_;
  std::vector<Entry> open_;
  std::uint32_t search_ = 0;
  std::int64_t expansions_ = 0;
};

}  // namespace replan
