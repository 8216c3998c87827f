// Smoothing by a uniform cubic B-spline whose control points are the path's points, as the AUV paper smooths its paths:
//
//  Zhu X., Sun B. & Zhu D., "Three-dimensional dynamic path planning of AUV based on improved D* algorithm", Control
//  Engineering of China 28(4), 2021, doi 10.14107/j.cnki.kzgc.20190179
//
// What the paper leaves open, and what holds here:
//  * Both ends are met by phantom points, the second and the last point but one reflected at them.
//  * What comes out is the curve, sampled: each span, from near one control point to near the next, at equal steps of its
//    parameter. All is worked out in whole numbers, points in 1 / 16384 of a cell, so every machine draws the same curve,
//    and straight ways stay straight.
//  * Each piece of it is held against the robot's map (core/lattice/body_way.hpp). Where one hits something, points are put
//    in half way along the legs that its span is drawn from, and the curve is drawn again: halved legs halve how far it
//    leaves its control polygon. Legs shorter than a quarter of a cell get corners that the curve keeps: control points
//    that count three times. Where that is not enough, the path's own leg is taken as it is. So the curve ends, at worst,
//    as the path itself; and it is free by check, wherever it was pulled in.
//  * A path whose own legs do not pass the check is left alone: along drawn lines (sight `bresenham`), or unchecked.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "core/lattice/body_way.hpp"
#include "core/plan/stage.hpp"
#include "core/stages/collinear.hpp"

namespace replan {

namespace parameters {

inline const Parameter kSplineSamples{
    .key = "samples",
    .label = "Samples",
    .type = ParameterType::whole,
    .initial = 8,
    .low = 1,
    .high = 32,
    .help = "Straight pieces that the curve is made of, for each span between two control points."};
inline const Parameter kSplineCorners{.key = "corners_only",
                                      .label = "Leave out straight points",
                                      .type = ParameterType::toggle,
                                      .help =
                                          "Whether the points at which the path goes straight on are left "
                                          "out first. The curve is wider then, and more "
                                          "often pulled in."};

}  // namespace parameters

/// The curve over a path that is free, on a map that the robot knows.
template <int D>
class SplineDrawing {
 public:
  SplineDrawing(const BoxLattice<D>& known, const Path& polygon, int samples)
      : known_(known), samples_(samples) {
    for (std::size_t i = 0; i < polygon.size();
         ++i)  // a point that comes twice would make a leg of no length
      if (const Place at = BoxGap::place_of(polygon.point(i)); i == 0 || at != corners_.back().at)
        corners_.push_back({at, corners_.size()});
    locked_.resize(corners_.size());
  }

  /// Whether all legs are free.
  [[nodiscard]] bool polygon_is_free() const {
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i)
      if (hit_on_way(known_, point_of(corners_[i].at), point_of(corners_[i + 1].at))) return false;
    return true;
  }

  /// The curve with what it was drawn from. Each round divides a leg, keeps a corner or locks a leg, none of which goes
  /// on for ever.
  [[nodiscard]] Path draw() {
    while (!all_free()) refine();
    std::vector<Point> points = {point_of(corners_.front().at)};
    each_span([&](const Span& span) {
      sample(span, [&](const Place& at) {
        if (const Point point = point_of(at); point != points.back()) points.push_back(point);
      });
    });
    Path path(std::move(points));
    path.spline.emplace();
    for (const Corner& corner : corners_) path.spline->control.push_back(point_of(corner.at));
    path.spline->pulled_in = std::move(pulled_in_);
    return path;
  }

 private:
  using Place = BoxGap::Place;
  static constexpr std::int64_t kShortest = BoxGap::kUnits / 4;  // of the legs that are divided
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// A control point.
  struct Corner {
    Place at{};
    std::size_t leg = 0;       // the path's leg that it begins or lies on
    std::size_t pull = kNone;  // the pull-in that it belongs to
    bool put_in = false;       // by a pull-in
    bool kept = false;         // the curve goes through it
    bool divides = false;      // the leg that begins here is to be divided
    bool fresh = true;         // its spans have yet to be checked
  };
  /// Four control points, by their indices among the corners, and where they are: phantoms are no corners.
  struct Span {
    std::array<std::size_t, 4> corners{};
    std::array<Place, 4> at{};
  };

  static Point point_of(const Place& at) {
    const auto in_cells = [](std::int64_t units) { return static_cast<double>(units) / BoxGap::kUnits; };
    return {in_cells(at[0]), in_cells(at[1]), in_cells(at[2])};
  }

  /// Calls visit(span) for each in turn.
  template <class Visit>
  void each_span(Visit&& visit) const {
    std::vector<std::size_t> knots;  // a corner that is kept comes three times
    for (std::size_t i = 0; i < corners_.size(); ++i) knots.insert(knots.end(), corners_[i].kept ? 3 : 1, i);
    const auto reflected = [&](std::size_t end, std::size_t next) {
      Place at{};
      for (std::size_t i = 0; i < at.size(); ++i) at[i] = 2 * corners_[end].at[i] - corners_[next].at[i];
      return at;
    };
    const std::size_t last = knots.size() - 1;
    for (std::size_t k = 0; k < last; ++k) {
      Span span{{knots[k == 0 ? 0 : k - 1], knots[k], knots[k + 1], knots[std::min(k + 2, last)]}, {}};
      for (std::size_t i = 0; i < 4; ++i) span.at[i] = corners_[span.corners[i]].at;
      if (k == 0) span.at[0] = reflected(knots[0], knots[1]);
      if (k + 1 == last) span.at[3] = reflected(knots[last], knots[last - 1]);
      visit(span);
    }
  }

  /// Whether the span runs along a leg between two corners that are kept, so that it is straight.
  [[nodiscard]] bool straight(const Span& span) const {
    const std::size_t first = span.corners.front(), last = span.corners.back();
    return last - first <= 1 && corners_[first].kept && corners_[last].kept;
  }

  /// Calls visit(place) for the ends of the straight pieces of a span. Of a straight one it is the leg's alone.
  template <class Visit>
  void sample(const Span& span, Visit&& visit) const {
    if (straight(span)) {
      if (span.corners[1] == span.corners[3]) visit(span.at[3]);
      return;
    }
    const std::int64_t m = samples_, whole = 6 * m * m * m;
    for (std::int64_t k = 1; k <= m; ++k) {
      const std::int64_t back = m - k;
      const std::array<std::int64_t, 4> weights = {
          back * back * back, 3 * k * k * k - 6 * k * k * m + 4 * m * m * m,
          3 * back * back * back - 6 * back * back * m + 4 * m * m * m, k * k * k};
      Place at{};
      for (std::size_t axis = 0; axis < at.size(); ++axis) {
        std::int64_t sum = whole / 2;  // to the nearest unit
        for (std::size_t i = 0; i < 4; ++i) sum += weights[i] * span.at[i][axis];
        at[axis] = sum / whole;
      }
      visit(at);
    }
  }

  /// Checks the spans that are new, and marks the legs of those that hit something.
  bool all_free() {
    bool free = true;
    Place from = corners_.front().at;
    std::vector<std::pair<Span, PullIn>> hits;
    each_span([&](const Span& span) {
      const bool fresh = std::any_of(span.corners.begin(), span.corners.end(),
                                     [&](std::size_t corner) { return corners_[corner].fresh; });
      std::optional<Cell> hit;
      Point at;
      sample(span, [&](const Place& to) {
        if (fresh && !hit && !is_leg(span)) {
          hit = hit_on_way(known_, point_of(from), point_of(to));
          at = point_of(from);
        }
        from = to;
      });
      if (hit) hits.push_back({span, {at, *hit}});
    });
    for (Corner& corner : corners_) corner.fresh = false;
    for (const auto& [span, pull] : hits) {
      free = false;
      mark(span, pull);
    }
    return free;
  }
  /// Whether a span is one of the path's own legs, which are free.
  [[nodiscard]] bool is_leg(const Span& span) const {
    return straight(span) && !corners_[span.corners.front()].put_in && !corners_[span.corners.back()].put_in;
  }

  void mark(const Span& span, const PullIn& pull) {
    std::size_t id = kNone;
    for (const std::size_t corner : span.corners)
      if (const std::size_t other = corners_[corner].pull;
          other != kNone && near(pulled_in_[other].cell, pull.cell))
        id = other;
    if (id == kNone) {
      id = pulled_in_.size();
      pulled_in_.push_back(pull);
    }
    for (const std::size_t corner : span.corners) corners_[corner].pull = id;
    for (std::size_t corner = span.corners.front(); corner < span.corners.back(); ++corner)
      corners_[corner].divides = true;
  }
  static bool near(const Cell& a, const Cell& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) <= 2;
  }

  /// Puts points in along the marked legs, or keeps their ends, or locks the path's leg that they lie on.
  void refine() {
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
      if (!corners_[i].divides || length(i) > kShortest) continue;
      if (corners_[i].kept && corners_[i + 1].kept) locked_[corners_[i].leg] = true;
      for (Corner* end : {&corners_[i], &corners_[i + 1]}) end->fresh |= !std::exchange(end->kept, true);
    }
    std::vector<Corner> refined;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      Corner corner = corners_[i];
      const bool locked = locked_[corner.leg], divides = std::exchange(corner.divides, false) && !locked;
      if (locked && corner.put_in) continue;
      const bool ends_locked = locked || (corner.leg > 0 && !corner.put_in && locked_[corner.leg - 1]);
      if (ends_locked && !std::exchange(corner.kept, true)) corner.fresh = true;
      refined.push_back(corner);
      if (divides && length(i) > kShortest) refined.push_back(half_way(i));
    }
    corners_ = std::move(refined);
  }
  /// Along the longest axis.
  [[nodiscard]] std::int64_t length(std::size_t leg) const {
    std::int64_t most = 0;
    for (std::size_t i = 0; i < 3; ++i)
      most = std::max(most, std::abs(corners_[leg + 1].at[i] - corners_[leg].at[i]));
    return most;
  }
  [[nodiscard]] Corner half_way(std::size_t leg) const {
    Corner middle{{}, corners_[leg].leg, corners_[leg].pull, true};
    for (std::size_t i = 0; i < 3; ++i) middle.at[i] = (corners_[leg].at[i] + corners_[leg + 1].at[i]) / 2;
    return middle;
  }

  const BoxLattice<D>& known_;
  int samples_;
  std::vector<Corner> corners_;
  std::vector<bool> locked_;  // the path's legs that stay as they are
  std::vector<PullIn> pulled_in_;
};

struct BSpline {
  static StageInfo describe() {
    return {.name = "B-spline",
            .summary = "Rounds the path to a curve, and pulls it in where the curve would hit something.",
            .source = "Zhu, Sun & Zhu 2021, doi 10.14107/j.cnki.kzgc.20190179",
            .parameters = {parameters::kSplineSamples, parameters::kSplineCorners}};
  }

  template <class L>
  static Path apply(const L& known, Path path, const Settings& settings) {
    if (path.size() < 3 || path.loops) return path;
    Path polygon = path;
    if (settings.get(parameters::kSplineCorners) != 0)
      polygon = Collinear::apply(known, std::move(polygon), settings);
    SplineDrawing<L::kDimensions> drawing(known, polygon,
                                          static_cast<int>(settings.get(parameters::kSplineSamples)));
    if (!drawing.polygon_is_free()) return path;
    Path curve = drawing.draw();
    curve.unchecked = path.unchecked;
    return curve;
  }
};

}  // namespace replan
