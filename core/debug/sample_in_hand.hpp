// What a planner that grows a tree of samples has in hand at a moment of its log: the sample that it works on, what became
// of it, and why the new vertex hangs where it does.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/plan/tree_values.hpp"

namespace replan {

struct SampleInHand {
  /// A vertex that the new one could hang on, and what the way to it would cost over that; infinite if it is blocked.
  struct Candidate {
    std::uint32_t vertex = 0;
    Cost cost;
  };
  /// A vertex that was hung on the new one, and what that saved.
  struct Rewired {
    std::uint32_t vertex = 0;
    Cost saves;
  };

  std::optional<Place> sample;           ///< where it was drawn, once that is written
  std::optional<std::uint32_t> nearest;  ///< the vertex that it was steered from, once that is found
  std::optional<Place> place;            ///< where it was steered to, once that is known
  std::optional<double> ball;            ///< how far around that parents were looked for, in cells
  std::vector<Candidate> candidates;     ///< in the order in which they were tried
  bool pulls = false;                    ///< it is drawn to pull the path straight, and not for the tree
  std::optional<std::uint32_t> added;    ///< the new vertex, once there is one
  std::vector<Rewired> rewired;
  std::optional<SampleFault> rejected;  ///< why it was given up
  NodeId rejected_at = kNoNode;         ///< the obstacle, or the cell of the place
};

/// What is in hand at the log's cursor; nothing if no sample was drawn since the plan began, or its planner draws none.
std::optional<SampleInHand> sample_in_hand(const LogView& view);

/// Where a vertex that there is at the cursor came into the tree: the event, and what it could have hung on, in the order in
/// which that was tried; none where its planner takes the nearest one. Nothing for one that is not to be found.
struct VertexBirth {
  std::size_t event = 0;
  std::vector<SampleInHand::Candidate> candidates = {};
};
std::optional<VertexBirth> birth_of(const LogView& view, std::uint32_t vertex);

/// The vertex nearest to a place, of equally near ones the first; kNoNode if the tree has none.
std::uint32_t nearest_vertex(const SearchState& state, const Place& place, bool in_space);

/// The one nearest to a cell's middle, kept from frame to frame as long as neither cursor nor cell moves.
class NearestVertex {
 public:
  /// At the cursor of the log. `log_id` is another one when the log is another one, or was cut.
  std::uint32_t follow(const LogView& view, std::uint64_t log_id, Cell cell);
  /// How often it was looked for, all times together.
  [[nodiscard]] std::size_t searches() const { return searches_; }

 private:
  std::uint64_t log_id_ = 0;
  std::size_t cursor_ = SIZE_MAX;
  Cell cell_;
  std::uint32_t vertex_ = kNoNode;
  std::size_t searches_ = 0;
};

}  // namespace replan
