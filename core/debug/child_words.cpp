#include "core/debug/child_words.hpp"

#include <algorithm>

#include "core/base/words.hpp"
#include "core/debug/event_words.hpp"

namespace replan {
namespace {

std::string parent_words(const char* who, const ChildInHand::Parent& parent) {
  const std::string sentence = std::string("The ") + who + " is path " + std::to_string(parent.chosen);
  if (parent.drawn.size() == 1) return sentence + ", which was drawn by chance.";
  std::string drawn;
  for (const ChildInHand::Drawn& each : parent.drawn)
    drawn += (drawn.empty() ? "" : ", ") + std::to_string(each.path) + " (" + cost_text(each.cost, 1) + ")";
  return sentence + ", the fittest of those that were drawn: " + drawn + ".";
}

std::string crossing_words(const LogView& view, const ChildInHand& hand) {
  const std::string at = node_text(view.lattice, hand.crossed_at);
  if (hand.copied) return "They were not crossed: the child began as its mother.";
  if (hand.shared)
    return "Both lead over " + at +
           ": the child is like its mother up to there, and like its father behind it.";
  return "The child leaves its mother at " + at +
         ", and goes on as its father does from as far along: they were not crossed at a cell that both "
         "have.";
}

/// Of those that were tried the fittest but for the one that was taken; null if there is none.
const ChildInHand::Tried* next_best(const ChildInHand& hand) {
  const ChildInHand::Tried* best = nullptr;
  for (const ChildInHand::Tried& tried : hand.tried)
    if (tried.cell != hand.changed_to && (best == nullptr || tried.unfitness < best->unfitness))
      best = &tried;
  return best;
}

std::string cost_words(const Unfitness& unfitness) {
  return cost_text(unfitness.cost, 3) + (unfitness.hits ? " and hits something" : "");
}

std::string change_words(const LogView& view, const ChildInHand& hand) {
  const std::string from = node_text(view.lattice, hand.changed_from),
                    to = node_text(view.lattice, hand.changed_to);
  if (hand.changed_to == kNoNode)
    return "Mutation is about to replace " + from + " by one of its free neighbours.";
  const std::string replaced = "Mutation replaced " + from + " by " + to;
  const auto is_taken = [&](const ChildInHand::Tried& tried) { return tried.cell == hand.changed_to; };
  const auto taken = std::find_if(hand.tried.begin(), hand.tried.end(), is_taken);
  if (taken == hand.tried.end()) return replaced + ", a free neighbour that was drawn by chance.";
  const std::string with_it = "with it the whole path costs " + cost_words(taken->unfitness);
  const ChildInHand::Tried* other = next_best(hand);
  if (other == nullptr) return replaced + ", its only free neighbour: " + with_it + ".";
  return replaced + ", the fittest of " +
         counted(static_cast<std::int64_t>(hand.tried.size()), "free neighbour") + ": " + with_it +
         "; with the next best one, " + node_text(view.lattice, other->cell) + ", it costs " +
         cost_words(other->unfitness) + ".";
}

std::string end_words(const ChildInHand& hand) {
  if (hand.rejected == SampleFault::twin)
    return "The child is given up: the population has that path already.";
  if (hand.rejected) return "The child is given up: no path of the population is less fit.";
  return "The child is fitter than path " + std::to_string(*hand.leaves) +
         ", the least fit one, and takes its place.";
}

}  // namespace

std::vector<std::string> child_words(const LogView& view, const ChildInHand& hand) {
  std::vector<std::string> words;
  if (hand.mother.chosen != kNoNode) words.push_back(parent_words("mother", hand.mother));
  if (hand.father.chosen != kNoNode) words.push_back(parent_words("father", hand.father));
  if (!hand.path.empty()) words.push_back(crossing_words(view, hand));
  if (hand.changed_from != kNoNode) words.push_back(change_words(view, hand));
  if (hand.rejected || hand.leaves) words.push_back(end_words(hand));
  return words;
}

}  // namespace replan
