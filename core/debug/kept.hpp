// What a replan has kept, and what it has lost, of a tree of samples or a population of paths.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/space/place.hpp"

namespace replan {

/// A vertex that a replan cut off, or a path that another one took the place of, as it was when the replan began.
struct Lost {
  std::size_t event = 0;            ///< index of the event by which it was lost
  std::uint32_t number = 0;         ///< of the vertex, or of the path
  std::uint32_t hung_on = kNoNode;  ///< the vertex on which it hung; kNoNode: it was a root, or is a path
  Cost cost;                        ///< what the way to it cost, or the path, penalties included
  std::vector<Point> way;           ///< its edge, or the path; of a root nothing
};

/// How many vertices, or paths, are as they were, are joined to where the robot is (paths alone), and are lost.
struct KeptCounts {
  std::int64_t kept = 0, joined = 0, lost = 0;
  bool anew = false;  ///< all was forgotten: the tree grows, or the population is bred, from nothing
  [[nodiscard]] std::int64_t all() const { return kept + joined + lost; }
};

/// What one replan kept at any position of its log, read out of it once and then as it grows. Of planners that neither grow
/// nor breed, nothing.
class KeptInReplan {
 public:
  /// Of what is lost no more is listed: a replan that grows its tree anew loses all of it.
  static constexpr std::size_t kMostListed = 40'000;

  /// Shows the replan whose `plan_begin` is the event `begin`, and which ends before `end`. `log_id` is another one when the
  /// log is another one, or was cut.
  void follow(const LogView& view, std::uint64_t log_id, std::size_t begin, std::size_t end);

  /// At a position of the log.
  [[nodiscard]] KeptCounts counts_before(std::size_t position) const;
  /// What was lost before a position, in the order of the events.
  [[nodiscard]] std::span<const Lost> lost_before(std::size_t position) const;

 private:
  void start(const LogView& view);
  void take(const LogView& view, const Event& event, std::size_t index);
  void lose_all(const LogView& view, std::size_t index);
  void lose_vertex(const LogView& view, std::uint32_t vertex, std::size_t index);
  void lose_path(const LogView& view, std::uint32_t path, std::size_t index);

  std::uint64_t log_id_ = 0;
  std::size_t begin_ = 0, read_ = 0;
  bool settled_ = false;              // nothing is lost any more: the search itself has begun
  SearchState before_;                // as the replan began, until then
  std::int64_t all_ = 0;              // vertices, or members, then
  std::optional<std::size_t> anew_;   // the event that forgot them
  std::vector<std::size_t> lost_at_;  // the events of all that was lost
  std::vector<Lost> lost_;            // the first kMostListed of it
  std::vector<std::pair<std::size_t, std::uint32_t>> joined_;  // event and path, of those not lost by then
};

}  // namespace replan
