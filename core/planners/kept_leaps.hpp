// Leaps of paths that were read out, and which of them a change of the map may concern (sight_along.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/cell.hpp"

namespace replan {

/// Two vertices that see each other.
struct Leap {
  NodeId from, to;
};

/// Leaps, each with the box of cells that its two ends span. They stand in groups with a box around each, in
/// the order in which they came: those of a path lie side by side, so that a change meets few groups.
template <std::size_t D>
class KeptLeaps {
 public:
  using Place = std::array<int, D>;

  void clear() { groups_.clear(); }
  void add(Leap leap, const Place& from, const Place& to);
  /// Takes out the leaps with one of the places in their box, and returns them by index.
  [[nodiscard]] std::vector<Leap> take_touched(std::span<const Place> places);
  /// Takes out the leaps that begin at no vertex of the path, and returns them by index.
  [[nodiscard]] std::vector<Leap> take_others(std::vector<NodeId> path);
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  /// The cells between two corners, both included.
  struct Extent {
    Place low, high;
    [[nodiscard]] bool meets(const Extent& other) const;
    void take_in(const Place& place);
  };
  struct Boxed {
    Leap leap;
    Extent extent;
  };
  struct Group {
    Extent extent;
    std::vector<Boxed> leaps;
  };
  static constexpr std::size_t kGroup = 32;

  std::vector<Group> groups_;
};

}  // namespace replan
