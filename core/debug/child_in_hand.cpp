#include "core/debug/child_in_hand.hpp"

namespace replan {
namespace {

/// A child has no more events than this: all neighbours within reach in space, each with two ways.
constexpr std::size_t kLongestChild = std::size_t{1} << 16;
/// The lines of the pseudo-code on which a child has been crossed, and on which it is evaluated.
constexpr int kCrossedLine = 5, kEvaluatedLine = 10;

/// Whether no child is in hand any more behind such an event.
bool ends_breeding(EventKind kind) {
  return kind == EventKind::plan_begin || kind == EventKind::plan_end || kind == EventKind::epoch ||
         kind == EventKind::move || kind == EventKind::surprise;
}

/// The `pop` before which no other one lies between it and `end`.
std::optional<std::size_t> breeding_before(const Timeline& log, std::size_t end) {
  const std::size_t first = end > kLongestChild ? end - kLongestChild : 0;
  for (std::size_t i = end; i-- > first;) {
    const EventKind kind = log.event(i).kind;
    if (kind == EventKind::pop) return i;
    if (ends_breeding(kind)) return std::nullopt;
  }
  return std::nullopt;
}

void read_parents(const SearchState& state, ChildInHand& hand) {
  for (const auto& [parent, which] :
       {std::pair{&hand.mother, Scalar::mother}, {&hand.father, Scalar::father}}) {
    parent->chosen = path_named(state, which);
    if (parent->chosen != kNoNode) parent->path = bred_path(state, parent->chosen);
  }
}

/// How the parents were crossed.
void read_crossing(const SearchState& state, ChildInHand& hand) {
  hand.crossed_at = state.node(Scalar::crossed_at);
  const std::size_t joined = state.scalar(Scalar::joined);
  hand.copied = joined >= hand.father.path.size();
  hand.shared = !hand.copied && joined > 0 && hand.father.path[joined - 1].cell == hand.crossed_at;
}

void read_event(const Event& event, ChildInHand& hand) {
  switch (event.kind) {
    case EventKind::candidate:
      (hand.father.drawn.empty() && hand.mother.chosen == kNoNode ? hand.mother : hand.father)
          .drawn.push_back({event.node, {static_cast<std::int64_t>(event.delta)}});
      return;
    case EventKind::tried:
      hand.tried.push_back(
          {event.node, {(event.delta & 1) != 0, {static_cast<std::int64_t>(event.delta >> 1)}}});
      return;
    case EventKind::rejected:
      hand.rejected = static_cast<SampleFault>(event.delta);
      return;
    case EventKind::scalar:
      if (static_cast<Scalar>(event.node) == Scalar::mother && event.line == 3) hand.mother.chosen = 0;
      return;
    default:
      return;
  }
}

/// What the events from a `pop` on tell, up to `end`; `state` is that at `end`.
ChildInHand read_child(const Timeline& log, std::size_t pop, std::size_t end, const SearchState& state) {
  ChildInHand hand;
  hand.number = path_named(state, Scalar::child);
  int line = 0;
  for (std::size_t i = pop; i < end; ++i) {
    const Event event = log.event(i);
    line = std::max(line, int{event.line});
    read_event(event, hand);
    if (event.kind != EventKind::scalar || static_cast<Scalar>(event.node) != Scalar::child) continue;
    hand.leaves = hand.number;
    hand.number = static_cast<std::uint32_t>(state.scalar(Scalar::child) ^ event.delta) - 1u;
  }
  read_parents(state, hand);
  if (line >= kCrossedLine) {
    read_crossing(state, hand);
    hand.path = bred_path(state, hand.number);
  }
  if (line >= kEvaluatedLine) hand.cost = path_cost(state, hand.number);
  hand.changed_from = state.node(Scalar::changed_from);
  hand.changed_to = state.node(Scalar::changed_to);
  return hand;
}

/// The child that is bred at a moment, when it is done with.
std::optional<ChildInHand> read_birth(const Timeline& log, std::size_t moment) {
  const auto pop = breeding_before(log, moment);
  if (!pop) return std::nullopt;
  std::size_t end = moment;
  while (end < log.size() && log.event(end).kind != EventKind::pop && !ends_breeding(log.event(end).kind))
    ++end;
  return read_child(log, *pop, end, log.state_at(end));
}

}  // namespace

std::optional<ChildInHand> child_in_hand(const LogView& view) {
  if (!view.info.evolving) return std::nullopt;
  const auto pop = breeding_before(view.log, view.log.cursor());
  if (!pop) return std::nullopt;
  return read_child(view.log, *pop, view.log.cursor(), view.log.state());
}

std::optional<ChildInHand> birth_of_path(const LogView& view, std::uint32_t path) {
  // A path is bred as the child and becomes a member when another one is the child. What is written of it is no mark: where
  // it is like the path that lay there before, nothing is.
  std::uint32_t child = path_named(view.log.state(), Scalar::child);
  for (std::size_t before = view.log.cursor();;) {
    const auto turned = view.log.last_event(static_cast<NodeId>(Scalar::child), {EventKind::scalar}, before);
    if (!turned || view.log.event(*turned).kind != EventKind::scalar) return std::nullopt;  // forgotten since
    const Event event = view.log.event(*turned);
    const auto earlier = static_cast<std::uint32_t>((std::uint64_t{child + 1u} ^ event.delta) - 1u);
    if (earlier == path) return read_birth(view.log, *turned);
    child = earlier;
    before = *turned;
  }
}

}  // namespace replan
