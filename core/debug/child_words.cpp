#include "core/debug/child_words.hpp"

#include <algorithm>

#include "core/base/words.hpp"
#include "core/debug/event_words.hpp"

namespace replan {
namespace {

std::string rank_text(std::size_t rank) {
  return "#" + std::to_string(rank);
}

std::string parent_words(const char* who, const ChildInHand::Parent& parent, LengthUnit lengths) {
  const std::string sentence =
      std::string("The ") + who + " is path " + rank_text(parent.rank) + " by fitness";
  if (parent.drawn.size() == 1) return sentence + ", which was drawn by chance.";
  std::string drawn;
  for (const ChildInHand::Drawn& each : parent.drawn)
    drawn += (drawn.empty() ? "" : ", ") + rank_text(each.rank) + " (" + lengths.text(each.cost, 1) + ")";
  return sentence + ", the fittest of those that were drawn: " + drawn + ".";
}

std::string crossing_words(const LogView& view, const ChildInHand& hand) {
  const std::string at = node_text(view.lattice, hand.crossed_at);
  if (hand.copied) return "There was no crossover this time: the child began as a copy of its mother.";
  if (hand.shared)
    return "Both lead over " + at + ": the child has its mother's cells up to there, and then its father's.";
  return "The child has its mother's cells up to " + at +
         ", and then its father's from as far along: a straight way joins the two, since they were not "
         "crossed at a cell that both have.";
}

/// Of those that were tried the fittest but for the one that was taken; null if there is none.
const ChildInHand::Tried* next_best(const ChildInHand& hand) {
  const ChildInHand::Tried* best = nullptr;
  for (const ChildInHand::Tried& tried : hand.tried)
    if (tried.cell != hand.changed_to && (best == nullptr || tried.unfitness < best->unfitness))
      best = &tried;
  return best;
}

std::string cost_words(const Unfitness& unfitness, LengthUnit lengths) {
  return lengths.text(unfitness.cost) + (unfitness.hits ? " and hits something" : "");
}

std::string change_words(const LogView& view, const ChildInHand& hand, LengthUnit lengths) {
  const std::string from = node_text(view.lattice, hand.changed_from),
                    to = node_text(view.lattice, hand.changed_to);
  if (hand.changed_to == kNoNode)
    return "Mutation is about to replace " + from + " by one of its free neighbours.";
  const std::string replaced = "Mutation replaced " + from + " by " + to;
  const auto is_taken = [&](const ChildInHand::Tried& tried) { return tried.cell == hand.changed_to; };
  const auto taken = std::find_if(hand.tried.begin(), hand.tried.end(), is_taken);
  if (taken == hand.tried.end()) return replaced + ", a free neighbour that was drawn by chance.";
  const std::string with_it = "with it the whole path costs " + cost_words(taken->unfitness, lengths);
  const ChildInHand::Tried* other = next_best(hand);
  if (other == nullptr) return replaced + ", its only free neighbour: " + with_it + ".";
  return replaced + ", the fittest of " +
         counted(static_cast<std::int64_t>(hand.tried.size()), "free neighbour") + ": " + with_it +
         "; with the next best one, " + node_text(view.lattice, other->cell) + ", it costs " +
         cost_words(other->unfitness, lengths) + ".";
}

std::string end_words(const ChildInHand& hand) {
  if (hand.rejected == SampleFault::twin)
    return "The child is given up: the population has that path already.";
  if (hand.rejected) return "The child is given up: no path of the population is less fit.";
  return "The child is fitter than the least fit path, and takes its place.";
}

}  // namespace

std::vector<std::string> child_words(const LogView& view, const ChildInHand& hand, LengthUnit lengths) {
  std::vector<std::string> words;
  if (hand.mother.chosen != kNoNode) words.push_back(parent_words("mother", hand.mother, lengths));
  if (hand.father.chosen != kNoNode) words.push_back(parent_words("father", hand.father, lengths));
  if (!hand.path.empty()) words.push_back(crossing_words(view, hand));
  if (hand.changed_from != kNoNode) words.push_back(change_words(view, hand, lengths));
  if (hand.rejected || hand.leaves) words.push_back(end_words(hand));
  return words;
}

}  // namespace replan
