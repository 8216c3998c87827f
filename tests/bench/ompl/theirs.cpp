#include <chrono>
#include <cmath>
#include <memory>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "core/space/free_space.hpp"
#include "race.hpp"

namespace replan::bench {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

Place place_of(const ob::State* state) {
  const auto* at = state->as<ob::RealVectorStateSpace::StateType>();
  return BoxGap::place_of({(*at)[0], (*at)[1], 0.5});
}

class Validity final : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& information, const FreeSpace<2>& space)
      : ob::StateValidityChecker(information), space_(space) {}
  bool isValid(const ob::State* state) const override {
    const Place place = place_of(state);
    return space_.contains(place) && space_.free(place);
  }

 private:
  const FreeSpace<2>& space_;
};

class Ways final : public ob::MotionValidator {
 public:
  Ways(const ob::SpaceInformationPtr& information, const FreeSpace<2>& space)
      : ob::MotionValidator(information), space_(space) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const Place end = place_of(to);
    return space_.contains(end) && space_.sees(place_of(from), end);
  }
  // Asked for only by planners that go as far as they can along a way, which none of these does.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>&) const override {
    return checkMotion(from, to);
  }

 private:
  const FreeSpace<2>& space_;
};

/// OMPL takes one seed for all that the program does: later races go on with its numbers.
void seed_once(std::uint32_t seed) {
  static const bool seeded = (ompl::RNG::setSeed(seed), true);
  static_cast<void>(seeded);
}

ob::PlannerPtr make_racer(const ob::SpaceInformationPtr& information, Racer racer, double step) {
  if (racer == Racer::rrt_connect) {
    const auto planner = std::make_shared<og::RRTConnect>(information);
    planner->setRange(step);
    return planner;
  }
  const auto planner = racer == Racer::rrt_star ? std::make_shared<og::RRTstar>(information)
                                                : std::make_shared<og::InformedRRTstar>(information);
  planner->setRange(step);
  return planner;
}

}  // namespace

Race run_theirs(const RaceProblem& problem, Racer racer, std::uint32_t seed, double seconds) {
  using Clock = std::chrono::steady_clock;
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  seed_once(seed);
  const FreeSpace<2> space(*problem.world);
  const auto begun = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };

  const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  for (unsigned axis = 0; axis < 2; ++axis) {
    bounds.setLow(axis, 0);
    bounds.setHigh(axis, problem.world->size()[axis]);
  }
  plane->setBounds(bounds);
  const auto information = std::make_shared<ob::SpaceInformation>(plane);
  information->setStateValidityChecker(std::make_shared<Validity>(information, space));
  information->setMotionValidator(std::make_shared<Ways>(information, space));
  information->setup();
  const auto definition = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<ob::RealVectorStateSpace> start(plane), goal(plane);
  start[0] = problem.start.x + 0.5, start[1] = problem.start.y + 0.5;
  goal[0] = problem.goal.x + 0.5, goal[1] = problem.goal.y + 0.5;
  definition->setStartAndGoalStates(start, goal);
  if (racer != Racer::rrt_connect)
    definition->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(information));

  Race race;
  definition->setIntermediateSolutionCallback(
      [&](const ob::Planner*, const std::vector<const ob::State*>&, const ob::Cost cost) {
        race.push_back({passed(), cost.value()});
      });
  const ob::PlannerPtr planner = make_racer(information, racer, problem.step);
  planner->setProblemDefinition(definition);
  planner->setup();
  planner->solve(ob::timedPlannerTerminationCondition(seconds));
  if (racer == Racer::rrt_connect && definition->hasExactSolution())
    race.push_back({passed(), definition->getSolutionPath()->length()});
  return race;
}

}  // namespace replan::bench
