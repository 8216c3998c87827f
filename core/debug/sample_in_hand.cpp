#include "core/debug/sample_in_hand.hpp"

#include <algorithm>

namespace replan {
namespace {

/// A sample has no more events than this: a ball of thousands of vertices with their subtrees.
constexpr std::size_t kLongestSample = std::size_t{1} << 20;

/// Whether no sample is in hand any more behind such an event.
bool parts(EventKind kind) {
  return kind == EventKind::plan_begin || kind == EventKind::plan_end || kind == EventKind::epoch ||
         kind == EventKind::move || kind == EventKind::surprise;
}

Place read_place(const SearchState& state, Scalar first, bool in_space) {
  const auto part = [&](std::size_t axis) {
    return units_of(state.scalar(static_cast<Scalar>(static_cast<std::size_t>(first) + axis)));
  };
  return {part(0), part(1), in_space ? part(2) : kPlaceUnits / 2};
}

/// What the events from a `pop` on tell, up to `end`; `state` is that at `end`.
SampleInHand read_sample(const Timeline& log, std::size_t pop, std::size_t end, const SearchState& state,
                         bool in_space) {
  SampleInHand hand;
  for (std::size_t i = pop; i < end; ++i) {
    const Event& event = log.event(i);
    const Cost cost{static_cast<std::int64_t>(event.delta)};
    if (event.line >= 4) hand.sample = read_place(state, Scalar::sample_x, in_space);
    if (event.line >= 4) hand.nearest = static_cast<std::uint32_t>(state.scalar(Scalar::nearest)) - 1u;
    if (event.line >= 5) hand.place = read_place(state, Scalar::new_x, in_space);
    if (event.kind == EventKind::candidate) hand.candidates.push_back({event.node, cost});
    if (event.kind == EventKind::rewired) hand.rewired.push_back({event.node, cost});
    if (event.kind == EventKind::scalar && static_cast<Scalar>(event.node) == Scalar::vertices && !hand.added)
      hand.added = vertex_count(state) - 1;
    if (event.kind == EventKind::rejected) {
      hand.rejected = static_cast<SampleFault>(event.delta);
      hand.rejected_at = event.node;
    }
  }
  return hand;
}

/// The `pop` before which no other one lies between it and `end`.
std::optional<std::size_t> pop_before(const Timeline& log, std::size_t end) {
  const std::size_t first = end > kLongestSample ? end - kLongestSample : 0;
  for (std::size_t i = end; i-- > first;) {
    const EventKind kind = log.event(i).kind;
    if (kind == EventKind::pop) return i;
    if (parts(kind)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SampleInHand> sample_in_hand(const LogView& view) {
  if (!view.info.sampling) return std::nullopt;
  const auto pop = pop_before(view.log, view.log.cursor());
  if (!pop) return std::nullopt;
  return read_sample(view.log, *pop, view.log.cursor(), view.log.state(), view.lattice.solid());
}

std::optional<SampleInHand> birth_of(const LogView& view, std::uint32_t vertex) {
  const auto written =
      view.log.last_event(vertex, {fields::kVertexX.kind, fields::kVertexY.kind}, view.log.cursor());
  if (!written) return std::nullopt;
  const auto pop = pop_before(view.log, *written);
  if (!pop) return std::nullopt;
  std::size_t end = *written;
  while (end < view.log.size() && view.log.event(end).kind != EventKind::pop &&
         !parts(view.log.event(end).kind))
    ++end;
  return read_sample(view.log, *pop, end, view.log.state_at(end), view.lattice.solid());
}

}  // namespace replan
