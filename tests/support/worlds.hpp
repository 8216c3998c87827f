// Small worlds drawn from a seed, edits of them and settings of planners: what property tests run on.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/lattice/box_lattice.hpp"
#include "core/plan/registry.hpp"
#include "tests/support/oracle.hpp"

namespace replan::test {

/// The same world for the engine and for the oracle, each with its own cells.
template <int D>
struct TwinWorld {
  BoxLattice<D> lattice;
  oracle::World plain;

  TwinWorld(typename BoxLattice<D>::Coordinates size, const std::vector<std::uint8_t>& cells, MoveRules rules)
      : lattice(size, cells, rules) {
    plain.dimensions = D;
    for (std::size_t axis = 0; axis < D; ++axis) plain.size[axis] = size[axis];
    plain.blocked = cells;
  }
  /// Writes the edits to both; what the lattice reports is valid until its next change.
  std::span<const typename BoxLattice<D>::MoveChange> apply(std::span<const CellEdit> edits) {
    for (const CellEdit& edit : edits) plain.blocked[edit.node] = edit.blocked ? 1 : 0;
    return lattice.apply(edits);
  }
};

template <int D>
std::size_t cell_count(const typename BoxLattice<D>::Coordinates& size) {
  std::size_t count = 1;
  for (const int extent : size) count *= static_cast<std::size_t>(extent);
  return count;
}

/// A size between `low` and `high` along each axis.
template <int D>
typename BoxLattice<D>::Coordinates random_size(Random& random, typename BoxLattice<D>::Coordinates low,
                                                typename BoxLattice<D>::Coordinates high) {
  for (std::size_t axis = 0; axis < D; ++axis) low[axis] = random.between(low[axis], high[axis]);
  return low;
}

/// Blocks a random box with sides up to `longest`.
template <int D>
void draw_box(Random& random, const typename BoxLattice<D>::Coordinates& size, int longest,
              std::vector<std::uint8_t>& cells) {
  typename BoxLattice<D>::Coordinates low{}, high{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    low[axis] = random.between(0, size[axis] - 1);
    high[axis] = std::min(size[axis], low[axis] + random.between(1, longest));
  }
  const BoxLattice<D> frame(size);
  for (NodeId n = 0; n < cells.size(); ++n) {
    const auto at = frame.coordinates(n);
    bool within = true;
    for (std::size_t axis = 0; axis < D; ++axis) within &= at[axis] >= low[axis] && at[axis] < high[axis];
    if (within) cells[n] = 1;
  }
}

/// Blocks every other line (plane) across the first axis but for a gap or two: corridors.
template <int D>
void draw_corridors(Random& random, const typename BoxLattice<D>::Coordinates& size,
                    std::vector<std::uint8_t>& cells) {
  const int pitch = random.between(2, 3);
  for (NodeId n = 0; n < cells.size(); ++n)
    if (static_cast<int>(n) % size[0] % pitch == 1) cells[n] = 1;
  for (int x = 1; x < size[0]; x += pitch)
    for (int gaps = random.between(1, 2); gaps > 0; --gaps) {
      const auto row =
          random.below(static_cast<std::uint32_t>(cells.size()) / static_cast<std::uint32_t>(size[0]));
      cells[row * static_cast<std::uint32_t>(size[0]) + static_cast<std::uint32_t>(x)] = 0;
    }
}

/// Noise, boxes, corridors, next to nothing or nothing.
template <int D>
std::vector<std::uint8_t> random_cells(Random& random, const typename BoxLattice<D>::Coordinates& size) {
  std::vector<std::uint8_t> cells(cell_count<D>(size));
  const std::uint32_t kind = random.below(10);
  if (kind < 5) {
    const double density = kind < 4 ? 0.05 + (D == 2 ? 0.4 : 0.65) * random.unit() : 0.01;
    for (std::uint8_t& cell : cells) cell = random.chance(density) ? 1 : 0;
  } else if (kind < 7) {
    for (int boxes = random.between(1, 6); boxes > 0; --boxes) draw_box<D>(random, size, 5, cells);
  } else if (kind < 8) {
    draw_corridors<D>(random, size, cells);
  }
  return cells;
}

/// Turns between 1 and `most` cells over, each once: scattered, or close together round a cell. In half of
/// the cases obstacles go as often as they come, so that worlds do not all fill up.
template <int D>
std::vector<CellEdit> random_edits(Random& random, const oracle::World& world, int most) {
  const auto count = static_cast<std::uint32_t>(world.blocked.size());
  const bool close = random.chance(0.5), thin = random.chance(0.5);
  const oracle::Place middle = world.place(random.below(count));
  std::vector<CellEdit> edits;
  for (int left = random.between(1, most); left > 0; --left) {
    auto cell = world.place(random.below(count));
    if (close)
      for (std::size_t axis = 0; axis < D; ++axis)
        cell[axis] = std::clamp(middle[axis] + random.between(-1, 1), 0, world.size[axis] - 1);
    auto node = static_cast<NodeId>(world.index(cell));
    for (int tries = 0; tries < 50 && world.blocked[node] == 0 && thin && left % 2 == 0; ++tries)
      node = random.below(count);
    const auto same = [node](const CellEdit& edit) { return edit.node == node; };
    if (std::none_of(edits.begin(), edits.end(), same)) edits.push_back({node, world.blocked[node] == 0});
  }
  return edits;
}

/// So many that a tree fills a small world, and no more: what a sample costs grows with the tree.
inline constexpr int kFewSamples = 120;

/// As many as show what breeding does, and no more.
inline constexpr int kFewGenerations = 4;

/// A value for every declared parameter. `remote_parents` stays "checked", ranges stay within 1..4.
inline Settings random_settings(Random& random, const PlannerInfo& info) {
  constexpr double kRanges[] = {1, 1.5, 2, 2.5, 3, 4};
  Settings settings;
  for (const Parameter& parameter : info.parameters) {
    if (parameter.key == "remote_parents") continue;
    if (parameter.key == "samples")
      settings.set(parameter.key, kFewSamples);
    else if (parameter.key == "goal_bias")
      settings.set(parameter.key, random.unit() / 2);
    else if (parameter.key == "population")
      settings.set(parameter.key, random.between(2, 12));
    else if (parameter.key == "generations")
      settings.set(parameter.key, kFewGenerations);
    else if (parameter.key.ends_with("_rate"))
      settings.set(parameter.key, random.unit());
    else if (parameter.type == ParameterType::choice)
      settings.set(parameter.key, random.below(static_cast<std::uint32_t>(parameter.choices.size())));
    else if (parameter.type == ParameterType::toggle)
      settings.set(parameter.key, random.below(parameter.key == "impassable" ? 8 : 2) == 1 ? 1 : 0);
    else if (parameter.type == ParameterType::whole)
      settings.set(parameter.key, random.between(static_cast<int>(parameter.low), 4));
    else
      settings.set(parameter.key, kRanges[random.below(6)]);
  }
  return settings;
}

/// Settings as text, for messages.
inline std::string describe_settings(const PlannerInfo& info, const Settings& settings) {
  std::string text(info.id);
  for (const Parameter& parameter : info.parameters) {
    text += ' ';
    text += parameter.key;
    text += '=' + format_value(parameter, settings.get(parameter));
  }
  return text;
}

/// A free cell, or any cell if there is none.
inline NodeId random_free(Random& random, const oracle::World& world) {
  const auto count = static_cast<std::uint32_t>(world.blocked.size());
  for (int tries = 0; tries < 50; ++tries)
    if (const NodeId n = random.below(count); world.blocked[n] == 0) return n;
  return random.below(count);
}

/// The penalties that a planner with these settings pays, by the oracle; empty if it pays none.
inline std::vector<oracle::Raw> expected_penalties(const PlannerInfo& info, const Settings& settings,
                                                   const oracle::World& world) {
  if (info.clearance == nullptr) return {};
  const bool border = settings.get("border", 0) != 0;
  if (find_parameter(info.parameters, "range") == nullptr || settings.get("penalty", 0) != 0) {
    const double r_min = settings.get("r_min", 1), r_max = settings.get("r_max", 3);
    return oracle::penalties(
        world, {.range = r_max < r_min ? r_min : r_max,
                .transform = Transform::euclidean,
                .border_is_obstacle = border,
                .threat = ThreatCurve{settings.get("c", 5), r_min, settings.get("impassable", 0) != 0}});
  }
  return oracle::penalties(world, {.range = settings.get("range", 2),
                                   .transform = static_cast<Transform>(settings.get("transform", 0)),
                                   .border_is_obstacle = border});
}

/// The planner whose search the given one makes its any-angle paths of.
inline const PlannerInfo& lattice_twin(const PlannerInfo& info) {
  return *find_planner(info.clearance ? "dist-dstar-lite" : "dstar-lite");
}

/// How long a path is: the roots rounded down, so that a step of it is never longer than a move. Between points that are
/// no nodes a root is one of doubles.
inline oracle::Raw length_of(const oracle::World& world, const Path& path) {
  oracle::Raw sum = 0;
  for (std::size_t i = 1; path.nodes().empty() && i < path.size(); ++i)
    sum += static_cast<oracle::Raw>(distance(path.point(i - 1), path.point(i)) * double{oracle::kUnit});
  for (std::size_t i = 1; i < path.nodes().size(); ++i) {
    const auto p = world.place(path.nodes()[i - 1]), q = world.place(path.nodes()[i]);
    std::int64_t squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      squared += std::int64_t{p[axis] - q[axis]} * (p[axis] - q[axis]);
    sum += oracle::root_floor(squared);
  }
  return sum;
}

/// Why an any-angle path is wrong beside the lattice path of the same search, or empty.
inline std::string fault_of_length(const oracle::World& world, const Path& any_angle, const Path& lattice) {
  oracle::Raw way = 0;
  for (std::size_t i = 1; i < lattice.size(); ++i)
    way += oracle::step_between(world, lattice.nodes()[i - 1], lattice.nodes()[i]);
  const oracle::Raw length = length_of(world, any_angle);
  if (length <= way) return "";
  return "a path of length " + std::to_string(length) + " where the lattice path has " + std::to_string(way);
}

/// The status that a plan must have, `shortest` being what a shortest lattice path costs.
inline PlanStatus right_status(const oracle::World& world, NodeId start, NodeId goal, oracle::Raw shortest) {
  return world.blocked[start] != 0    ? PlanStatus::start_blocked
         : world.blocked[goal] != 0   ? PlanStatus::goal_blocked
         : shortest == oracle::kNever ? PlanStatus::no_path
                                      : PlanStatus::found;
}

/// Why a path over points that are no nodes is wrong, or empty: its ends, and that it enters no obstacle.
inline std::string fault_of_polyline(const oracle::World& world, NodeId start, NodeId goal,
                                     const Path& path) {
  const auto centre = [&world](NodeId node) {
    const auto at = world.place(node);
    return centre_of({at[0], at[1], at[2]});
  };
  if (path.point(0) != centre(start) || path.point(path.size() - 1) != centre(goal)) return "the path's ends";
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path.point(i - 1), b = path.point(i);
    if (a == b) return "the path repeats a point";
    if (oracle::enters_bad(world, {a.x, a.y, a.z}, {b.x, b.y, b.z})) return "a segment enters an obstacle";
  }
  return "";
}

/// Why a checked path is wrong, or empty: its ends, its nodes, and that each segment is a move, or a line of
/// sight if the planner leaves the lattice's directions.
inline std::string fault_of_segments(const PlannerInfo& info, const Settings& settings,
                                     const oracle::World& world, NodeId start, NodeId goal,
                                     const Path& path) {
  const MoveRules rules = move_rules(settings);
  if (path.loops || path.unchecked) return "a checked path loops or was not checked";
  if (!path.empty() && path.nodes().empty()) return fault_of_polyline(world, start, goal, path);
  if (path.empty() || path.nodes().front() != start || path.nodes().back() != goal) return "the path's ends";
  std::vector<NodeId> sorted(path.nodes().begin(), path.nodes().end());
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return "the path repeats a node";
  const auto sight = static_cast<SightRule>(static_cast<int>(settings.get("sight", 0)));
  for (std::size_t i = 1; i < path.nodes().size(); ++i) {
    const NodeId a = path.nodes()[i - 1], b = path.nodes()[i];
    if (!oracle::sees(world, world.blocked, rules.corners, sight, a, b))
      return "a segment crosses an obstacle";
    if (info.any_angle) continue;
    const auto near = oracle::neighbours(world, rules, a);
    if (!std::binary_search(near.begin(), near.end(), std::size_t{b})) return "a step is not a move";
  }
  return "";
}

/// kNever for each cell that the planner may not enter though it is free, 0 for the others; empty if it pays no penalty.
inline std::vector<oracle::Raw> closed_cells(const PlannerInfo& info, const Settings& settings,
                                             const oracle::World& world) {
  std::vector<oracle::Raw> closed = expected_penalties(info, settings, world);
  for (oracle::Raw& penalty : closed) penalty = penalty == oracle::kNever ? penalty : 0;
  return closed;
}

/// The length of a shortest lattice path from cell to cell that the planner may enter; kNever if there is none.
inline oracle::Raw shortest_way(const PlannerInfo& info, const Settings& settings, const oracle::World& world,
                                NodeId start, NodeId goal) {
  if (world.blocked[start] != 0) return oracle::kNever;
  return oracle::costs_to(world, move_rules(settings), closed_cells(info, settings, world), goal)[start];
}

/// Whether a planner may answer so: one that samples need not find what there is.
inline bool is_right(const PlannerInfo& info, PlanStatus answer, PlanStatus right) {
  const bool can_miss = info.can_miss() && (right == PlanStatus::no_path || right == PlanStatus::found);
  return answer == right ? !can_miss || right == PlanStatus::found
                         : can_miss && answer == PlanStatus::none_found;
}

/// Why a planner's answer is none, or empty: whether there is a path, its cost, ends and segments, and its
/// length against the bound that the planner declares. What every planner owes, be its plans cheapest or not.
template <int D>
std::string fault_of_answer(const PlannerInfo& info, const Settings& settings, const oracle::World& world,
                            NodeId start, NodeId goal, Planner<BoxLattice<D>>& planner) {
  const oracle::Raw shortest = shortest_way(info, settings, world, start, goal);
  const PlanStatus status = right_status(world, start, goal, shortest);
  if (!is_right(info, planner.status(), status))
    return std::string("status ") + status_name(planner.status()) + ", not " + status_name(status);
  const bool found = planner.status() == PlanStatus::found;
  if (planner.cost().is_infinite() == found) return "a cost without a plan, or none";
  const Path path = planner.path();
  if (!found) return path.empty() ? "" : "a path without a plan";
  if (const std::string fault = fault_of_segments(info, settings, world, start, goal, path); !fault.empty())
    return fault;
  const double length = static_cast<double>(length_of(world, path)),
               bound = info.length_bound(settings) * static_cast<double>(shortest);
  if (length <= bound || length == 0) return "";
  return "a length of " + std::to_string(length) + ", more than " + std::to_string(bound);
}

/// Why a checked plan is wrong, or empty: cost against a fresh plan of the oracle, status, and the path's
/// nodes, segments and sum.
template <int D>
std::string fault_of_plan(const PlannerInfo& info, const Settings& settings, const oracle::World& world,
                          NodeId start, NodeId goal, Planner<BoxLattice<D>>& planner) {
  const auto penalty = expected_penalties(info, settings, world);
  const oracle::Raw fresh = world.blocked[start] != 0
                                ? oracle::kNever
                                : oracle::costs_to(world, move_rules(settings), penalty, goal)[start];
  if (planner.cost().raw != fresh)
    return "cost " + std::to_string(planner.cost().raw) + " but a fresh plan costs " + std::to_string(fresh);
  const PlanStatus status = right_status(world, start, goal, fresh);
  if (planner.status() != status) return std::string("status ") + status_name(planner.status());
  const Path path = planner.path();
  if (status != PlanStatus::found) return path.empty() ? "" : "a path without a plan";
  if (const std::string fault = fault_of_segments(info, settings, world, start, goal, path); !fault.empty())
    return fault;
  if (info.any_angle) return "";
  oracle::Raw sum = 0;
  for (std::size_t i = 1; i < path.nodes().size(); ++i)
    sum += oracle::step_between(world, path.nodes()[i - 1], path.nodes()[i]) +
           (penalty.empty() ? 0 : penalty[path.nodes()[i]]);
  return sum == fresh ? "" : "the steps do not sum to the cost";
}

}  // namespace replan::test
