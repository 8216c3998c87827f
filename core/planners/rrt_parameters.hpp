// Parameters that planners share which grow a tree of samples.
#pragma once

#include "core/plan/parameters.hpp"

namespace replan::parameters {

inline const Parameter kStep{.key = "step",
                             .label = "Step",
                             .initial = 4,
                             .low = 0.1,
                             .high = 1000,
                             .unit = "cells",
                             .help =
                                 "How far a new vertex lies from the nearest one of the tree at most: the "
                                 "papers' StepSize."};
inline const Parameter kGoalReach{
    .key = "goal_reach",
    .label = "Goal within",
    .initial = 4,
    .low = 0,
    .high = 1000,
    .unit = "cells",
    .help =
        "A vertex that is no farther from the goal is joined to it, if the way is "
        "free: the papers' Delta."};
inline const Parameter kGoalBias{
    .key = "goal_bias",
    .label = "Goal bias",
    .initial = 0.05,
    .low = 0,
    .high = 1,
    .help =
        "How often the goal itself is the sample, until there is a path: 0.05 is one "
        "time in twenty."};
inline const Parameter kSamples{
    .key = "samples",
    .label = "Samples",
    .type = ParameterType::whole,
    .initial = 2000,
    .low = 1,
    .high = 1'000'000,
    .help =
        "How many samples are drawn for a plan. Without a path by then the planner says "
        "that it found none, which does not mean that there is none."};
inline const Parameter kSamplesAgain{
    .key = "samples_again",
    .label = "Samples after a change",
    .type = ParameterType::whole,
    .initial = 200,
    .low = 0,
    .high = 1'000'000,
    .help =
        "How many samples are drawn for a new plan after a change of the map that has left it a path. One "
        "that has lost "
        "its path draws until it has one, or has drawn as many as for the first plan."};
inline const Parameter kNoGain{
    .key = "no_gain",
    .label = "Stop without gain",
    .type = ParameterType::whole,
    .initial = 0,
    .low = 0,
    .high = 1'000'000,
    .unit = "samples",
    .help =
        "Once there is a path, the planner ends after so many samples that have not made "
        "it shorter; 0: it draws all of its samples."};
inline const Parameter kBall{
    .key = "ball",
    .label = "Ball",
    .type = ParameterType::choice,
    .choices = {"step", "shrinking"},
    .help =
        "How far around a new vertex parents and vertices to rewire are looked for: as far as "
        "a step, which is the paper's way, or in a ball that shrinks as the tree grows "
        "(Karaman & Frazzoli), but no farther than that."};
inline const Parameter kSampleRule{
    .key = "sampler",
    .label = "Sampler",
    .type = ParameterType::choice,
    .choices = {"uniform", "halton", "grid"},
    .help =
        "Where samples lie: anywhere with equal chance; along the Halton sequence, "
        "which leaves smaller gaps; or one in each box of a grid, round after round."};
inline const Parameter kSeed{.key = "seed",
                             .label = "Seed",
                             .type = ParameterType::whole,
                             .initial = 1,
                             .low = 0,
                             .high = 1'000'000'000,
                             .help = "What the random numbers begin with: the same seed, the same tree."};

}  // namespace replan::parameters
