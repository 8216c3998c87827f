// Points of a continuous world in whole numbers: what grows among them grows alike on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/cost.hpp"
#include "core/base/point.hpp"
#include "core/lattice/body_way.hpp"

namespace replan {

/// x, y, z in units of 1 / 16384 of a cell, in which ways are held against obstacles too (core/lattice/body_way.hpp). In
/// a plane z is that of the middle of its only layer.
using Place = BoxGap::Place;

inline constexpr std::int64_t kPlaceUnits = BoxGap::kUnits;

inline Point point_of(const Place& place) {
  const auto cells = [](std::int64_t units) { return static_cast<double>(units) / kPlaceUnits; };
  return {cells(place[0]), cells(place[1]), cells(place[2])};
}

inline Place place_in(const Cell& cell) {
  return BoxGap::place_of(centre_of(cell));
}

/// In units, squared.
inline std::int64_t squared_between(const Place& a, const Place& b) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (b[i] - a[i]) * (b[i] - a[i]);
  return sum;
}

/// How long the straight way between two places is, to the nearest 2^-30 of a cell but for what a double cannot hold.
inline Cost length_between(const Place& a, const Place& b) {
  constexpr double kPerUnit = static_cast<double>(Cost::kScale) / kPlaceUnits;
  return {std::llround(std::sqrt(static_cast<double>(squared_between(a, b))) * kPerUnit)};
}

/// A coordinate as costs are counted, for logs.
constexpr std::uint64_t coordinate_bits(std::int64_t units) {
  return static_cast<std::uint64_t>(units * (Cost::kScale / kPlaceUnits));
}
constexpr std::int64_t units_of(std::uint64_t bits) {
  return static_cast<std::int64_t>(bits) / (Cost::kScale / kPlaceUnits);
}

}  // namespace replan
