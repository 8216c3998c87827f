#include "core/debug/sample_in_hand.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/debug/iteration.hpp"

namespace replan {
namespace {

/// A sample has no more events than this: a ball of thousands of vertices with their subtrees.
constexpr std::size_t kLongestSample = std::size_t{1} << 20;

/// Of assets/planners/greedy-informed-rrt-star.md.
constexpr int kFirstLineOfPulling = 19, kFirstLineOfMission = 100;

Place read_place(const SearchState& state, Scalar first, bool in_space) {
  const auto part = [&](std::size_t axis) {
    return units_of(state.scalar(static_cast<Scalar>(static_cast<std::size_t>(first) + axis)));
  };
  return {part(0), part(1), in_space ? part(2) : kPlaceUnits / 2};
}

double ball_in(const SearchState& state) {
  return static_cast<double>(units_of(state.scalar(Scalar::ball))) / kPlaceUnits;
}

/// Whether there is a vertex more behind it.
bool is_one_more(const Event& event) {
  return event.kind == EventKind::scalar && static_cast<Scalar>(event.node) == Scalar::vertices;
}

/// What the events from a `pop` on tell, up to `end`; `state` is that at `end`.
SampleInHand read_sample(const Timeline& log, std::size_t pop, std::size_t end, const SearchState& state,
                         bool in_space) {
  SampleInHand hand;
  std::uint32_t grown = 0;  // the goal may become a vertex besides
  for (std::size_t i = pop; i < end; ++i) {
    const Event& event = log.event(i);
    const Cost cost{static_cast<std::int64_t>(event.delta)};
    if (event.line >= kFirstLineOfPulling && event.line < kFirstLineOfMission) hand.pulls = true;
    if (event.line >= (hand.pulls ? 21 : 4) || event.kind == EventKind::rejected)
      hand.sample = read_place(state, Scalar::sample_x, in_space);
    if (event.line >= (hand.pulls ? 21 : 4))
      hand.nearest = static_cast<std::uint32_t>(state.scalar(Scalar::nearest)) - 1u;
    if (event.line >= (hand.pulls ? 22 : 5)) hand.place = read_place(state, Scalar::new_x, in_space);
    if (event.line == 8) hand.ball = ball_in(state);
    if (event.kind == EventKind::candidate) hand.candidates.push_back({event.node, cost});
    if (event.kind == EventKind::rewired) hand.rewired.push_back({event.node, cost});
    grown += is_one_more(event) ? 1 : 0;
    if (event.kind == EventKind::rejected) {
      hand.rejected = static_cast<SampleFault>(event.delta);
      hand.rejected_at = event.node;
    }
  }
  if (grown > 0) hand.added = vertex_count(state) - grown;
  return hand;
}

struct NearestSoFar {
  std::uint32_t vertex = kNoNode;
  std::int64_t squared = std::numeric_limits<std::int64_t>::max();
};

/// Looks for a nearer one among the vertices of a page, of those that were not cut off.
void look_through(const VertexPage& page, std::uint32_t first, std::uint32_t count, const Place& place,
                  NearestSoFar& nearest) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (page.cost(i).is_infinite()) continue;
    const std::int64_t squared = squared_between(page.place(i), place);
    if (squared < nearest.squared) nearest = {first + i, squared};
  }
}

}  // namespace

std::optional<SampleInHand> sample_in_hand(const LogView& view) {
  if (!view.info.sampling) return std::nullopt;
  const auto pop = pop_before(view.log, view.log.cursor(), kLongestSample);
  if (!pop) return std::nullopt;
  return read_sample(view.log, *pop, view.log.cursor(), view.log.state(), view.lattice.solid());
}

// A vertex is written down behind its candidates: first that there is one more, then where it lies.
std::optional<VertexBirth> birth_of(const LogView& view, std::uint32_t vertex) {
  const auto written = view.log.last_event(
      vertex, {fields::kVertexX.kind, fields::kVertexY.kind, fields::kVertexZ.kind}, view.log.cursor());
  if (!written) return std::nullopt;
  VertexBirth birth{.event = *written};
  const auto pop = pop_before(view.log, *written, kLongestSample);
  std::vector<SampleInHand::Candidate> tried;
  for (std::size_t i = pop.value_or(*written); i < *written; ++i) {
    const Event& event = view.log.event(i);
    if (event.kind == EventKind::candidate)
      tried.push_back({event.node, {static_cast<std::int64_t>(event.delta)}});
    if (is_one_more(event)) birth.candidates = std::exchange(tried, {});
  }
  return birth;
}

std::uint32_t nearest_vertex(const SearchState& state, const Place& place, bool in_space) {
  NearestSoFar nearest;
  const std::uint32_t count = vertex_count(state);
  for (std::uint32_t first = 0; first < count; first += VertexPage::kSize)
    look_through({state, first, in_space}, first, std::min(VertexPage::kSize, count - first), place, nearest);
  return nearest.vertex;
}

std::uint32_t NearestVertex::follow(const LogView& view, std::uint64_t log_id, Cell cell) {
  const std::size_t cursor = view.log.cursor();
  if (log_id == log_id_ && cursor == cursor_ && cell == cell_) return vertex_;
  log_id_ = log_id;
  cursor_ = cursor;
  cell_ = cell;
  ++searches_;
  return vertex_ = nearest_vertex(view.log.state(), place_in(cell), view.lattice.solid());
}

}  // namespace replan
