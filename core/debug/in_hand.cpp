#include "core/debug/in_hand.hpp"

#include <algorithm>

namespace replan {
namespace {

/// So far back an iteration is looked for: what a replan takes in before its first one may be much longer.
constexpr std::size_t kLongest = 4096;

/// Events before which nothing is in hand any more.
constexpr KindSet kParting{EventKind::plan_begin, EventKind::plan_end, EventKind::move,
                           EventKind::waiting,    EventKind::arrival,  EventKind::gave_up,
                           EventKind::collision,  EventKind::new_goal, EventKind::put_down,
                           EventKind::surprise,   EventKind::epoch,    EventKind::turn};

/// Values of nodes that belong to the search and not to the world.
bool is_of_search(const LogView& view, EventKind kind) {
  if (is_own_field(kind)) return view.info.values.declares(kind);
  return kForgotten.has(kind) && kind != EventKind::visit;
}

/// Whether a reader is told of it as the value just written: a count of expansions teaches nothing.
bool is_telling(const LogView& view, EventKind kind) {
  if (kind == EventKind::known || kind == EventKind::dist) return true;
  const Field* field = view.info.values.find(kind);
  return is_of_search(view, kind) && field != nullptr && field->shown;
}

void read_back(const LogView& view, InHand& hand) {
  const Timeline& log = view.log;
  const std::size_t cursor = log.cursor(), first = cursor > kLongest ? cursor - kLongest : 0;
  for (std::size_t i = cursor; i-- > first;) {
    const Event event = log.event(i);
    if (event.kind == EventKind::pop) {
      hand.vertex = event.node;
      break;
    }
    if (kParting.has(event.kind)) break;
    if (i + 1 == cursor && is_telling(view, event.kind)) {
      const std::uint64_t after = log.state().value(event.kind, event.node);
      hand.written = InHand::Write{event, after ^ event.delta, after};
    }
    if (is_of_search(view, event.kind)) hand.touched.push_back(event.node);
  }
  std::sort(hand.touched.begin(), hand.touched.end());
  hand.touched.erase(std::unique(hand.touched.begin(), hand.touched.end()), hand.touched.end());
}

/// What u offers to its neighbours: each one's sum goes over u.
void try_from(const LogView& view, NodeId u, InHand& hand) {
  const SearchState& state = view.log.state();
  const bool lookahead = view.info.values.lookahead();
  hand.centre = u;
  for (Offer offer : offers_to(view, state, u)) {
    if (offer.side != kNoNode) continue;
    const NodeId s = offer.node;
    offer.g = state.g(u);
    offer.dist = state.dist(view.info.from_goal ? u : s);
    offer.sum = offer.step + offer.g + offer.dist;
    hand.trials.push_back({offer, offer.sum == (lookahead ? state.rhs(s) : state.g(s))});
  }
}

/// What the neighbours of s offer to it.
void try_to(const LogView& view, NodeId s, InHand& hand) {
  const SearchState& state = view.log.state();
  hand.centre = s;
  for (const Offer& offer : offers_to(view, state, s))
    if (offer.side == kNoNode)
      hand.trials.push_back({offer, !offer.sum.is_infinite() && offer.sum == state.rhs(s)});
}

/// A settled u offers its cost to all around it. Where u is none, or was raised, each vertex that had relied on it
/// looks about for another way.
void find_trials(const LogView& view, InHand& hand) {
  const SearchState& state = view.log.state();
  const bool lookahead = view.info.values.lookahead();
  if (hand.vertex) {
    const NodeId u = *hand.vertex;
    if (!state.g(u).is_infinite() && (!lookahead || state.g(u) == state.rhs(u))) {
      try_from(view, u, hand);
      return;
    }
  }
  if (!lookahead || !hand.written || !is_of_search(view, hand.written->event.kind)) return;
  const NodeId s = hand.written->event.node;
  if (s != hand.vertex && s != state.node(view.info.root())) try_to(view, s, hand);
}

}  // namespace

InHand in_hand(const LogView& view) {
  InHand hand;
  if (view.info.evolving) return hand;  // core/debug/child_in_hand.hpp
  read_back(view, hand);
  find_trials(view, hand);
  return hand;
}

}  // namespace replan
