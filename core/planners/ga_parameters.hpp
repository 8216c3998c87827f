// Parameters of planners that breed a population of paths.
#pragma once

#include "core/plan/parameters.hpp"

namespace replan::parameters {

inline const Parameter kPopulation{.key = "population",
                                   .label = "Population",
                                   .type = ParameterType::whole,
                                   .initial = 80,
                                   .low = 2,
                                   .high = 500,
                                   .help = "How many paths there are at any time."};
inline const Parameter kGenerations{
    .key = "generations",
    .label = "Generations",
    .type = ParameterType::whole,
    .initial = 60,
    .low = 1,
    .high = 100'000,
    .help =
        "How many generations are bred for a plan; each is as many children as the population has paths. "
        "Without a path that hits nothing by then the planner says that it found none, which does not mean "
        "that there is none."};
inline const Parameter kGenerationsAgain{.key = "generations_again",
                                         .label = "Generations after a change",
                                         .type = ParameterType::whole,
                                         .initial = 10,
                                         .low = 0,
                                         .high = 100'000,
                                         .help =
                                             "How many generations are bred for a new plan after a change "
                                             "that has left the population a path which "
                                             "hits nothing. One without such a path breeds until it has one, "
                                             "or for as many as for the first plan."};
inline const Parameter kMostCells{.key = "most_cells",
                                  .label = "Cells of a path",
                                  .type = ParameterType::whole,
                                  .initial = 16,
                                  .low = 1,
                                  .high = 200,
                                  .help = "How many cells a path has between its ends at most."};
inline const Parameter kFirstPaths{
    .key = "first_paths",
    .label = "First paths",
    .type = ParameterType::choice,
    .choices = {"sight", "random"},
    .help =
        "What the population begins with: paths from cell to cell that is seen from there, drawn by chance; "
        "or "
        "random free cells in any order, which hit obstacles almost everywhere."};
inline const Parameter kTournament{
    .key = "tournament",
    .label = "Tournament",
    .type = ParameterType::whole,
    .initial = 2,
    .low = 1,
    .high = 50,
    .unit = "paths",
    .help = "A parent is the fittest of so many paths that are drawn by chance. 1: any path."};
inline const Parameter kCrossover{
    .key = "crossover",
    .label = "Crossover",
    .type = ParameterType::choice,
    .choices = {"shared", "position"},
    .help =
        "Where two paths are crossed: at a cell that both lead over, or, where there is none, as far along "
        "both of them; or always so, which is the plain operator."};
inline const Parameter kCrossoverRate{
    .key = "crossover_rate",
    .label = "Crossover rate",
    .initial = 0.9,
    .low = 0,
    .high = 1,
    .help = "How often a child is of two paths; else it is like its mother."};
inline const Parameter kMutation{
    .key = "mutation",
    .label = "Mutation",
    .type = ParameterType::choice,
    .choices = {"fittest", "random"},
    .help =
        "By which of its free neighbours a cell of the child is replaced: that with which the whole path is "
        "fittest, which is the improved operator, or any, which is the plain one."};
inline const Parameter kMutationRate{.key = "mutation_rate",
                                     .label = "Mutation rate",
                                     .initial = 0.9,
                                     .low = 0,
                                     .high = 1,
                                     .help = "How often a cell of a child is replaced by a neighbour."};
inline const Parameter kMutationReach{
    .key = "mutation_reach",
    .label = "Mutation reach",
    .type = ParameterType::whole,
    .initial = 1,
    .low = 1,
    .high = 5,
    .unit = "cells",
    .help =
        "How far away a neighbour may be, along each axis. 1: the cells around it, as in the paper; more "
        "lets paths move faster on large maps, and costs more checks."};
inline const Parameter kHitPenalty{
    .key = "hit_penalty",
    .label = "Penalty for a hit",
    .initial = 200,
    .low = 0,
    .high = 100'000,
    .unit = "cells",
    .help = "What a path's length counts more for each straight way of it that hits an obstacle."};
inline const Parameter kBreedingSeed{
    .key = "seed",
    .label = "Seed",
    .type = ParameterType::whole,
    .initial = 1,
    .low = 0,
    .high = 1'000'000'000,
    .help = "What the random numbers begin with: the same seed, the same children."};

}  // namespace replan::parameters
