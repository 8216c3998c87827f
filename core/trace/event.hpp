// What a planner does, as a log of reversible events.
//
// An event that changes a value stores before XOR after. Applied to the value it turns before into after and
// after into before, so one 16-byte record serves both directions, and a state can be walked either way
// through the log. One kind changes many values at once: an `epoch` forgets a whole search. What was
// forgotten is not in the log; who walks back over an epoch takes the state before it from the Timeline.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "core/base/bit_cast.hpp"
#include "core/base/cell.hpp"

namespace replan {

/// What an event is about. The first group changes a value of a node, the second a value of the whole run,
/// the third says that something happened.
enum class EventKind : std::uint8_t {
  // Values per node, 64 bits wide
  g,      ///< cost to the goal (A*: from the start), raw Cost
  rhs,    ///< one-step lookahead of g, raw Cost
  queue,  ///< first key component while in the open list, raw Cost + 1; 0 = not in the list
  lp,     ///< local parent, node + 1; 0 = none
  rp,     ///< remote parent, node + 1; 0 = none
  dist,   ///< clearance penalty, raw Cost
  visit,  ///< low word: number of the latest expansion; high word: times expanded
  // Values per node, 8 bits wide
  known,  ///< obstacle on the robot's map
  truth,  ///< what stands in the world: bit 0 a wall, the rest counts the moving obstacles there
  // Values of the run; the node field holds the Scalar
  scalar,
  // What happened; `delta` is a payload.
  turn = 10,   ///< the robot turns on the spot at the node; payload: degrees, rounded
  pop,         ///< taken from the open list; payload: 1 if it goes back with a newer key
  sight,       ///< line-of-sight check from the node; payload: target | result << 32
  plan_begin,  ///< a first plan (payload 0) or the n-th replan begins
  plan_end,    ///< it is done; payload: PlanStatus
  move,        ///< the robot enters the node
  sensed,      ///< the robot sees a cell that differs from its map; payload: 1 obstacle, 0 free
  surprise,    ///< a scripted or hand-made change of the world; payload: its number in the script
  unchecked,   ///< the robot is sent along a remote parent that nobody checked; payload: target
  collision,   ///< the robot would have entered an obstacle at the node
  waiting,     ///< no path: the robot stays
  arrival,     ///< the robot stands on the goal
  gave_up,     ///< the mission ends without arrival; payload: MissionState
  new_goal,    ///< the robot has to go to the node from now on
  put_down,    ///< somebody puts the robot down at the node
  forgotten,   ///< the robot no longer counts on an obstacle that moved when it last saw it
  aim,    ///< the robot makes for the node from now on: the reachable cell nearest to its goal, or the goal
  epoch,  ///< the planner forgets its search: the kinds in kForgotten go back to what they were at first
  // Of planners that grow a tree of places (core/planners/grown_tree.hpp)
  candidate,  ///< the new place could hang on the vertex `node`; payload: the cost by it, infinite if the way is blocked
  rewired,   ///< the vertex `node` hangs on the new one from now on; payload: the cost that this saves
  rejected,  ///< the sample is given up; node: the obstacle in the way, if it is one; payload: a SampleFault
  // Of planners that breed a population of paths (core/planners/improved_ga.hpp). A `candidate` is a path there that could
  // be a parent; payload: its cost. A child can be `rejected` too.
  tried,  ///< the node could take the place of the child's cell that changes; payload: tried_bits()
};
inline constexpr int kEventKinds = static_cast<int>(EventKind::tried) + 1;

/// Why a sample does not become a vertex.
enum class SampleFault : std::uint8_t {
  blocked,   ///< an obstacle is in the way to it
  taken,     ///< there is a vertex already
  longer,    ///< the path would be no shorter over it
  path_end,  ///< an end of the path is nearest to it, and stays where it is
  twin,      ///< a child: the population has that path already
  unfit,     ///< a child: no path of the population is less fit
};

/// What a child would cost with a cell changed, and whether some way of it would hit something, in one word.
constexpr std::uint64_t tried_bits(std::int64_t raw_cost, bool hits) {
  return static_cast<std::uint64_t>(raw_cost) << 1 | (hits ? 1u : 0u);
}

inline constexpr int kWideFields = 7;    ///< EventKind::g .. visit
inline constexpr int kNarrowFields = 2;  ///< EventKind::known, truth
inline constexpr int kValueKinds = kWideFields + kNarrowFields + 1;

/// A planner may have values per node of its own besides, 64 bits wide too: own_field(0) and so on (field.hpp).
inline constexpr int kFirstOwnField = 32, kOwnFields = 8;
static_assert(kEventKinds <= kFirstOwnField);
inline constexpr int kWideSlots = kWideFields + kOwnFields;

constexpr bool is_own_field(EventKind kind) {
  return static_cast<int>(kind) >= kFirstOwnField;
}
/// Whether it changes a 64-bit value of a node.
constexpr bool is_wide(EventKind kind) {
  return static_cast<int>(kind) < kWideFields || is_own_field(kind);
}
/// The number of such a kind among all of them, from 0 on.
constexpr std::size_t wide_slot(EventKind kind) {
  const auto number = static_cast<std::size_t>(kind);
  return is_own_field(kind) ? number - kFirstOwnField + kWideFields : number;
}

/// The kind of that number.
constexpr EventKind wide_kind(std::size_t slot) {
  return static_cast<EventKind>(slot < kWideFields ? slot : slot - kWideFields + kFirstOwnField);
}

/// Values that belong to the run and not to a node.
enum class Scalar : std::uint8_t {
  km,     ///< raw Cost
  start,  ///< the search's start, node + 1
  last,   ///< s_last, node + 1
  goal,   ///< of the search, node + 1
  robot,  ///< node + 1
  moves,  ///< the robot's clock: steps and waits
  replans,
  wanted,  ///< where the robot has to go, node + 1; 0: where the search's goal is
  weight,  ///< of the estimate, where a search works it out for each plan: 2^-30, as costs are
  share,   ///< of obstacles in the rectangle from start to goal, which it makes it of: the same
  // Of a robot that drives: doubles, bit by bit (core/drive/motion.hpp).
  x,        ///< m, from the left edge of the map
  y,        ///< m, from its upper edge, downwards
  heading,  ///< rad, from x towards y
  speed,    ///< m/s
  turning,  ///< rad/s
  // Of its latest decision (core/drive/dynamic_window.hpp).
  sub_goal,    ///< the cell that it makes for, node + 1
  admissible,  ///< how many samples were, + 1; 0: it has decided nothing yet
  score,       ///< of the winner, as score_bits(); 0: there is none
  // Of a planner that grows a tree of places. Coordinates are in 2^-30 of a cell, as costs are.
  vertices,     ///< how many there are, those that were cut off among them
  root,         ///< the vertex that the others hang on, + 1
  goal_vertex,  ///< that of the goal, + 1; 0: the tree has not met it
  sample_x,     ///< of the latest sample
  sample_y,
  sample_z,
  new_x,  ///< of what became of it: the place that it was steered to
  new_y,
  new_z,
  nearest,      ///< the vertex that it was steered from, + 1
  best,         ///< the cost of the best path so far, raw; 0: there is none
  plan_sample,  ///< the number of the last sample before the plan
  gain_sample,  ///< the number of the last sample by which the path became shorter
  ball,         ///< how far around the latest new place parents were looked for, as coordinates are told
  // Of a planner that breeds a population of paths. `plan_sample` and `best` are its too: children before the plan, and the
  // cost of the fittest path that hits nothing.
  paths,         ///< how many paths it holds, the child's among them
  child,         ///< the number of the path that is no member but the child in hand, + 1
  leader,        ///< the fittest path, + 1
  leader_cost,   ///< its cost, penalties included, raw
  mean_cost,     ///< of all members at the end of the latest generation, raw
  generation,    ///< those that have ended
  mother,        ///< the path that the child begins as, + 1
  father,        ///< the one that it goes on as, + 1
  taken,         ///< how many cells it has of its mother
  joined,        ///< the place in its father from which on it has his
  crossed_at,    ///< the last cell that it has of its mother, node + 1
  changed_from,  ///< the cell of it that mutation replaced, node + 1; 0: it replaced none
  changed_to,    ///< what stands there now, node + 1
  count
};

/// How the 64 bits of a scalar are to be read.
enum class ScalarType : std::uint8_t {
  node,        ///< node + 1; 0 = none
  cost,        ///< raw Cost
  found_cost,  ///< the same; 0 = none was found
  count,       ///< a whole number
  some_count,  ///< the same + 1; 0 = none
  real,        ///< a double, bit by bit
  score,       ///< as score_bits()
  vertex,      ///< vertex + 1; 0 = none
  path,        ///< a path of a population, + 1; 0 = none
};

constexpr ScalarType scalar_type(Scalar scalar) {
  switch (scalar) {
    case Scalar::km:
    case Scalar::weight:
    case Scalar::share:
    case Scalar::sample_x:
    case Scalar::sample_y:
    case Scalar::sample_z:
    case Scalar::new_x:
    case Scalar::new_y:
    case Scalar::new_z:
    case Scalar::ball:
    case Scalar::leader_cost:
    case Scalar::mean_cost:
      return ScalarType::cost;
    case Scalar::best:
      return ScalarType::found_cost;
    case Scalar::moves:
    case Scalar::replans:
    case Scalar::vertices:
    case Scalar::plan_sample:
    case Scalar::gain_sample:
    case Scalar::paths:
    case Scalar::generation:
    case Scalar::taken:
    case Scalar::joined:
      return ScalarType::count;
    case Scalar::admissible:
      return ScalarType::some_count;
    case Scalar::x:
    case Scalar::y:
    case Scalar::heading:
    case Scalar::speed:
    case Scalar::turning:
      return ScalarType::real;
    case Scalar::score:
      return ScalarType::score;
    case Scalar::root:
    case Scalar::goal_vertex:
    case Scalar::nearest:
      return ScalarType::vertex;
    case Scalar::child:
    case Scalar::leader:
    case Scalar::mother:
    case Scalar::father:
      return ScalarType::path;
    default:
      return ScalarType::node;
  }
}

/// A score as its scalar holds it: infinite, which stands for none, is 0, as all scalars are at first.
constexpr std::uint64_t score_bits(double score) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  return bit_cast<std::uint64_t>(score) ^ bit_cast<std::uint64_t>(kNone);
}
constexpr double score_of(std::uint64_t bits) {
  return bit_cast<double>(bits ^ score_bits(0));
}

/// Whether the node of such an event is the number of a vertex.
constexpr bool is_of_vertex(EventKind kind) {
  return kind == EventKind::candidate || kind == EventKind::rewired;
}

/// A set of kinds.
class KindSet {
 public:
  constexpr KindSet() = default;
  constexpr KindSet(std::initializer_list<EventKind> kinds) {
    for (const EventKind kind : kinds) bits_ |= bit(kind);
  }
  [[nodiscard]] constexpr bool has(EventKind kind) const { return (bits_ & bit(kind)) != 0; }
  [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
  [[nodiscard]] constexpr bool meets(const KindSet& other) const { return (bits_ & other.bits_) != 0; }
  constexpr void add(EventKind kind) { bits_ |= bit(kind); }
  friend constexpr bool operator==(const KindSet&, const KindSet&) = default;

 private:
  static constexpr std::uint64_t bit(EventKind kind) {
    return std::uint64_t{1} << static_cast<unsigned>(kind);
  }
  std::uint64_t bits_ = 0;
};
static_assert(kFirstOwnField + kOwnFields <= 64);

/// The values of nodes that an epoch makes the initial ones again, besides a planner's own that are declared so.
/// The penalties stay: they are the map's.
inline constexpr KindSet kForgotten{EventKind::g,  EventKind::rhs, EventKind::queue,
                                    EventKind::lp, EventKind::rp,  EventKind::visit};

/// The most vertices of a tree: those of one table of values.
inline constexpr std::size_t kMostVertices = std::size_t{1} << 20;
/// How many cells a path of a population has room for.
inline constexpr std::uint32_t kPlacesOfPath = 1024;

/// One record of the log.
struct Event {
  std::uint64_t delta = 0;  ///< before XOR after, or a payload
  NodeId node = kNoNode;
  EventKind kind = EventKind::pop;
  std::uint8_t line = 0;  ///< pseudo-code line, as numbered in the planner's page
  std::uint16_t reserved =
      0;  ///< zero; keeps the record free of padding, so that logs can be hashed bytewise

  [[nodiscard]] constexpr bool changes_value() const {
    return static_cast<int>(kind) < kValueKinds || is_own_field(kind);
  }
  friend constexpr bool operator==(const Event&, const Event&) = default;
};
static_assert(sizeof(Event) == 16);

}  // namespace replan
