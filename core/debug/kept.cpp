#include "core/debug/kept.hpp"

#include <algorithm>

#include "core/plan/population_values.hpp"
#include "core/plan/tree_values.hpp"

namespace replan {
namespace {

/// Of assets/planners/improved-ga.md: a path is joined to where the robot is, and a new one takes its place.
constexpr int kJoinedLine = 15, kReplacedLine = 16;

bool in_tree(const SearchState& state, std::uint32_t vertex) {
  return !vertex_cost(state, vertex).is_infinite();
}

std::int64_t vertices_in_tree(const SearchState& state) {
  std::int64_t count = 0;
  for (std::uint32_t v = 0; v < vertex_count(state); ++v) count += in_tree(state, v) ? 1 : 0;
  return count;
}

/// All paths but the child's.
std::int64_t member_count(const SearchState& state) {
  return std::max<std::int64_t>(std::int64_t{path_count(state)} - 1, 0);
}

}  // namespace

void KeptInReplan::start(const LogView& view) {
  before_ = view.log.state_at(begin_);
  all_ = view.info.values.grows() ? vertices_in_tree(before_) : member_count(before_);
  read_ = begin_;
  settled_ = false;
  anew_.reset();
  lost_at_.clear();
  lost_.clear();
  joined_.clear();
}

void KeptInReplan::follow(const LogView& view, std::uint64_t log_id, std::size_t begin, std::size_t end) {
  if (!view.info.values.grows() && !view.info.values.breeds()) return;
  if (log_id != log_id_ || begin != begin_) {
    log_id_ = log_id;
    begin_ = begin;
    start(view);
  }
  for (; read_ < end && !settled_; ++read_) take(view, view.log.event(read_), read_);
}

void KeptInReplan::take(const LogView& view, const Event& event, std::size_t index) {
  if (event.kind == EventKind::pop || event.kind == EventKind::plan_end) {
    settled_ = true;
    before_ = {};
  } else if (event.kind == EventKind::epoch) {
    lose_all(view, index);
  } else if (anew_) {
    return;  // what is written from there on is of the new ones
  } else if (view.info.values.grows() && event.kind == fields::kVertexCost.kind) {
    const Cost before = vertex_cost(before_, event.node);
    const Cost after{before.raw ^ static_cast<std::int64_t>(event.delta)};
    if (!before.is_infinite() && after.is_infinite()) lose_vertex(view, event.node, index);
  } else if (view.info.values.breeds() && event.kind == fields::kPathCell.kind) {
    const std::uint32_t path = event.node / kPlacesOfPath;
    const auto is_path = [path](const auto& each) { return each.second == path; };
    if (event.line == kJoinedLine && std::none_of(joined_.begin(), joined_.end(), is_path))
      joined_.emplace_back(index, path);
    if (event.line == kReplacedLine && (lost_.empty() || lost_.back().number != path))
      lose_path(view, path, index);
  }
}

void KeptInReplan::lose_all(const LogView& view, std::size_t index) {
  anew_ = index;
  const bool grows = view.info.values.grows();
  std::vector<bool> gone(grows ? vertex_count(before_) : path_count(before_));
  for (const Lost& lost : lost_) gone[lost.number] = true;
  for (std::uint32_t i = 0; i < gone.size(); ++i) {
    if (gone[i]) continue;
    if (grows && in_tree(before_, i)) lose_vertex(view, i, index);
    if (!grows && i != path_named(before_, Scalar::child)) lose_path(view, i, index);
  }
}

void KeptInReplan::lose_vertex(const LogView& view, std::uint32_t vertex, std::size_t index) {
  lost_at_.push_back(index);
  if (lost_.size() >= kMostListed) return;
  const bool solid = view.lattice.solid();
  Lost lost{index, vertex, vertex_parent(before_, vertex), vertex_cost(before_, vertex), {}};
  if (lost.hung_on != kNoNode)
    lost.way = {point_of(vertex_place(before_, lost.hung_on, solid)),
                point_of(vertex_place(before_, vertex, solid))};
  lost_.push_back(std::move(lost));
}

void KeptInReplan::lose_path(const LogView& view, std::uint32_t path, std::size_t index) {
  lost_at_.push_back(index);
  Lost lost{index, path, kNoNode, path_cost(before_, path), {}};
  for (const PathPlace& place : bred_path(before_, path))
    lost.way.push_back(centre_of(view.lattice.position(place.cell)));
  lost_.push_back(std::move(lost));
}

std::span<const Lost> KeptInReplan::lost_before(std::size_t position) const {
  const auto after = std::partition_point(lost_.begin(), lost_.end(),
                                          [position](const Lost& lost) { return lost.event < position; });
  return std::span(lost_).first(static_cast<std::size_t>(after - lost_.begin()));
}

KeptCounts KeptInReplan::counts_before(std::size_t position) const {
  if (anew_ && *anew_ < position) return {.lost = all_, .anew = true};
  KeptCounts counts{.lost = std::lower_bound(lost_at_.begin(), lost_at_.end(), position) - lost_at_.begin()};
  const std::span<const Lost> lost = lost_before(position);
  for (const auto& [event, path] : joined_) {
    const auto is_lost = [number = path](const Lost& each) { return each.number == number; };
    if (event < position && std::none_of(lost.begin(), lost.end(), is_lost)) ++counts.joined;
  }
  counts.kept = all_ - counts.joined - counts.lost;
  return counts;
}

}  // namespace replan
