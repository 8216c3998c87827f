// The values of a run that belong to no node, as planners keep them that grow trees or breed paths.
#pragma once

#include <array>
#include <cstdint>

#include "core/space/place.hpp"
#include "core/trace/search_state.hpp"
#include "core/trace/tracer.hpp"

namespace replan {

/// Values of a run, told to the tracer whenever they change.
template <Tracer T>
class RunNumbers {
 public:
  explicit RunNumbers(T& tracer) : tr_(tracer) {}

  [[nodiscard]] std::uint64_t get(Scalar which) const { return held_[static_cast<std::size_t>(which)]; }
  void set(Scalar which, std::uint64_t value) {
    std::uint64_t& held = held_[static_cast<std::size_t>(which)];
    tr_.change(which, held, value);
    held = value;
  }
  /// A node, a vertex or a path, held as its number + 1.
  [[nodiscard]] std::uint32_t number(Scalar which) const {
    return static_cast<std::uint32_t>(get(which)) - 1u;
  }
  void set_number(Scalar which, std::uint32_t number) { set(which, std::uint64_t{number + 1u}); }
  /// How many of something there are.
  [[nodiscard]] std::int64_t count(Scalar which) const { return static_cast<std::int64_t>(get(which)); }
  void set_count(Scalar which, std::int64_t count) { set(which, static_cast<std::uint64_t>(count)); }
  /// A finite one.
  [[nodiscard]] Cost cost(Scalar which) const { return {static_cast<std::int64_t>(get(which))}; }
  void set_cost(Scalar which, Cost cost) { set(which, static_cast<std::uint64_t>(cost.raw)); }
  /// In units of places.
  void set_length(Scalar which, std::int64_t units) { set(which, coordinate_bits(units)); }
  /// The scalars from `first` on hold its coordinates, two in a plane and three in space.
  template <int D>
  void set_place(Scalar first, const Place& place) {
    for (std::size_t i = 0; i < D; ++i)
      set_length(static_cast<Scalar>(static_cast<std::size_t>(first) + i), place[i]);
  }

  /// As the log's state shows them.
  void restore(const SearchState& state) {
    for (std::size_t i = 0; i < held_.size(); ++i) held_[i] = state.scalar(static_cast<Scalar>(i));
  }

 private:
  T& tr_;
  std::array<std::uint64_t, static_cast<std::size_t>(Scalar::count)> held_{};
};

}  // namespace replan
