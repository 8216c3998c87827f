// The values that a planner keeps for each node, declared: what readers of its log know of them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/cost.hpp"
#include "core/trace/event.hpp"

namespace replan {

/// How the 64 bits of a value are to be read.
enum class FieldType : std::uint8_t {
  cost,      ///< raw Cost
  queue,     ///< raw Cost + 1 of the first key component while in the open list; 0 = not in it
  node,      ///< node + 1; 0 = none
  visits,    ///< low word: number of the latest expansion; high word: times expanded
  count,     ///< a whole number
  name,      ///< the index of one of `names`
  obstacle,  ///< nonzero = obstacle
  vertex,    ///< vertex + 1; 0 = none
};

/// What a field has a value for.
enum class FieldTable : std::uint8_t {
  nodes,     ///< each node of the map
  vertices,  ///< each vertex of a tree: 0 .. kMostVertices - 1
  paths,     ///< each path of a population, by its number
  places,    ///< each place in each of them: kPlacesOfPath * path + place
};

/// One value per node. A planner declares those that it writes (PlannerInfo::fields); windows, conditions,
/// histories and exports read what it has declared.
struct Field {
  EventKind kind{};            ///< its id in events
  std::string_view name = {};  ///< in files and conditions: "rhs"
  FieldType type = FieldType::cost;
  std::string_view label = {};  ///< in the window, next to a value: "rhs"
  std::string_view help = {};   ///< a sentence that teaches
  std::uint64_t initial = 0;
  bool forgotten = true;                         ///< an epoch makes it `initial` again
  std::span<const std::string_view> names = {};  ///< of FieldType::name
  bool shown = true;  ///< off: the planner writes it, and neither it nor a user has any use for it
  FieldTable table = FieldTable::nodes;
};

/// The id of the i-th value of a planner's own, besides those below; at most kOwnFields.
constexpr EventKind own_field(int i) {
  return static_cast<EventKind>(kFirstOwnField + i);
}

/// Fields that planners share. A planner may declare one under another label.
namespace fields {

inline constexpr auto kInfinite = static_cast<std::uint64_t>(Cost::kInfinityRaw);

inline constexpr Field kG{EventKind::g,
                          "g",
                          FieldType::cost,
                          "g",
                          "The cost to the goal (of a search from the start: from there), as settled last.",
                          kInfinite};
inline constexpr Field kRhs{
    EventKind::rhs, "rhs", FieldType::cost, "rhs", "One step of lookahead: the least c + g.", kInfinite};
inline constexpr Field kQueue{EventKind::queue, "queue", FieldType::queue, "k1",
                              "The first part of its key while it waits in the open list."};
inline constexpr Field kLp{EventKind::lp, "lp", FieldType::node, "lp",
                           "Its local parent: the neighbour that it leads to."};
inline constexpr Field kRp{EventKind::rp, "rp", FieldType::node, "rp",
                           "Its remote parent: the vertex in sight that it leads to."};
inline constexpr Field kDist{.kind = EventKind::dist,
                             .name = "dist",
                             .type = FieldType::cost,
                             .label = "dist",
                             .help = "The penalty that it costs for lying near an obstacle.",
                             .forgotten = false};
inline constexpr Field kVisit{EventKind::visit, "visit", FieldType::visits, "expanded",
                              "When it was expanded last, and how often."};
inline constexpr Field kKnown{.kind = EventKind::known,
                              .name = "known",
                              .type = FieldType::obstacle,
                              .label = "known",
                              .help = "Whether it is an obstacle on the robot's map.",
                              .forgotten = false};
inline constexpr Field kTruth{.kind = EventKind::truth,
                              .name = "truth",
                              .type = FieldType::obstacle,
                              .label = "world",
                              .help = "Whether something stands there in the world.",
                              .forgotten = false};

/// Of a search that interpolates, its own.
inline constexpr Field kSide{
    own_field(0), "side", FieldType::node, "side",
    "Its way leads to a point between lp and this cell. None: it leads to lp itself."};

/// Of a search whose costs rise and fall in waves (SearchValues::waves), its own. Whether a node is in the open list, was
/// never in it, or was and is no longer:
enum class StateTag : std::uint8_t { fresh, open, closed };
inline constexpr std::string_view kTagNames[] = {"NEW", "OPEN", "CLOSED"};
inline constexpr Field kTag{
    .kind = own_field(0),
    .name = "tag",
    .type = FieldType::name,
    .label = "tag",
    .help = "NEW: it was never in the open list. OPEN: it is in it. CLOSED: it was, and is no longer.",
    .names = kTagNames};
inline constexpr Field kLowest{
    own_field(1),
    "k",
    FieldType::cost,
    "k",
    "The least that h was since it came into the open list. Less than h: its way became dearer (RAISE).",
    kInfinite};
inline constexpr Field kFocused{own_field(2),
                                "f",
                                FieldType::cost,
                                "f",
                                "k and the estimate of the way to it from where the robot stood.",
                                kInfinite};
/// As such a search calls the others.
inline constexpr Field kH{EventKind::g,
                          "g",
                          FieldType::cost,
                          "h",
                          "The cost of the way to the goal along its back-pointers, as far as is known.",
                          kInfinite};
inline constexpr Field kBack{EventKind::lp, "lp", FieldType::node, "b",
                             "Its back-pointer: the neighbour that its way to the goal leads to."};
inline constexpr Field kQueueByLowest{EventKind::queue, "queue", FieldType::queue, "k",
                                      "k while it waits in the open list."};
inline constexpr Field kQueueByBias{
    EventKind::queue, "queue", FieldType::queue, "f_B",
    "f and what moves of the robot had come to, while it waits in the open list."};

/// As a planner that draws samples calls it: the cell that one lies in.
inline constexpr Field kSampled{EventKind::visit, "visit", FieldType::visits, "sampled",
                                "When a sample lay in it last, and how many have."};
/// Of a tree of places, its own: for each vertex.
inline constexpr Field kVertexX{.kind = own_field(0),
                                .name = "vertex_x",
                                .label = "x",
                                .help = "How far from the left edge the vertex lies.",
                                .table = FieldTable::vertices};
inline constexpr Field kVertexY{.kind = own_field(1),
                                .name = "vertex_y",
                                .label = "y",
                                .help = "How far from the upper edge the vertex lies.",
                                .table = FieldTable::vertices};
inline constexpr Field kVertexZ{.kind = own_field(2),
                                .name = "vertex_z",
                                .label = "z",
                                .help = "How far above the bottom the vertex lies.",
                                .table = FieldTable::vertices};
inline constexpr Field kVertexParent{.kind = own_field(3),
                                     .name = "vertex_parent",
                                     .type = FieldType::vertex,
                                     .label = "parent",
                                     .help = "The vertex that it hangs on.",
                                     .table = FieldTable::vertices};
inline constexpr Field kVertexCost{.kind = own_field(4),
                                   .name = "vertex_cost",
                                   .label = "cost",
                                   .help = "The length of the way to it from the root of the tree.",
                                   .initial = kInfinite,
                                   .table = FieldTable::vertices};

inline constexpr std::string_view kSideNames[] = {"start", "goal"};
inline constexpr Field kVertexSide{.kind = own_field(5),
                                   .name = "vertex_side",
                                   .type = FieldType::name,
                                   .label = "grew from",
                                   .help = "The end that its tree grew from.",
                                   .names = kSideNames,
                                   .table = FieldTable::vertices};

/// As a planner that breeds paths calls it: the cell at which a child was changed, or its parents were crossed.
inline constexpr Field kBred{EventKind::visit, "visit", FieldType::visits, "bred",
                             "When a path was changed or two were crossed there last, and how often."};
/// Of a population of paths, its own (core/plan/population_values.hpp).
inline constexpr Field kPathCell{.kind = own_field(0),
                                 .name = "path_cell",
                                 .type = FieldType::node,
                                 .label = "cell",
                                 .help = "The cell that a path of the population leads over.",
                                 .table = FieldTable::places};
inline constexpr Field kPathHit{
    .kind = own_field(1),
    .name = "path_hit",
    .type = FieldType::node,
    .label = "obstacle",
    .help = "The obstacle in the straight way from there to the path's next cell.",
    .table = FieldTable::places};
inline constexpr Field kPathCost{
    .kind = own_field(2),
    .name = "path_cost",
    .label = "cost",
    .help = "The length of the path, and the penalty for each of its ways that hits something.",
    .initial = kInfinite,
    .table = FieldTable::paths};

/// As a search from the start calls them.
inline constexpr Field kF{EventKind::queue, "queue", FieldType::queue, "f",
                          "g + h while it waits in the open list."};
inline constexpr Field kParent{EventKind::lp, "lp", FieldType::node, "parent",
                               "The neighbour that it was reached from."};

}  // namespace fields

}  // namespace replan
