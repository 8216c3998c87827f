// Smoothing by what is called Floyd's algorithm in
//
//  Liu J., Xue L., Zhang H. & Liu Z., "Robot dynamic path planning based on improved A* and DWA algorithm" (Henan
//  University of Technology)
//
// First all points at which the path goes straight on are left out. Then, from the start on, each point that is kept
// is joined to the farthest later one from which no obstacle cell's centre is D or nearer to the segment, and the
// points between are left out. Two neighbouring turns of the path stay joined however near an obstacle is.
//
// Settled here: a segment must also be a line of sight under the path's own rule. With D above half a cell's diagonal
// (0.71, in space 0.87) that follows; with less a segment could cut an obstacle's corner. Between lattice nodes
// distances are compared in whole numbers, D being taken in millionths of a cell; between other points in doubles, and
// for a robot with a size nothing is joined there: what a centre must keep away from is known of cells' centres alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/lattice/body_way.hpp"
#include "core/lattice/sight.hpp"
#include "core/plan/stage.hpp"
#include "core/stages/collinear.hpp"

namespace replan {

namespace parameters {

inline const Parameter kSafetyDistance{
    .key = "distance",
    .label = "Safety distance",
    .type = ParameterType::real,
    .initial = 0.8,
    .low = 0,
    .high = 100,
    .unit = "cells",
    .help = "How far from the centre of every obstacle cell a new segment must stay: farther than this."};

}  // namespace parameters

struct Floyd {
  static StageInfo describe() {
    return {
        .name = "Floyd smoothing",
        .summary = "Joins each turn to the farthest later one with a straight way that keeps its distance.",
        .source = "Liu, Xue, Zhang & Liu, robot dynamic path planning: improved A* fused with DWA",
        .parameters = {parameters::kSafetyDistance}};
  }

  template <class L>
  static Path apply(const L& known, Path path, const Settings& settings) {
    path = Collinear::apply(known, std::move(path), settings);
    const double distance = settings.get(parameters::kSafetyDistance);
    std::vector<bool> kept(path.size());
    for (std::size_t i = 0; i < path.size();) {
      kept[i] = true;
      std::size_t next = path.size() - 1;
      while (next > i + 1 && !joins(known, path, i, next, distance)) --next;
      i = std::max(next, i + 1);
    }
    path.keep_if([&kept](std::size_t i) { return kept[i]; });
    return path;
  }

 private:
  static constexpr std::int64_t kParts = 1'000'000;  // of a cell

  template <int D>
  static bool joins(const BoxLattice<D>& known, const Path& path, std::size_t i, std::size_t k,
                    double distance) {
    if (path.nodes().empty()) {
      if (known.has_size()) return false;
      const Point a = path.point(i), b = path.point(k);
      return !hit_on_way(known, a, b) &&
             keeps_away<D>(known, place<D>(a), place<D>(b), distance, [&](const auto& centre) {
               return farther(place<D>(a), place<D>(b), centre, distance * distance, 1.0);
             });
    }
    __extension__ using Wide = __int128;
    const NodeId a = path.nodes()[i], b = path.nodes()[k];
    const auto bad = [&known](NodeId c) { return known.blocked(c); };
    if (!line_of_sight(known, path.sight(), a, b, bad, NoSightMap{})) return false;
    const auto from = whole<D>(known.coordinates(a)), to = whole<D>(known.coordinates(b));
    const auto parts = static_cast<Wide>(std::llround(distance * kParts));
    return keeps_away<D>(known, centre<D>(from), centre<D>(to), distance, [&](const auto& at) {
      return farther(from, to, whole<D>(at), parts * parts, static_cast<Wide>(kParts) * kParts);
    });
  }

  template <int D>
  using Whole = std::array<std::int64_t, D>;
  template <int D>
  using Real = std::array<double, D>;

  template <int D>
  static Whole<D> whole(const typename BoxLattice<D>::Coordinates& at) {
    Whole<D> result{};
    std::copy(at.begin(), at.end(), result.begin());
    return result;
  }
  /// By cells' indices: the centre of cell (x, y) is (x, y).
  template <int D>
  static Real<D> centre(const Whole<D>& at) {
    Real<D> result{};
    for (std::size_t axis = 0; axis < D; ++axis) result[axis] = static_cast<double>(at[axis]);
    return result;
  }
  template <int D>
  static Real<D> place(const Point& point) {
    const std::array<double, 3> all = {point.x - 0.5, point.y - 0.5, point.z - 0.5};
    Real<D> result{};
    std::copy_n(all.begin(), D, result.begin());
    return result;
  }

  /// Whether the point c is farther from the segment from a to b than the root of `squared` / `scale`.
  template <class Vector, class At, class Number>
  static bool farther(const Vector& a, const Vector& b, const At& c, Number squared, Number scale) {
    Number length = 0, along = 0, to_a = 0, to_b = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
      const auto at = static_cast<typename Vector::value_type>(c[axis]);
      length += Number(b[axis] - a[axis]) * (b[axis] - a[axis]);
      along += Number(at - a[axis]) * (b[axis] - a[axis]);
      to_a += Number(at - a[axis]) * (at - a[axis]);
      to_b += Number(at - b[axis]) * (at - b[axis]);
    }
    if (along <= 0) return to_a * scale > squared;
    if (along >= length) return to_b * scale > squared;
    // Its square's part across the segment, times the segment's: |c - a|^2 |b - a|^2 - ((c - a) (b - a))^2.
    return (to_a * length - along * along) * scale > squared * length;
  }

  /// Asks `far(centre)` of every obstacle cell that may be no farther from the segment than that. Along the segment's
  /// longest axis the others go no faster than one cell for each: a centre so near lies within twice the distance,
  /// along each of them, of where the segment is at its own place or nearest to it.
  template <int D, class Far>
  static bool keeps_away(const BoxLattice<D>& known, const Real<D>& a, const Real<D>& b, double distance,
                         Far&& far) {
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < D; ++axis)
      if (std::abs(b[axis] - a[axis]) > std::abs(b[longest] - a[longest])) longest = axis;
    const double begin = a[longest], end = b[longest], way = end - begin;
    const int reach = static_cast<int>(std::ceil(distance)) + 1,
              beside = static_cast<int>(std::ceil(2 * distance)) + 1;
    const int first = std::max(static_cast<int>(std::floor(std::min(begin, end))) - reach, 0);
    const int last =
        std::min(static_cast<int>(std::ceil(std::max(begin, end))) + reach, known.size()[longest] - 1);
    for (int at = first; at <= last; ++at) {
      const double share = way == 0 ? 0 : std::clamp((at - begin) / way, 0.0, 1.0);
      typename BoxLattice<D>::Coordinates low{}, high{};
      for (std::size_t axis = 0; axis < D; ++axis) {
        const int middle = static_cast<int>(std::lround(a[axis] + share * (b[axis] - a[axis])));
        low[axis] = axis == longest ? at : std::max(middle - beside, 0);
        high[axis] = axis == longest ? at : std::min(middle + beside, known.size()[axis] - 1);
      }
      if (!all_far<D>(known, low, high, far)) return false;
    }
    return true;
  }

  template <int D, class Far>
  static bool all_far(const BoxLattice<D>& known, const typename BoxLattice<D>::Coordinates& low,
                      const typename BoxLattice<D>::Coordinates& high, Far&& far) {
    for (auto at = low;;) {
      if (known.blocked(known.node(at)) && !far(at)) return false;
      std::size_t axis = 0;
      for (; axis < D && at[axis] == high[axis]; ++axis) at[axis] = low[axis];
      if (axis == D) return true;
      ++at[axis];
    }
  }
};

}  // namespace replan
