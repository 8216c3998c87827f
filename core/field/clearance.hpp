// What coming near obstacles costs: a penalty for each cell by its distance d to the nearest obstacle, along one of two
// curves. Beyond the range r it is 0; within it
//
//  linear  dist(s) = r - d + 1: the DLD* Lite paper (Huang & Zhou 2018, doi 10.13195/j.kzyjc.2018.0583,
//          definitions 1-3)
//  threat  j(X) = c e^-(d - r_min), and c for d <= r_min, where cells may be impassable instead: the AUV paper (Zhu, Sun
//          & Zhu 2021, doi 10.14107/j.cnki.kzgc.20190179), which calls the range r_max and measures exactly
//
// What is settled here: only obstacles within r matter, so d is kept as a rank in the short list of
// distances that occur within r: one byte per node. The two-pass chamfer transform with weights 1 and sqrt 2
// gives the octile distance to the nearest obstacle, exactly, so taking the nearest obstacle of a stencil
// ordered by distance gives the same numbers; it works alike for the exact Euclidean distance, in 2D and in
// 3D, and locally: a removed obstacle is forgotten by looking again at the nodes around it (as printed,
// DistanceTransformLocal only takes the larger penalty and can never forget one). Of the threat, costs being
// in fixed point, the nearest unit of 2^-30 is taken.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/lattice/box_lattice.hpp"

namespace replan {

/// How the distance to the nearest obstacle is measured.
enum class Transform : std::uint8_t {
  chamfer,    ///< weights 1 and sqrt 2 (and sqrt 3 in 3D): the paper's
  euclidean,  ///< exact, centre to centre
};

/// The threat curve's shape within the range.
struct ThreatCurve {
  double c = 5;             ///< what a cell costs at r_min and nearer, 0.1 to kMostThreat
  double r_min = 1;         ///< in cells, 0 to the range
  bool impassable = false;  ///< up to r_min a cell costs infinitely much instead
  static constexpr double kMostThreat = 20;
  friend bool operator==(const ThreatCurve&, const ThreatCurve&) = default;
};

struct ClearanceRules {
  double range = 2;  ///< r (of a threat: r_max) in cells, 1 to kMaxRange
  Transform transform = Transform::chamfer;
  bool border_is_obstacle = false;         ///< the cells just outside the map count as obstacles
  std::optional<ThreatCurve> threat = {};  ///< none: the linear curve
  static constexpr double kMaxRange = 12;
  friend bool operator==(const ClearanceRules&, const ClearanceRules&) = default;
};

/// A node whose penalty changed, and what it was.
struct ClearanceChange {
  NodeId node;
  Cost before;
};

/// The penalties of all nodes of a lattice.
template <int D>
class ClearanceField {
 public:
  ClearanceField() = default;
  ClearanceField(const BoxLattice<D>& lattice, ClearanceRules rules);

  /// True before it was made of a lattice.
  [[nodiscard]] bool empty() const { return ranks_.empty(); }
  /// dist(s), or j(X): what entering the node costs besides. Of an obstacle cell: the largest penalty.
  [[nodiscard]] Cost penalty(NodeId node) const { return penalties_[ranks_[node]]; }
  /// True if the penalty is not 0.
  [[nodiscard]] bool near(NodeId node) const { return ranks_[node] != kFar; }
  [[nodiscard]] std::span<const std::uint8_t> ranks() const { return ranks_; }

  /// Takes in changed cells that the lattice shows already. Returns the nodes whose penalty changed, each
  /// once, valid until the next call.
  std::span<const ClearanceChange> update(const BoxLattice<D>& lattice, std::span<const CellEdit> edits);

  [[nodiscard]] std::size_t memory_bytes() const { return ranks_.capacity() + noted_.capacity(); }

 private:
  static constexpr std::uint8_t kFar = 255;
  struct Offset {
    std::array<int, D> by;
    std::int32_t delta;
    std::uint8_t rank;
  };

  static constexpr std::size_t kFewOffsets = 64;

  void prepare(const BoxLattice<D>& lattice);
  void gather(const BoxLattice<D>& lattice);
  void transform(const BoxLattice<D>& lattice);
  void scatter(const BoxLattice<D>& lattice);
  static bool is_inside(const BoxLattice<D>& lattice, const typename BoxLattice<D>::Coordinates& at,
                        int margin);
  [[nodiscard]] bool is_inner(const BoxLattice<D>& lattice, NodeId node) const;
  [[nodiscard]] std::uint8_t rank_of(const BoxLattice<D>& lattice, NodeId node) const;
  void lower(NodeId node, std::uint8_t rank);
  void note(NodeId node);
  template <class Visit>
  void for_stencil(const BoxLattice<D>& lattice, NodeId node, Visit&& visit) const;

  ClearanceRules rules_;
  int reach_ = 0;                // the stencil's half width
  std::vector<Offset> stencil_;  // by growing distance
  std::vector<Cost> penalties_;  // by rank
  std::vector<std::uint8_t> ranks_;
  std::vector<std::uint8_t> noted_;  // 1 while a node is among changes_
  std::vector<ClearanceChange> changes_;
};

extern template class ClearanceField<2>;
extern template class ClearanceField<3>;

}  // namespace replan
