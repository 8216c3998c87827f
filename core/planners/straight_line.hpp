// No planner: the straight line from where the robot is to its goal, whatever stands there. It is what a robot has for a
// plan that only heads for its goal, as the dynamic window approach does where nobody plans for it:
//
//  Fox D., Burgard W. & Thrun S., "The dynamic window approach to collision avoidance", IEEE Robotics & Automation
//  Magazine 4(1), 1997, doi 10.1109/100.580977
//
// Line numbers are those of assets/planners/dwa.md. Settled here: the line is "found" wherever both ends are free; nothing
// is expanded, and nothing that the robot learns changes it.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/plan/registry.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

struct StraightLineSwitches {};

inline PlannerInfo describe(StraightLineSwitches) {
  PlannerInfo info;
  info.name = "Straight line";
  info.summary = "No planner: the straight line to the goal, whatever stands there.";
  info.source = "Fox, Burgard & Thrun 1997, doi 10.1109/100.580977";
  info.values = {.fields = {fields::kG},
                 .order = best_first_values().order,
                 .cost = {EventKind::g, Scalar::goal},
                 .laws = "none"};
  info.blind = true;
  info.any_angle = true;
  info.length_bound = [](const Settings&) { return std::numeric_limits<double>::infinity(); };
  return info;
}

template <Lattice L, Tracer T>
class StraightLine final : public Planner<L> {
 public:
  StraightLine(const L& lattice, const Settings&, T& tracer, StraightLineSwitches)
      : lattice_(lattice), tr_(tracer) {}

  void begin(NodeId start, NodeId goal) override {
    if (goal_ != kNoNode) set_g(Cost::infinity());
    set_end(Scalar::goal, goal_, goal);
    plan(start);
  }
  bool advance(std::int64_t) override { return true; }
  void update(const MapChange<L>&, NodeId start) override { plan(start); }

  [[nodiscard]] PlanStatus status() const override {
    if (lattice_.blocked(start_)) return PlanStatus::start_blocked;
    return lattice_.blocked(goal_) ? PlanStatus::goal_blocked : PlanStatus::found;
  }
  [[nodiscard]] Cost cost() const override { return status() == PlanStatus::found ? g_ : Cost::infinity(); }
  Path path() override {
    if (status() != PlanStatus::found) return {};
    std::vector<NodeId> nodes = {start_};
    if (goal_ != start_) nodes.push_back(goal_);
    return {lattice_.box(), std::move(nodes)};
  }
  [[nodiscard]] Counters counters() const override { return {}; }
  [[nodiscard]] std::size_t memory_bytes() const override { return 0; }

  void restore(const SearchState& state, const Counters&) override {
    start_ = state.node(Scalar::start);
    goal_ = state.node(Scalar::goal);
    g_ = state.g(goal_);
  }

 private:
  // Lines 1-3.
  void plan(NodeId start) {
    tr_.line(2);
    set_end(Scalar::start, start_, start);
    tr_.line(3);
    set_g(euclidean_floor(lattice_.squared_distance(start_, goal_)));
  }
  void set_end(Scalar which, NodeId& held, NodeId node) {
    tr_.change(which, std::uint64_t{held + 1u}, std::uint64_t{node + 1u});
    held = node;
  }
  /// Of the goal: the length of the line.
  void set_g(Cost value) {
    tr_.change(EventKind::g, goal_, g_, value);
    g_ = value;
  }

  const L& lattice_;
  T& tr_;
  NodeId start_ = kNoNode, goal_ = kNoNode;
  Cost g_ = Cost::infinity();
};

}  // namespace replan
