// What planners keep that breed paths, and write down in its log: the paths of a population, and the one that is being bred.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/plan/population_values.hpp"
#include "core/planners/run_numbers.hpp"

namespace replan {

/// Every write goes through a function that tells the tracer. One of the paths is no member but the child's: where a child
/// becomes a member, the path that leaves gives its room to the next one.
template <Tracer T>
class Population {
 public:
  Population(RunNumbers<T>& numbers, T& tracer) : numbers_(numbers), tr_(tracer) {}

  /// Paths, the child's among them; 0 before the first.
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(members_.size()); }
  [[nodiscard]] const BredPath& path(std::uint32_t i) const { return members_[i].path; }
  [[nodiscard]] const Unfitness& unfitness(std::uint32_t i) const { return members_[i].unfitness; }
  [[nodiscard]] std::uint32_t child() const { return numbers_.number(Scalar::child); }
  [[nodiscard]] bool is_member(std::uint32_t i) const { return i != child(); }

  /// Room for so many members and a child.
  void make_room(std::uint32_t members) {
    members_.resize(members + 1);
    numbers_.set_count(Scalar::paths, count());
    numbers_.set_number(Scalar::child, members);
  }
  /// Forgets all. The log tells of it by an epoch, which is its owner's to write.
  void clear() {
    members_.clear();
    numbers_.set_count(Scalar::paths, 0);
    numbers_.set(Scalar::child, 0);
  }
  void write(std::uint32_t i, const BredPath& path) {
    BredPath& held = members_[i].path;
    for (std::size_t at = 0; at < std::max(held.size(), path.size()); ++at) {
      const PathPlace before = at < held.size() ? held[at] : PathPlace{},
                      after = at < path.size() ? path[at] : PathPlace{};
      tell(fields::kPathCell, place_of_path(i, at), before.cell, after.cell);
      tell(fields::kPathHit, place_of_path(i, at), before.hit, after.hit);
    }
    held = path;
  }
  void set_cost(std::uint32_t i, Cost cost) {
    tr_.change(fields::kPathCost.kind, i, members_[i].unfitness.cost, cost);
    members_[i].unfitness = {hits_something(path(i)), cost};
  }
  /// The child becomes a member in the place of that one.
  void take_in_for(std::uint32_t leaves) { numbers_.set_number(Scalar::child, leaves); }

  /// The fittest and the least fit member; of equals the one with the smaller number.
  [[nodiscard]] std::uint32_t fittest() const {
    return extreme([](const Unfitness& a, const Unfitness& b) { return a < b; });
  }
  [[nodiscard]] std::uint32_t least_fit() const {
    return extreme([](const Unfitness& a, const Unfitness& b) { return b < a; });
  }
  /// Whether some member is the same path as the child.
  [[nodiscard]] bool has_twin() const {
    for (std::uint32_t i = 0; i < count(); ++i)
      if (is_member(i) && path(i) == path(child())) return true;
    return false;
  }
  [[nodiscard]] Cost mean_cost() const {
    std::int64_t sum = 0;
    const auto members = static_cast<std::int64_t>(count()) - 1;
    for (std::uint32_t i = 0; i < count(); ++i)
      if (is_member(i)) sum += unfitness(i).cost.raw / members;
    return {sum};
  }
  [[nodiscard]] std::size_t memory_bytes() const {
    std::size_t bytes = members_.capacity() * sizeof(Member);
    for (const Member& member : members_) bytes += member.path.capacity() * sizeof(PathPlace);
    return bytes;
  }

  /// As the log's state shows it.
  void restore(const SearchState& state) {
    members_.clear();
    for (std::uint32_t i = 0; i < path_count(state); ++i) {
      BredPath path = bred_path(state, i);
      const bool hits = hits_something(path);
      members_.push_back({std::move(path), {hits, path_cost(state, i)}});
    }
  }

 private:
  struct Member {
    BredPath path;
    Unfitness unfitness;
  };

  template <class Before>
  [[nodiscard]] std::uint32_t extreme(Before before) const {
    std::uint32_t found = kNoNode;
    for (std::uint32_t i = 0; i < count(); ++i)
      if (is_member(i) && (found == kNoNode || before(unfitness(i), unfitness(found)))) found = i;
    return found;
  }
  void tell(const Field& field, NodeId at, NodeId before, NodeId after) {
    tr_.change(field.kind, at, std::uint64_t{before + 1u}, std::uint64_t{after + 1u});
  }

  RunNumbers<T>& numbers_;
  T& tr_;
  std::vector<Member> members_;
};

}  // namespace replan
