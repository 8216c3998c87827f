#include "core/debug/child_in_hand.hpp"

#include <algorithm>
#include <utility>

#include "core/debug/iteration.hpp"

namespace replan {
namespace {

/// A child has no more events than this: all neighbours within reach in space, each with two ways.
constexpr std::size_t kLongestChild = std::size_t{1} << 16;
/// The lines of the pseudo-code on which a child has been crossed, and on which it is evaluated.
constexpr int kCrossedLine = 5, kEvaluatedLine = 10;

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
  const auto joined = static_cast<std::size_t>(state.scalar(Scalar::joined));
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

/// While a child is bred the population stays as it is: a path that leaves it for the child is there still, as the room of
/// the next one.
void rank_parents(const SearchState& state, ChildInHand& hand) {
  const std::vector<std::uint32_t> ranks = paths_by_fitness(state, hand.number);
  const auto rank_of = [&ranks](std::uint32_t path) {
    return static_cast<std::size_t>(std::find(ranks.begin(), ranks.end(), path) - ranks.begin()) + 1;
  };
  for (ChildInHand::Parent* parent : {&hand.mother, &hand.father}) {
    for (ChildInHand::Drawn& drawn : parent->drawn) drawn.rank = rank_of(drawn.path);
    if (parent->chosen != kNoNode) parent->rank = rank_of(parent->chosen);
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
  rank_parents(state, hand);
  if (line >= kCrossedLine) {
    read_crossing(state, hand);
    hand.path = bred_path(state, hand.number);
  }
  if (line >= kEvaluatedLine) hand.cost = path_cost(state, hand.number);
  hand.changed_from = state.node(Scalar::changed_from);
  hand.changed_to = state.node(Scalar::changed_to);
  return hand;
}

/// Where the child that is bred at a moment is done with; the end of the log if it is not yet.
std::size_t end_of_breeding(const Timeline& log, std::size_t moment) {
  while (moment < log.size() && log.event(moment).kind != EventKind::pop &&
         !ends_iteration(log.event(moment).kind))
    ++moment;
  return moment;
}

}  // namespace

std::optional<ChildInHand> child_in_hand(const LogView& view) {
  if (!view.info.evolving) return std::nullopt;
  const auto pop = pop_before(view.log, view.log.cursor(), kLongestChild);
  if (!pop) return std::nullopt;
  return read_child(view.log, *pop, view.log.cursor(), view.log.state());
}

std::optional<ChildInHand> birth_of_path(const LogView& view, std::uint32_t path) {
  return PathBirth().follow(view, 0, path);
}

const std::optional<ChildInHand>& PathBirth::follow(const LogView& view, std::uint64_t log_id,
                                                    std::uint32_t path) {
  if (log_id != log_id_ || path != path_ || view.log.cursor() < from_) {
    log_id_ = log_id;
    path_ = path;
    from_ = reach_ = end_ = 0;
    joined_.reset();
    birth_.reset();
  }
  if (view.log.cursor() > reach_) look_back(view);
  if (joined_) read_child_of(view.log);
  return birth_;
}

// A path is bred as the child and becomes a member when another one is the child. What is written of it is no mark: where
// it is like the path that lay there before, nothing is.
void PathBirth::look_back(const LogView& view) {
  const std::size_t known = std::exchange(reach_, view.log.cursor());
  std::uint32_t child = path_named(view.log.state(), Scalar::child);
  for (std::size_t before = reach_;;) {
    const auto turned = view.log.last_event(static_cast<NodeId>(Scalar::child), {EventKind::scalar}, before);
    if (!turned || *turned < known) return;
    ++turns_read_;
    const Event event = view.log.event(*turned);
    const bool forgotten = event.kind != EventKind::scalar;
    const auto earlier = static_cast<std::uint32_t>((std::uint64_t{child + 1u} ^ event.delta) - 1u);
    if (forgotten || earlier == path_) {
      from_ = *turned + 1;
      end_ = 0;
      joined_ = forgotten ? std::nullopt : turned;
      birth_.reset();
      return;
    }
    child = earlier;
    before = *turned;
  }
}

/// Reads the child as it stood when it was done with; where the log ended before that, once more when it has grown.
void PathBirth::read_child_of(const Timeline& log) {
  const std::size_t end = end_of_breeding(log, std::max(end_, *joined_));
  if (end == end_) return;
  end_ = end;
  const auto pop = pop_before(log, *joined_, kLongestChild);
  if (pop) birth_ = read_child(log, *pop, end, log.state_at(end));
}

}  // namespace replan
