// What runs across cells: path, trail, sight checks; and the things that stand on them.
#include "core/scene/routes.hpp"

#include <cmath>

#include "core/plan/population_values.hpp"
#include "core/plan/tree_values.hpp"
#include "core/scene/numbers.hpp"
#include "core/scene/sonar.hpp"
#include "core/scene/spline_marks.hpp"

namespace replan {
namespace {

/// Where the robot is, or will be put.
NodeId robot_node(const SceneContext& context) {
  const NodeId robot = context.state.node(Scalar::robot);
  return robot == kNoNode ? context.run.lattice().node(context.run.scenario().start) : robot;
}

}  // namespace

Point goal_point(const SceneContext& context) {
  const NodeId goal = context.state.wanted_goal();
  return goal == kNoNode ? context.centre(context.seen(context.run.scenario().goal)) : context.centre(goal);
}

Point robot_point(const SceneContext& context) {
  const Decision* decision = context.run.decision_at(context.cursor);
  if (decision == nullptr) return context.centre(robot_node(context));
  const double travel = std::min(context.run.travel(), 1.0);
  const auto between = [travel](double from, double to) { return to + (1 - travel) * (from - to); };
  return context.seen(Point{between(decision->before.x, decision->at.x),
                            between(decision->before.y, decision->at.y),
                            between(decision->before.z, decision->at.z)});
}

namespace {

/// The path from the robot on.
std::vector<Point> ahead(const SceneContext& context, const Decision& decision) {
  const Path& path = *decision.plan->path;
  std::vector<Point> rest;
  if (path.empty()) return rest;
  rest.push_back(robot_point(context));
  double walked = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    walked += distance(path.point(i - 1), path.point(i));
    if (walked > decision.along_plan + 1e-9) rest.push_back(context.seen(path.point(i)));
  }
  return rest;
}

/// The path of a tree of samples while no plan stands yet, in which it becomes shorter.
std::vector<Point> best_way_so_far(const SceneContext& context) {
  std::vector<Point> points =
      way_in_tree(context.state, goal_vertex(context.state), context.run.lattice().solid());
  for (Point& point : points) point = context.seen(point);
  return points;
}

/// The fittest path of a population while no plan stands yet, if it hits nothing.
std::vector<Point> way_of_leader(const SceneContext& context) {
  std::vector<Point> points;
  if (context.state.scalar(Scalar::best) != 0)
    for (const PathPlace& place : bred_path(context.state, path_named(context.state, Scalar::leader)))
      points.push_back(context.centre(place.cell));
  return points;
}

/// The lp chain from the start while no plan stands yet; empty unless it reaches the goal.
std::vector<Point> chain_of_parents(const SceneContext& context) {
  const NodeId from = context.state.node(Scalar::start), to = context.state.node(Scalar::goal);
  if (from == kNoNode || to == kNoNode) return {};
  std::vector<NodeId> chain = {context.run.info().from_goal ? from : to};
  const NodeId end = context.run.info().from_goal ? to : from;
  while (chain.back() != end) {
    const NodeId next = context.state.lp(chain.back());
    if (next == kNoNode || chain.size() > context.lattice.node_count()) return {};
    chain.push_back(next);
  }
  std::vector<Point> points;
  for (const NodeId node : chain) points.push_back(context.centre(node));
  return points;
}

}  // namespace

PathLine path_line(const SceneContext& context) {
  const RunDigest& digest = context.memory.digest;
  const std::size_t plans = digest.plans_before(context.cursor);
  const bool searching = plans > 0 && digest.plans()[plans - 1].end > context.cursor;
  const Decision* decision = context.run.decision_at(context.cursor);
  if (searching && context.run.info().sampling) return {best_way_so_far(context), searching};
  if (searching && context.run.info().evolving) return {way_of_leader(context), searching};
  if (decision != nullptr) return {ahead(context, *decision), searching};
  return {searching ? chain_of_parents(context) : std::vector<Point>(), searching};
}

std::vector<Point> trail_points(const SceneContext& context) {
  std::vector<Point> points;
  for (const Decision& decision : context.run.decisions()) {
    if (decision.event > context.cursor) break;
    if (decision.plan->path->empty()) continue;  // it stood still
    if (const Point at = context.seen(decision.at); points.empty() || points.back() != at)
      points.push_back(at);
  }
  if (context.run.travel() < 1 && !points.empty()) points.back() = robot_point(context);
  return points;
}

std::vector<SightCheck> sight_checks(const SceneContext& context) {
  const Timeline& log = context.run.timeline();
  const std::size_t most = 4096;  // reading out a path may check as many segments as it has
  const std::size_t first = context.cursor > most ? context.cursor - most : 0;
  std::vector<SightCheck> checks;
  NodeId asks = kNoNode;
  for (std::size_t i = context.cursor; i-- > first;) {
    const Event& event = log.event(i);
    if (event.kind == EventKind::pop || event.kind == EventKind::plan_begin || event.kind == EventKind::move)
      break;
    // The vertex before has found where it leaps to: what comes earlier are its checks.
    if (event.kind == EventKind::rp && asks != kNoNode && event.node != asks) break;
    if (event.kind != EventKind::sight) continue;
    asks = event.node;
    checks.push_back({context.centre(event.node), context.centre(static_cast<NodeId>(event.delta)),
                      (event.delta >> 32) != 0});
  }
  return checks;
}

bool robot_has_set_out(const SceneContext& context) {
  const Decision* decision = context.run.decision_at(context.cursor);
  if (decision == nullptr) return false;
  const NodeId start = context.run.lattice().node(context.run.scenario().start);
  return robot_node(context) != start || decision->clock != 0;
}

namespace {

void add_path(SceneContext& context) {
  const auto [points, searching] = path_line(context);
  if (points.size() < 2) return;
  Polyline line{points, context.palette.path, context.line_width(3), 0};
  if (searching) line.colour = faded(line.colour, 0.4);
  context.scene.show(Sign::path);
  add_through_layers(context, std::move(line));
  const double dots = context.grown(10, 14);  // in smaller cells they would hide the path
  // A curve's points are no corners: those of its control polygon have an overlay of their own.
  const bool curve = spline_at_cursor(context.run) != nullptr;
  if (!context.has(Overlay::rp) || !context.run.info().any_angle || dots <= 0 || curve) return;
  context.scene.show(Sign::rp);
  const Colour colour = faded(context.palette.accent, searching ? dots / 2 : dots);
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    context.add(Disc{points[i], context.pixels(4), context.seen_at(points[i], colour), 0, 0});
}

void add_trail(SceneContext& context) {
  Polyline line{trail_points(context), faded(context.palette.robot, 0.75), context.line_width(2), 0};
  if (line.points.size() < 2) return;
  context.scene.show(Sign::trail);
  add_through_layers(context, std::move(line));
}

void add_cross(SceneContext& context, Point at, Colour colour) {
  const double arm = context.world(4);
  context.add(Line{{at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, colour, context.pixels(2)});
  context.add(Line{{at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, colour, context.pixels(2)});
}

/// A stopped ray ends in a cross.
void add_sight(SceneContext& context) {
  for (const auto& [from, to, free] : sight_checks(context)) {
    const Colour colour = free ? context.palette.good : context.palette.bad;
    context.scene.show(free ? Sign::sight_free : Sign::sight_stopped);
    if (context.lattice.solid())
      add_through_layers(context, {{from, to}, colour, context.pixels(1.6), 0});
    else
      context.add(Line{from, to, colour, context.pixels(1.6)});
    const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2, (from.z + to.z) / 2};
    if (!free) add_cross(context, middle, context.seen_at(middle, colour));
  }
}

/// The robot's course as the view sees it.
Course seen_course(const SceneContext& context) {
  const Course course = course_of_robot(context);
  return course_towards(context.seen(Point{}), context.seen(Point{course.x, course.y, course.z}));
}

double heading(const SceneContext& context) {
  if (shows_course(context)) {
    const Course course = seen_course(context);
    return std::atan2(course.y, course.x);
  }
  const Decision* decision = context.run.decision_at(context.cursor);
  if (decision == nullptr || decision->after == decision->at) return 0;
  const Point from = robot_point(context), to = context.seen(decision->after);
  return std::atan2(to.y - from.y, to.x - from.x);
}

void add_sensor(SceneContext& context) {
  const RobotSetup& setup = context.run.scenario().robot;
  if (!context.has(Overlay::sensor) || setup.knowledge == Knowledge::all) return;
  const Point robot = robot_point(context);
  const double radius = context.cut_radius(robot, setup.sensor_radius);
  if (radius <= 0 && context.lattice.solid()) return;
  context.scene.show(Sign::sensor);
  if (setup.sensor_angle < 360) {
    const SonarReach reach{robot, seen_course(context), setup.sensor_radius, setup.sensor_angle};
    const double off = context.lattice.solid() ? context.slice + 0.5 - robot.z : 0;
    context.add(Polyline{outline_in_plane(reach, off), context.palette.robot, context.pixels(1.2), 0,
                         context.pixels(4)});
    return;
  }
  context.add(Ring{robot, radius, context.palette.robot, context.pixels(1.2), context.pixels(4)});
}

/// The body of a robot with a size: as large as it is, under the mark that tells where it is.
void add_body(SceneContext& context) {
  const Point robot = robot_point(context);
  const double radius = context.cut_radius(robot, context.run.scenario().robot.radius);
  if (radius <= 0) return;
  const auto pixels = static_cast<float>(radius * context.zoom);
  context.add(Disc{robot, pixels, faded(context.palette.robot, 0.25), 0, 0});
  context.add(Ring{robot, radius, context.palette.robot, context.pixels(1.5)});
}

/// Where cells are too small to be found by their frame, a ring stands around the one that is pointed at.
void ring_small_cell(SceneContext& context, Cell cell) {
  constexpr double kFoundFrom = 8;  // design pixels a cell
  if (context.zoom / context.view.scale >= kFoundFrom || !context.in_sight(cell)) return;
  const Point at = SceneContext::centre(cell);
  const double radius = context.world(kFoundFrom);
  context.add(Ring{at, radius, context.palette.outline, context.pixels(3.5)});
  context.add(Ring{at, radius, context.palette.text, context.pixels(1.5)});
}

void add_cell_frames(SceneContext& context) {
  const auto frame = [&](Cell cell, Colour colour, double stroke) {
    if (!context.lattice.contains(cell) || cell.z != context.slice) return;
    const auto x = static_cast<double>(cell.x), y = static_cast<double>(cell.y);
    context.add(Outline{x, y, 1, 1, OutlineShape::square, colour, context.pixels(stroke), 0});
  };
  if (context.view.hovered) {
    const Cell hovered = context.seen(*context.view.hovered);
    frame(hovered, faded(context.palette.text, 0.6), 1.2);
    ring_small_cell(context, hovered);
  }
  if (!context.view.pinned) return;
  frame(context.seen(*context.view.pinned), context.palette.accent, 2);
}

/// Where a cell's numbers leave no room for a disc: a frame around them.
bool frame_thing(SceneContext& context, const Disc& disc) {
  const NumberLayout layout(context);
  const Cell cell = cell_of(disc.centre);
  if (!layout.close || layout.waiting == NumbersShown::none || !context.in_sight(cell) ||
      !waits(context, context.lattice.node(cell)))
    return false;
  const auto frame = [&](Colour colour, double stroke) {
    context.add(Outline{static_cast<double>(cell.x), static_cast<double>(cell.y), 1, 1, OutlineShape::square,
                        colour, context.pixels(stroke), 0});
  };
  frame(disc.rim, 4);
  frame(disc.fill, 3);
  return true;
}

void add_thing(SceneContext& context, Disc disc) {
  if (frame_thing(context, disc)) return;
  disc.fill = context.seen_at(disc.centre, disc.fill);
  disc.rim = context.seen_at(disc.centre, disc.rim);
  context.add(disc);
}

/// The reachable cell nearest to the goal, where the robot makes for that one.
void add_nearest(SceneContext& context, float radius) {
  const NodeId aim = context.state.node(Scalar::goal);
  if (aim == kNoNode || aim == context.state.wanted_goal()) return;
  context.scene.show(Sign::nearest);
  add_through_layers(context, {{context.centre(aim), goal_point(context)},
                               faded(context.palette.goal, 0.7),
                               context.pixels(1.5),
                               0,
                               context.pixels(4)});
  add_thing(context, {context.centre(aim), radius * 0.8f, context.palette.background, context.palette.goal,
                      context.pixels(2.5), Glyph::none});
}

}  // namespace

void build_routes(SceneContext& context) {
  if (context.has(Overlay::trail)) add_trail(context);
  if (context.has(Overlay::path)) add_path(context);
  if (context.has(Overlay::sight)) add_sight(context);
}

void build_things(SceneContext& context) {
  add_sensor(context);
  add_body(context);
  add_cell_frames(context);
  // Never so small that they are lost, never so large that they hide their cell.
  const double cell = context.zoom / context.view.scale;
  const bool numbers = NumberLayout(context).waiting != NumbersShown::none;
  const auto radius = context.pixels(std::clamp(cell * 0.4, 6.0, numbers ? 8.0 : 11.0));
  const float rim = context.pixels(2);
  const Palette& palette = context.palette;
  const Scenario& scenario = context.run.scenario();
  add_thing(context, {context.centre(context.seen(scenario.start)), radius, palette.start, palette.outline,
                      rim, Glyph::dot});
  add_nearest(context, radius);
  add_thing(context,
            {goal_point(context), radius * 1.15f, palette.goal, palette.outline, rim, Glyph::target});
  if (!robot_has_set_out(context)) return;
  context.scene.show(Sign::robot);
  add_thing(context, {robot_point(context), radius, palette.robot, palette.outline, rim, Glyph::heading,
                      heading(context)});
}

}  // namespace replan
