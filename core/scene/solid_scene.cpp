#include "core/scene/solid_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/routes.hpp"
#include "core/scene/script.hpp"
#include "core/scene/sonar.hpp"
#include "core/scene/spline_marks.hpp"

namespace replan {
namespace {

/// More cells of the open list than these are left out.
constexpr std::size_t kMostBoxes = 60'000;
/// Half of the side of their cubes.
constexpr double kWaitingHalf = 0.2;
/// Parents' arrows are drawn in layers of no more cells.
constexpr int kMostArrows = 20'000;

class SolidBuilder {
 public:
  SolidBuilder(SceneContext& context, const Slice& slice, const SolidOptions& options, const Point& eye,
               SolidScene& scene)
      : context_(context), scene_(scene), slice_(sheet_of(context.run.lattice(), slice)) {
    if (options.see_through) scene_.opacity = 0.3f;
    if (options.cut || options.slice_alone) cut(eye);
    alone_ = options.slice_alone;
  }

  void build() {
    add_world();
    add_slice();
    if (context_.has(Overlay::queue) && !alone_) add_open_list();
    if (context_.has(Overlay::lp)) add_parents();
    if (context_.has(Overlay::sensor)) add_sensor();
    if (context_.has(Overlay::script)) add_ways();
    if (context_.has(Overlay::trail))
      add_way(trail_points(context_), faded(context_.palette.robot, 0.8), 2, Sign::trail);
    if (context_.has(Overlay::path)) {
      const PathLine path = path_line(context_);
      add_way(path.points, faded(context_.palette.path, path.searching ? 0.4 : 1), 3.5f, Sign::path);
    }
    if (context_.has(Overlay::spline)) add_spline();
    add_marks();
    show(Sign::obstacle);
    scene_.signs = context_.scene.signs;
  }

 private:
  void cut(const Point& eye) {
    SolidCut cut{slice_.box.along(), 0, true};
    cut.at = slice_.layer + 0.5;
    cut.keeps_lower = !cut.shows(eye);
    cut.at = slice_.layer + (cut.keeps_lower ? 1 : 0);
    scene_.cut_faces = cut_faces(context_.run, cut.across, slice_.layer, cut.keeps_lower,
                                 mix(context_.palette.obstacle, context_.palette.text, 0.22f));
    scene_.cut = cut;
  }

  void show(Sign sign) { context_.scene.show(sign); }

  void add_way(const std::vector<Point>& points, Colour colour, float width, Sign sign) {
    if (points.size() > 1) show(sign);
    add_line(points, colour, width);
  }
  void add_line(const std::vector<Point>& points, Colour colour, float width) {
    for (std::size_t i = 1; i < points.size(); ++i) add_line(points[i - 1], points[i], colour, width);
  }
  void add_line(const Point& a, const Point& b, Colour colour, float width) {
    const auto narrow = [](double value) { return static_cast<float>(value); };
    scene_.lines.push_back({{narrow(a.x), narrow(a.y), narrow(a.z)},
                            {narrow(b.x), narrow(b.y), narrow(b.z)},
                            colour,
                            width * static_cast<float>(context_.view.scale)});
  }

  /// The edges of a box, between two opposite corners.
  void add_edges(const Point& low, const Point& high, Colour colour, float width) {
    const std::array<Point, 2> ends = {low, high};
    const auto corner = [&](unsigned bits) {
      return Point{ends[bits & 1u].x, ends[bits >> 1 & 1u].y, ends[bits >> 2 & 1u].z};
    };
    for (unsigned from = 0; from < 8; ++from)
      for (unsigned bit = 1; bit < 8; bit <<= 1)
        if ((from & bit) == 0) add_line(corner(from), corner(from | bit), colour, width);
  }

  void add_world() {
    const Box& world = context_.run.lattice();
    add_edges({},
              {static_cast<double>(world.width()), static_cast<double>(world.height()),
               static_cast<double>(world.depth())},
              faded(context_.palette.dim, 0.45), 1);
  }

  /// A frame around the layer that the slice shows.
  void add_slice() {
    const SeenBox& box = slice_.box;
    const double at = slice_.layer + 0.5;
    const std::array<Point, 4> corners = {
        box.world(Point{0, 0, at}), box.world(Point{static_cast<double>(box.width()), 0, at}),
        box.world(Point{static_cast<double>(box.width()), static_cast<double>(box.height()), at}),
        box.world(Point{0, static_cast<double>(box.height()), at})};
    for (std::size_t i = 0; i < 4; ++i)
      add_line(corners[i], corners[(i + 1) % 4], context_.palette.accent, 1.6f);
  }

  void add_box(const Point& centre, double half, Colour colour) {
    if (scene_.cut && !scene_.cut->shows(centre)) return;
    const auto narrow = [](double value) { return static_cast<float>(value); };
    scene_.boxes.push_back({{narrow(centre.x - half), narrow(centre.y - half), narrow(centre.z - half)},
                            {narrow(centre.x + half), narrow(centre.y + half), narrow(centre.z + half)},
                            colour});
  }

  void add_open_list() {
    constexpr NodeId kPage = SearchState::kPage;
    const auto end = static_cast<NodeId>(context_.run.lattice().node_count());
    if (context_.state.queue_size() > 0) show(Sign::queue);
    for (NodeId first = 0; first < end; first += kPage) {
      const std::uint64_t* page = context_.state.page(EventKind::queue, first);
      if (page == nullptr) continue;
      for (NodeId node = first; node < std::min(end, first + kPage); ++node) {
        if (page[node % kPage] == 0) continue;
        if (scene_.boxes.size() >= kMostBoxes) {
          scene_.left_out = true;
          return;
        }
        add_box(context_.centre(node), kWaitingHalf, context_.palette.accent);
      }
    }
  }

  /// In the slice alone: everywhere they would hide each other.
  void add_parents() {
    const SeenBox& box = slice_.box;
    if (static_cast<std::int64_t>(box.width()) * box.height() > kMostArrows) return;
    const Box& world = context_.run.lattice();
    for (int row = 0; row < box.height(); ++row)
      for (int column = 0; column < box.width(); ++column) {
        const NodeId node = world.node(slice_.cell(column, row)), parent = context_.state.lp(node);
        if (parent == kNoNode || parent == node || context_.state.known_blocked(node)) continue;
        const Point from = context_.centre(node), to = context_.centre(parent);
        const auto part = [&](double t) {
          return Point{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                       from.z + t * (to.z - from.z)};
        };
        show(Sign::lp);
        add_line(part(-0.2), part(0.2), context_.palette.arrow, 1);
        add_line(part(0.2), part(0.32), context_.palette.arrow, 2.6f);
      }
  }

  void add_sensor() {
    const RobotSetup& robot = context_.run.scenario().robot;
    if (robot.knowledge == Knowledge::all) return;
    show(Sign::sensor);
    const SonarReach reach{robot_point(context_), course_of_robot(context_), robot.sensor_radius,
                           robot.sensor_angle};
    for (const std::vector<Point>& wire : wires_of(reach))
      add_line(wire, faded(context_.palette.robot, 0.6), 1.2f);
  }

  /// The control polygon of a path that is a curve, and where it was pulled in, with the obstacle that it would have hit.
  void add_spline() {
    const Spline* spline = spline_at_cursor(context_.run);
    if (spline == nullptr) return;
    add_way(spline->control, faded(context_.palette.dim, 0.8), 1.2f, Sign::control);
    for (const PullIn& pull : spline->pulled_in) {
      show(Sign::pulled_in);
      add_line(pull.at, centre_of(pull.cell), context_.palette.warning, 2);
    }
  }

  void add_ways() {
    for (const MovingObstacle& mover : context_.run.scenario().movers) {
      show(Sign::mover);
      std::vector<Point> way = way_points(mover);
      if (mover.at_end == WayEnd::loop && way.size() > 2) way.push_back(way.front());
      add_line(way, faded(context_.palette.mover, 0.7), 1.4f);
    }
  }

  void add_marks() {
    const Palette& palette = context_.palette;
    const Scenario& scenario = context_.run.scenario();
    using enum SolidMark::Shape;
    scene_.marks.push_back({star, centre_of(scenario.start), palette.start});
    scene_.marks.push_back({diamond, goal_point(context_), palette.goal});
    if (context_.view.pinned) {
      const Point low{static_cast<double>(context_.view.pinned->x),
                      static_cast<double>(context_.view.pinned->y),
                      static_cast<double>(context_.view.pinned->z)};
      add_edges(low, {low.x + 1, low.y + 1, low.z + 1}, palette.accent, 2);
    }
    if (!robot_has_set_out(context_)) return;
    show(Sign::robot);
    const Point at = robot_point(context_);
    scene_.marks.push_back({robot, at, palette.robot});
    if (shows_course(context_)) add_line(nose_of(at, course_of_robot(context_)), palette.robot, 3.5f);
  }

  SceneContext& context_;
  SolidScene& scene_;
  Sheet slice_;
  bool alone_ = false;  // of all obstacles those of the slice are drawn
};

}  // namespace

SolidScene build_solid_scene(const Run& run, const View& view, const SolidOptions& options, const Point& eye,
                             const Palette& palette, SceneMemory& memory) {
  Scene plane;
  plane.camera.zoom = 1;
  // Seen along z the coordinates of a view are the world's.
  View upright = view;
  upright.slice.along = Axis::z;
  SceneContext context{run, upright, palette, memory.of(run), plane};
  SolidScene scene;
  SolidBuilder(context, view.slice, options, eye, scene).build();
  return scene;
}

std::optional<Cell> cell_on_ray(const Run& run, const SolidScene& scene, const Ray& ray) {
  const SearchState& state = run.timeline().state();
  const Box& world = run.lattice();
  const bool waiting_show = scene.signs[static_cast<std::size_t>(Sign::queue)];
  const auto shown = [&](Cell cell) { return !scene.cut || scene.cut->shows(centre_of(cell)); };
  const auto solid = [&](NodeId node) { return state.truly_blocked(node) || state.known_blocked(node); };
  return first_on_ray(world, ray, [&](Cell cell, Cell before) {
    if (!shown(cell)) return false;
    const NodeId node = world.node(cell);
    if (waiting_show && state.queued(node) && meets_cube(ray, centre_of(cell), kWaitingHalf)) return true;
    if (scene.opacity < 1 || !solid(node) || !world.contains(before)) return false;
    // A face is drawn between an obstacle and what is none, or what is cut away.
    return !solid(world.node(before)) || !shown(before);
  });
}

}  // namespace replan
