// A run's values as its log tells them, laid out for holding them against laws: those of a vertex side by
// side, in pages that exist only where something was written.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/field/clearance.hpp"

namespace replan {

/// What the log says of a vertex, as events hold it, and what came of the laws there.
struct LawVertex {
  Cost g = Cost::infinity();
  Cost rhs = Cost::infinity();
  Cost dist;
  Cost k = Cost::infinity();  ///< the least g since it came into the open list, and f: of a search in waves
  Cost f = Cost::infinity();
  std::int64_t queue = 0;    ///< first key component + 1 while in the open list
  std::uint32_t lp = 0;      ///< local parent + 1
  std::uint32_t rp = 0;      ///< remote parent + 1
  std::uint32_t side = 0;    ///< the other end of the side between which and lp its way leads + 1
  fields::StateTag tag{};    ///< of a search in waves
  std::uint8_t broken = 0;   ///< a bit for each law that does not hold here
  std::uint8_t changed = 0;  ///< Change bits since the last finished step

  enum Change : std::uint8_t {
    offer = 1,  ///< g or dist, so what it offers to others
    own = 2,    ///< rhs, lp or side; of a search in waves what else it keeps
    key = 4,    ///< a key was written, or it left the open list
    all = 8,    ///< its moves, or whatever else asks for a full look
  };

  [[nodiscard]] bool queued() const { return queue != 0; }
  [[nodiscard]] Cost k1() const { return {queue - 1}; }
  [[nodiscard]] Cost least() const { return std::min(g, rhs); }
};

template <int D>
class LawValues {
 public:
  /// Where something changed since the last finished step, and what stood there before.
  struct Touched {
    NodeId node;
    Cost g, rhs;
    std::uint32_t lp;
    bool queued;
  };

  /// At a position of the log.
  LawValues(const LogView& view, std::size_t position);

  void apply(const Event& event);
  /// Brings map and penalties up to date, and touches the vertices that this concerns.
  void finish_step();
  /// Forgets what has changed: everything was held against the laws.
  void settle();

  [[nodiscard]] const LawVertex& at(NodeId node) const {
    const auto& page = pages_[node / kPage];
    return page ? page[node % kPage] : kUntouched;
  }
  /// For `broken` and `changed` alone.
  LawVertex& write(NodeId node);
  void touch(NodeId node, LawVertex::Change change);
  /// The vertex that the step began by taking from the open list, as it was then; nullptr if there is none, or the map
  /// or the start has changed since.
  [[nodiscard]] const LawVertex* taken() const { return taken_ && !disturbed_ ? &*taken_ : nullptr; }
  /// In the order of their first change.
  [[nodiscard]] const std::vector<Touched>& touched() const { return touched_; }
  /// All vertices of pages that exist, by index.
  template <class Visit>
  void for_each_page(Visit&& visit) const {
    for (std::size_t p = 0; p < pages_.size(); ++p)
      if (pages_[p])
        for (std::size_t i = 0; i < kPage && p * kPage + i < known_.node_count(); ++i)
          visit(static_cast<NodeId>(p * kPage + i), pages_[p][i]);
  }

  /// As the planner sees it: what is blocked to the robot's centre.
  [[nodiscard]] const BoxLattice<D>& known() const { return known_; }
  /// What dist should be; zero for planners without clearance.
  [[nodiscard]] Cost penalty(NodeId node) const {
    return clearance_ ? clearance_->penalty(node) : Cost::zero();
  }
  [[nodiscard]] bool has_clearance() const { return clearance_.has_value(); }
  [[nodiscard]] NodeId start() const { return node_of(Scalar::start); }
  [[nodiscard]] NodeId goal() const { return node_of(Scalar::goal); }
  [[nodiscard]] NodeId robot() const { return node_of(Scalar::robot); }
  [[nodiscard]] Cost km() const {
    return {static_cast<std::int64_t>(scalars_[static_cast<int>(Scalar::km)])};
  }
  [[nodiscard]] Cost weight() const {
    return {static_cast<std::int64_t>(scalars_[static_cast<int>(Scalar::weight)])};
  }
  [[nodiscard]] bool on_map(NodeId node) const { return node < known_.node_count(); }
  [[nodiscard]] Heuristic heuristic() const { return heuristic_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::size_t kPage = 1024;
  static constexpr LawVertex kUntouched{};

  void load(const SearchState& state);
  [[nodiscard]] NodeId node_of(Scalar which) const {
    return static_cast<NodeId>(scalars_[static_cast<std::size_t>(which)]) - 1u;
  }
  void forget_search();
  void apply_own(const Event& event);
  LawVertex& changing(NodeId node, std::uint8_t change);

  std::vector<std::unique_ptr<LawVertex[]>> pages_;
  std::vector<Touched> touched_;
  BoxLattice<D> known_;
  std::optional<ClearanceField<D>> clearance_;
  std::vector<NodeId> turned_;  // cells of the robot's map since the last finished step
  std::array<std::uint64_t, static_cast<std::size_t>(Scalar::count)> scalars_{};
  Heuristic heuristic_;
  bool interpolated_, waves_, focused_;
  std::optional<LawVertex> taken_;
  bool disturbed_ = false;  // map or start have changed since the last finished step
};

extern template class LawValues<2>;
extern template class LawValues<3>;

}  // namespace replan
