#include "ui/canvas/kept_words.hpp"

#include "ui/canvas/chips.hpp"

namespace replan::ui {
namespace {

std::string tree_sentence(const KeptCounts& counts) {
  const std::string all = count_text(counts.all(), "vertex", "vertices");
  if (counts.anew) return "The tree of " + all + " was given up: another one grows from the start.";
  if (counts.lost == 0) return "No vertex was cut off: the tree kept its " + all + ".";
  return "The tree of " + all + " kept " + grouped(counts.kept) + " of them, and " + grouped(counts.lost) +
         " were cut off.";
}

std::string population_sentence(const KeptCounts& counts) {
  const std::string all = count_text(counts.all(), "path", "paths");
  if (counts.anew) return "The population of " + all + " was given up: another one is bred from the start.";
  return "Of " + all + " " + grouped(counts.kept) + " stayed as they were, " + grouped(counts.joined) +
         " were joined to where the robot is, and " + grouped(counts.lost) +
         " hit something and were lost to new ones that are fitter.";
}

}  // namespace

std::string kept_sentence(const SearchValues& values, const KeptCounts& counts) {
  return values.breeds() ? population_sentence(counts) : tree_sentence(counts);
}

std::string kept_brief(const SearchValues& values, const KeptCounts& counts) {
  if (values.breeds())
    return grouped(counts.kept + counts.joined) + " kept, " + grouped(counts.lost) + " lost";
  return grouped(counts.kept) + " kept, " + grouped(counts.lost) + " cut off";
}

}  // namespace replan::ui
