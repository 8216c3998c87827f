// What one round of a planner's main loop is called: what a user steps over, and what its work is counted by.
#pragma once

#include <string_view>

namespace replan {

struct StepWords {
  std::string_view one, many;               ///< "sample", "samples"
  std::string_view next, previous;          ///< as actions are called: "Next sample"
  std::string_view next_ten, previous_ten;  ///< "Next ten samples"
  std::string_view does;                    ///< what the next one does, as a sentence
  std::string_view speed;                   ///< what playing speed counts: "Samples per second"
  std::string_view term;                    ///< the word of the glossary that explains it
};

/// Of a search with an open list.
inline constexpr StepWords kExpansionWords{.one = "expansion",
                                           .many = "expansions",
                                           .next = "Next expansion",
                                           .previous = "Previous expansion",
                                           .next_ten = "Next ten expansions",
                                           .previous_ten = "Previous ten expansions",
                                           .does = "Takes one cell from the open list and settles it.",
                                           .speed = "Expansions per second",
                                           .term = "expansion"};
/// Of a tree that grows by samples.
inline constexpr StepWords kSampleWords{.one = "sample",
                                        .many = "samples",
                                        .next = "Next sample",
                                        .previous = "Previous sample",
                                        .next_ten = "Next ten samples",
                                        .previous_ten = "Previous ten samples",
                                        .does = "Draws one sample, and makes something of it or gives it up.",
                                        .speed = "Samples per second",
                                        .term = "sample"};
/// Of a population of paths.
inline constexpr StepWords kChildWords{
    .one = "child",
    .many = "children",
    .next = "Next child",
    .previous = "Previous child",
    .next_ten = "Next ten children",
    .previous_ten = "Previous ten children",
    .does = "Breeds one child of two paths, which takes the place of the least fit path or is given up.",
    .speed = "Children per second",
    .term = "child"};

}  // namespace replan
