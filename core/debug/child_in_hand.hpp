// What a planner that breeds paths has in hand at a moment of its log: the child, the parents that it was made of, what was
// tried to change it, and what became of it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/plan/population_values.hpp"

namespace replan {

struct ChildInHand {
  /// A path that was drawn as a parent, and what it costs.
  struct Drawn {
    std::uint32_t path = 0;
    Cost cost;
    std::size_t rank = 0;  ///< among the paths of the population by their fitness; 1: the fittest
  };
  /// A free neighbour that could take the changed cell's place, and the child with it.
  struct Tried {
    NodeId cell = kNoNode;
    Unfitness unfitness;
  };
  /// A parent, and all that were drawn for it.
  struct Parent {
    std::vector<Drawn> drawn;
    std::uint32_t chosen = kNoNode;  ///< kNoNode: not yet
    BredPath path;                   ///< of the chosen one
    std::size_t rank = 0;            ///< of the chosen one, as above
  };

  std::uint32_t number = kNoNode;  ///< among the paths
  BredPath path;                   ///< empty until its parents are crossed
  Cost cost = Cost::infinity();    ///< infinite until it is evaluated
  Parent mother, father;
  NodeId crossed_at = kNoNode;  ///< the last cell that it has of its mother; kNoNode until it is crossed
  bool copied = false;          ///< it is its mother all over
  bool shared = false;          ///< its father has that cell too
  NodeId changed_from = kNoNode, changed_to = kNoNode;  ///< by mutation; kNoNode: nothing yet, or at all
  std::vector<Tried> tried;
  std::optional<SampleFault> rejected;  ///< why it was given up
  std::optional<std::uint32_t> leaves;  ///< the path whose place it took
};

/// What is in hand at the log's cursor; nothing if no child was begun since the plan was, or its planner breeds none.
std::optional<ChildInHand> child_in_hand(const LogView& view);

/// The child as whose a path came into the population, as it stood when it was done with; nothing for one of the first paths,
/// and for those that a replan has joined to another start.
std::optional<ChildInHand> birth_of_path(const LogView& view, std::uint32_t path);

/// What birth_of_path() says, kept from frame to frame: farther on in the same log only what lies between is read.
class PathBirth {
 public:
  /// Goes to the cursor of the log. `log_id` is another one when the log is another one, or was cut.
  const std::optional<ChildInHand>& follow(const LogView& view, std::uint64_t log_id, std::uint32_t path);
  /// How many turns from one child to the next were looked at, all times together.
  [[nodiscard]] std::size_t turns_read() const { return turns_read_; }

 private:
  void look_back(const LogView& view);
  void read_child_of(const Timeline& log);

  std::uint64_t log_id_ = 0;
  std::uint32_t path_ = kNoNode;
  std::size_t from_ = 0, reach_ = 0;   // the cursors, both included, for which it holds
  std::optional<std::size_t> joined_;  // the event at which the path became a member
  std::size_t end_ = 0;                // of what was read of the child
  std::optional<ChildInHand> birth_;
  std::size_t turns_read_ = 0;
};

}  // namespace replan
