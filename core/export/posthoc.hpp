// The log as a search trace of the Posthoc visualiser, format 1.4.0 (github.com/ShortestPathLab/posthoc-app).
//
// A step of the visualiser is one of these; every one carries x and y (but for a plan), and `pass`, which
// counts the plans from 1:
//
//   source, destination  the ends, when the first plan begins; a destination again where the goal moves
//   generating           a cell enters the open list or gets another key
//   expanding            a cell is taken from it and settled; its values are those after that
//   updating             an underconsistent cell is taken from it and raised; likewise
//   closing              a cell goes back with a newer key unexpanded, or leaves the list unexpanded
//   plan                 a plan stands: its path, drawn until the next one
//   move                 the robot enters a cell, drawn until the next one
//   block, unblock       the robot learns of an obstacle, or that one is gone
//   end                  the robot arrives
//
// The parent of a cell is its remote parent where the planner has such, else its local one. The visualiser
// follows parents to the root at every step, for ever if they lead in a circle, as those of a search that is
// being repaired can for a while: such a link is cut.
#pragma once

#include "core/export/trace_file.hpp"
#include "core/trace/expansions.hpp"

namespace replan {

/// Steps from which on Posthoc takes its time to load a trace.
inline constexpr std::size_t kManyPosthocSteps = 200'000;

/// How large a trace will be.
struct PosthocSize {
  std::size_t steps = 0;
  std::size_t bytes = 0;  ///< about
};
/// Counted; in a long log, of samples.
PosthocSize posthoc_size(const Timeline& log);

class PosthocTrace final : public TraceEncoder {
 public:
  PosthocTrace(const TraceRun& run, bool yaml);

  [[nodiscard]] std::size_t head_parts() const override { return 1; }
  void head(std::string& out, std::size_t part) override;
  void event(std::string& out, std::size_t index, const Event& event, const SearchState& state) override;
  void tail(std::string& out, const SearchState& state) override;

 private:
  class Step;
  /// A cell's values in a step.
  struct Values {
    Cost g, rhs, k1, km;
  };

  void queue(std::string& out, const Event& event, const SearchState& state);
  void visit(const Event& event, const SearchState& state);
  void settle(std::string& out, const SearchState& state, Cost g);
  void happening(std::string& out, std::size_t index, const Event& event, const SearchState& state);
  void close_all(std::string& out, const SearchState& state);
  void place(std::string& out, std::string_view type, NodeId node);
  void robot(std::string& out, NodeId node);
  void plan(std::string& out, const Path& path);
  void cell(std::string& out, std::string_view type, NodeId node, const SearchState& state,
            const Values& values);
  void parent(Step& step, NodeId node, const SearchState& state);
  [[nodiscard]] bool leads_to(NodeId from, NodeId node) const;

  const TraceRun& run_;
  bool yaml_;
  bool lookahead_;
  bool first_ = true;
  ExpansionCounter expansions_;
  std::uint64_t pass_ = 1;
  NodeId popped_ = kNoNode;  // taken from the open list last
  bool leaving_ = false;     // its removal is still to come
  Cost popped_key_;
  NodeId visited_ = kNoNode;  // expanded, its g still to come
  std::string_view visited_as_;
  std::vector<NodeId>
      parents_;  // as last written; kUnnamed for cells without a step, kNoNode without a parent
};

}  // namespace replan
