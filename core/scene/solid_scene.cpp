#include "core/scene/solid_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/overlay.hpp"
#include "core/scene/routes.hpp"
#include "core/scene/solid_pen.hpp"
#include "core/scene/sonar.hpp"

namespace replan {
namespace {

/// The edges of the world's box.
void add_world(SolidPen& pen) {
  const Box& world = pen.context().run.lattice();
  pen.edges({},
            {static_cast<double>(world.width()), static_cast<double>(world.height()),
             static_cast<double>(world.depth())},
            faded(pen.palette().dim, 0.45), 1);
}

/// A frame around the layer that the slice shows.
void add_slice(SolidPen& pen) {
  const SeenBox& box = pen.slice().box;
  const auto width = static_cast<double>(box.width()), height = static_cast<double>(box.height());
  const std::array<Point, 4> corners = {Point{0, 0, 0}, {width, 0, 0}, {width, height, 0}, {0, height, 0}};
  for (std::size_t i = 0; i < 4; ++i)
    pen.line(pen.on_sheet(box.world(corners[i])), pen.on_sheet(box.world(corners[(i + 1) % 4])),
             pen.palette().accent, 1.6f);
}

void add_pinned(SolidPen& pen, Cell cell) {
  const Point low{static_cast<double>(cell.x), static_cast<double>(cell.y), static_cast<double>(cell.z)};
  pen.edges(low, {low.x + 1, low.y + 1, low.z + 1}, pen.palette().accent, 2);
}

void add_marks(SolidPen& pen, SolidScene& scene) {
  using enum SolidMark::Shape;
  const SceneContext& context = pen.context();
  scene.marks.push_back({star, centre_of(context.run.scenario().start), pen.palette().start});
  scene.marks.push_back({diamond, goal_point(context), pen.palette().goal});
  if (!robot_has_set_out(context)) return;
  pen.show(Sign::robot);
  const Point at = robot_point(context);
  scene.marks.push_back({robot, at, pen.palette().robot});
  if (shows_course(context)) pen.polyline(nose_of(at, course_of_robot(context)), pen.palette().robot, 3.5f);
}

}  // namespace

bool shows_unknown(const View& view) {
  return view.overlays.has(Overlay::unknown);
}

SolidCut cut_at(const Sheet& slice, const Point& eye) {
  SolidCut cut{slice.box.along(), slice.layer + 0.5, true};
  cut.keeps_lower = !cut.shows(eye);
  cut.at = slice.layer + (cut.keeps_lower ? 1 : 0);
  return cut;
}

SolidScene build_solid_scene(const Run& run, const View& view, const SolidOptions& options, const Point& eye,
                             const Palette& palette, SceneMemory& memory, const Deadline& deadline) {
  const Sheet slice = sheet_of(run.lattice(), view.slice);
  SolidScene scene;
  scene.slice = slice;
  scene.shows_unknown = shows_unknown(view);
  if (options.see_through) scene.opacity = 0.3f;
  if (options.cut || options.slice_alone) {
    scene.cut = cut_at(slice, eye);
    scene.cut_faces =
        cut_faces(run, slice.box.along(), slice.layer, scene.cut->keeps_lower, palette, scene.shows_unknown);
  }
  Scene plane;
  plane.camera.zoom = 1;
  // Seen along z the coordinates of a view are the world's.
  View upright = view;
  upright.slice.along = Axis::z;
  SceneContext context{run, upright, palette, memory.of(run), plane};
  SolidPen pen(context, slice, options.slice_alone, deadline, scene);
  add_world(pen);
  add_slice(pen);
  build_in_space(pen);
  if (view.pinned) add_pinned(pen, *view.pinned);
  add_marks(pen, scene);
  scene.signs = plane.signs;
  if (!scene.cut_faces.empty()) scene.signs.set(static_cast<std::size_t>(Sign::obstacle));
  return scene;
}

namespace {

/// The first of what it is made of that a ray meets, and how deep.
struct Met {
  Cell cell;
  double depth = HUGE_VAL;
};

/// Where a ray enters a cell.
double depth_of(const EyeRay& ray, Cell cell) {
  double enter = 0;
  const auto clip = [&](double from, double way, int at) {
    if (way != 0) enter = std::max(enter, std::min((at - from) / way, (at + 1 - from) / way));
  };
  clip(ray.from.x, ray.direction.x, cell.x);
  clip(ray.from.y, ray.direction.y, cell.y);
  clip(ray.from.z, ray.direction.z, cell.z);
  return enter;
}

/// The nearest place of a line that a ray passes at less than `reach` times its depth.
std::optional<Met> met_path(const std::vector<Point>& path, const EyeRay& ray, double reach) {
  std::optional<Met> first;
  const auto dot = [](const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const auto minus = [](const Point& a, const Point& b) { return Point{a.x - b.x, a.y - b.y, a.z - b.z}; };
  const double square = dot(ray.direction, ray.direction);
  for (std::size_t i = 1; i < path.size(); ++i) {
    // The places of both lines that are nearest to each other.
    const Point way = minus(path[i], path[i - 1]), gap = minus(path[i - 1], ray.from);
    const double length = dot(way, way), both = dot(way, ray.direction);
    const double apart = length * square - both * both;
    const double share =
        apart > 1e-12 * length * square
            ? std::clamp((both * dot(gap, ray.direction) - square * dot(gap, way)) / apart, 0.0, 1.0)
            : 0;
    const Point at{path[i - 1].x + share * way.x, path[i - 1].y + share * way.y,
                   path[i - 1].z + share * way.z};
    const double depth = dot(minus(at, ray.from), ray.direction) / square;
    if (depth <= 0 || distance(at, ray.at(depth)) > reach * depth) continue;
    if (!first || depth < first->depth) first = Met{cell_of(at), depth};
  }
  return first;
}

/// Whether a cube was made for the cell: of a long open list not all are.
bool has_cube(const SolidScene& scene, Cell cell) {
  const auto in = [](const float* low, const float* high, int x, std::size_t axis) {
    return static_cast<float>(x) < high[axis] && low[axis] < static_cast<float>(x + 1);
  };
  return std::any_of(scene.boxes.begin(), scene.boxes.end(), [&](const SolidBox& box) {
    return in(box.low, box.high, cell.x, 0) && in(box.low, box.high, cell.y, 1) &&
           in(box.low, box.high, cell.z, 2);
  });
}

/// The cell of the picture on the slice that a ray meets, where it has a colour.
std::optional<Met> met_sheet(const SolidScene& scene, const Sheet& slice, const EyeRay& ray) {
  const SolidSheet& sheet = scene.sheet;
  if (sheet.texels.empty()) return std::nullopt;
  const Axis axis = slice.box.along();
  const double way = coordinate(ray.direction, axis);
  const double depth = (coordinate(sheet.corner, axis) - coordinate(ray.from, axis)) / way;
  if (!(depth > 0) || std::isinf(depth)) return std::nullopt;
  const Point at = slice.box.seen(ray.at(depth));
  if (!(at.x >= 0 && at.x < slice.box.width() && at.y >= 0 && at.y < slice.box.height())) return std::nullopt;
  const Cell cell = slice.cell(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
  const Cell seen = slice.box.seen(cell);
  const auto texel = static_cast<std::size_t>(seen.y) * static_cast<std::size_t>(sheet.columns) +
                     static_cast<std::size_t>(seen.x);
  return sheet.texels[texel] == 0 ? std::nullopt : std::optional(Met{cell, depth});
}

}  // namespace

std::optional<Cell> cell_on_ray(const Run& run, const SolidScene& scene, const EyeRay& ray, double reach) {
  const SearchState& state = run.timeline().state();
  const Box& world = run.lattice();
  const bool waiting_show = !scene.boxes.empty() && scene.signs[static_cast<std::size_t>(Sign::queue)];
  const auto shown = [&](Cell cell) { return !scene.cut || scene.cut->shows(centre_of(cell)); };
  const auto solid = [&](NodeId node) {
    if (state.known_blocked(node)) return true;
    if (!state.truly_blocked(node)) return false;
    return scene.shows_unknown || state.moving(node) || run.scenario().map.blocked[node] == kFree;
  };
  const auto waits = [&](Cell cell) {
    return waiting_show && shown(cell) && state.queued(world.node(cell)) &&
           meets_cube(ray, centre_of(cell), kWaitingHalf) && has_cube(scene, cell);
  };
  const auto wall = [&](Cell cell, Cell before) {
    if (!shown(cell) || !solid(world.node(cell)) || !world.contains(before)) return false;
    // A face is drawn between an obstacle and what is none, or what is cut away.
    return !solid(world.node(before)) || !shown(before);
  };
  const bool glass = scene.opacity < 1;
  auto first = first_on_ray(
      world, ray, [&](Cell cell, Cell before) { return waits(cell) || (!glass && wall(cell, before)); });
  double depth = first ? depth_of(ray, *first) : HUGE_VAL;
  const auto take = [&](const std::optional<Met>& met) {
    if (!met || met->depth > depth || !world.contains(met->cell)) return;
    first = met->cell;
    depth = met->depth;
  };
  take(met_sheet(scene, scene.slice, ray));
  take(met_path(scene.path, ray, reach));
  if (first || !glass) return first;
  return first_on_ray(world, ray, wall);
}

}  // namespace replan
