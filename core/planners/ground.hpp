// What a search knows of the whole map besides its moves: how near obstacles are, and what lines of sight pass over.
#pragma once

#include <cstdint>
#include <span>

#include "core/field/clearance.hpp"
#include "core/lattice/sight.hpp"
#include "core/lattice/sight_map.hpp"
#include "core/plan/common_parameters.hpp"

namespace replan {

/// The lattice's penalties, if the planner has clearance on, and a map for sight checks, if they are so many that
/// it pays. Both follow the changes of the lattice.
template <class L>
class Ground {
 public:
  /// `clearance` makes the penalty's rules of the settings, as PlannerInfo::clearance: null if none is paid.
  Ground(const L& lattice, const Settings& settings, ClearanceRules (*clearance)(const Settings&),
         bool many_checks)
      : lattice_(lattice),
        rules_(clearance != nullptr ? clearance(settings) : ClearanceRules{}),
        sight_rule_(static_cast<SightRule>(settings.get(parameters::kSight))),
        clearance_on_(clearance != nullptr),
        many_checks_(many_checks) {}

  [[nodiscard]] Cost dist(NodeId s) const { return clearance_on_ ? clearance_.penalty(s) : Cost::zero(); }
  /// For sight a cell is bad if it is an obstacle or, with clearance on, dist != 0.
  [[nodiscard]] bool bad(NodeId c) const { return clearance_on_ ? clearance_.near(c) : lattice_.blocked(c); }
  [[nodiscard]] bool sees(NodeId a, NodeId b) const {
    const auto is_bad = [this](NodeId c) { return bad(c); };
    return many_checks_ ? line_of_sight(lattice_, sight_rule_, a, b, is_bad, sight_map_)
                        : line_of_sight(lattice_, sight_rule_, a, b, is_bad);
  }

  /// Of the lattice as it is; made anew only if that has changed untold. `note(n, before, after)` hears what
  /// dist comes to where there is clearance.
  template <class Note>
  void make(Note&& note) {
    if (revision_ == lattice_.revision()) return;
    if (!clearance_on_) return make();
    const ClearanceField<L::kDimensions> before = std::move(clearance_);
    make();
    for (NodeId n = 0; n < lattice_.node_count(); ++n)
      note(n, before.empty() ? Cost::zero() : before.penalty(n), dist(n));
  }
  void make() {
    revision_ = lattice_.revision();
    if (clearance_on_) clearance_ = ClearanceField<L::kDimensions>(lattice_, rules_);
    if (many_checks_) sight_map_ = SightMap<L::kDimensions>(lattice_, [this](NodeId c) { return bad(c); });
  }

  /// The lattice shows these edits already. Returns where dist has changed, valid until the next call.
  std::span<const ClearanceChange> update(std::span<const CellEdit> edits) {
    revision_ = lattice_.revision();
    if (!clearance_on_) {
      for (const CellEdit& edit : edits) turn(edit.node, edit.blocked);
      return {};
    }
    const auto changes = clearance_.update(lattice_, edits);
    for (const ClearanceChange& change : changes)
      if (turned(change)) turn(change.node, bad(change.node));
    return changes;
  }
  /// Whether the cell has become bad for sight, or good.
  [[nodiscard]] bool turned(const ClearanceChange& change) const {
    return change.before == Cost::zero() || !bad(change.node);
  }

  [[nodiscard]] SightRule sight_rule() const { return sight_rule_; }
  [[nodiscard]] std::size_t memory_bytes() const {
    return clearance_.memory_bytes() + sight_map_.memory_bytes();
  }

 private:
  void turn(NodeId cell, bool is_bad) {
    if (many_checks_) sight_map_.change(lattice_.coordinates(cell), is_bad);
  }

  const L& lattice_;
  ClearanceRules rules_;
  SightRule sight_rule_;
  bool clearance_on_, many_checks_;
  ClearanceField<L::kDimensions> clearance_;
  SightMap<L::kDimensions> sight_map_;
  std::uint64_t revision_ = 0;  // of the lattice that both are of; 0: none
};

}  // namespace replan
