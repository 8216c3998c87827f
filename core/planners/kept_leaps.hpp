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

/// Leaps, one from a vertex, each with the box of cells that its two ends span. They stand in groups with a
/// box around each: those of a path come one after another, so that a change meets few groups.
template <std::size_t D>
class KeptLeaps {
 public:
  using Place = std::array<int, D>;

  [[nodiscard]] std::size_t size() const { return size_; }
  void clear();
  void add(Leap leap, const Place& from, const Place& to);
  /// Takes out the one that begins at a vertex and its place.
  void remove(NodeId from, const Place& place);
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
    [[nodiscard]] bool holds(const Place& place) const { return meets({place, place}); }
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

  Group& group_for(const Place& from);
  template <class Condition>
  void take_if(Group& group, Condition&& condition, std::vector<Leap>& taken);
  void finish_taking(std::vector<Leap>& taken);

  std::vector<Group> groups_;
  std::size_t size_ = 0;
};

}  // namespace replan
