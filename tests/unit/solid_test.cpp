// Worlds from outside: lenses, what lies under a pixel, and the faces of obstacles.
#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/scene/context.hpp"
#include "core/scene/open_cells.hpp"
#include "core/scene/orbit.hpp"
#include "core/scene/solid_mesh.hpp"
#include "core/scene/solid_scene.hpp"
#include "core/session/session.hpp"

namespace replan::solid_test {
namespace {

constexpr Viewport kView{800, 600, 60, 40};
const Box kWorld(30, 20, 10);

TEST(OrbitLens, FitsTheWorldBetweenWhatLiesOverTheEdges) {
  for (const double yaw : {0.0, 0.7, 2.0, -2.5})
    for (const double pitch : {-1.5, 0.0, 0.4, 1.5})
      for (const Viewport& view : {kView, Viewport{200, 700, 60, 40}}) {
        const PixelBox seen = OrbitLens({yaw, pitch, 0, {}}, kWorld, view).bounds(kWorld);
        EXPECT_GE(seen.left, 0);
        EXPECT_LE(seen.right, view.width);
        EXPECT_GE(seen.top, view.above);
        EXPECT_LE(seen.bottom, view.height - view.below);
        const double filled = std::max(seen.width() / view.width, seen.height() / (view.height - 100));
        EXPECT_GT(filled, 0.7) << yaw << ' ' << pitch;
      }
}

TEST(OrbitLens, RaysLeadToThePixelsThatTheyComeFrom) {
  const OrbitLens lens({0.5, 0.8, 35, {12, 9, 4}}, kWorld, kView);
  for (const double x : {0.0, 133.0, 400.0, 790.0})
    for (const double y : {0.0, 250.0, 600.0})
      for (const double t : {1.0, 20.0, 70.0}) {
        const auto pixel = lens.pixel(lens.ray(x, y).at(t));
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x, x, 1e-6);
        EXPECT_NEAR(pixel->y, y, 1e-6);
      }
  EXPECT_FALSE(lens.pixel(lens.ray(400, 300).at(-5))) << "behind the eye";
}

/// The matrix that the graphics card gets puts points where the lens says they are.
TEST(OrbitLens, HasTheMatrixOfItsPixels) {
  const OrbitLens lens({-2.1, 0.3, 0, {}}, kWorld, kView);
  const std::array<float, 16> matrix = lens.matrix();
  for (const Point& point : {Point{0, 0, 0}, {30, 20, 10}, {3.5, 17, 9}}) {
    std::array<double, 4> clip{};
    const std::array<double, 4> in = {point.x, point.y, point.z, 1};
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t k = 0; k < 4; ++k) clip[row] += static_cast<double>(matrix[k * 4 + row]) * in[k];
    const auto pixel = lens.pixel(point);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR((clip[0] / clip[3] + 1) / 2 * kView.width, pixel->x, 0.01);
    EXPECT_NEAR((1 - clip[1] / clip[3]) / 2 * kView.height, pixel->y, 0.01);
    EXPECT_GT(clip[2] / clip[3], -1);
    EXPECT_LT(clip[2] / clip[3], 1);
  }
}

TEST(OrbitLens, LooksFromTheFrontWithZUpwards) {
  const OrbitLens lens({0, 0, 0, {}}, kWorld, {400, 400});
  const auto middle = lens.pixel({15, 10, 5}), right = lens.pixel({16, 10, 5}), up = lens.pixel({15, 10, 6}),
             nearer = lens.pixel({15, 11, 5});
  EXPECT_GT(right->x, middle->x + 1);
  EXPECT_LT(up->y, middle->y - 1);
  EXPECT_LT(nearer->depth, middle->depth) << "y runs towards the viewer";
}

/// By looking at every cell: the first whose inside the ray meets.
std::optional<Cell> first_by_brute_force(const EyeRay& ray, const std::vector<bool>& solid) {
  std::optional<Cell> first;
  double least = HUGE_VAL;
  for (NodeId node = 0; node < kWorld.node_count(); ++node) {
    if (!solid[node]) continue;
    const Cell cell = kWorld.position(node);
    double enter = 0, leave = HUGE_VAL;
    const auto clip = [&](double from, double way, double low) {
      const double a = (low - from) / way, b = (low + 1 - from) / way;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    };
    clip(ray.from.x, ray.direction.x, cell.x);
    clip(ray.from.y, ray.direction.y, cell.y);
    clip(ray.from.z, ray.direction.z, cell.z);
    if (enter >= leave || enter >= least) continue;
    least = enter;
    first = cell;
  }
  return first;
}

TEST(FirstOnRay, IsTheFirstCellThatTheRayMeets) {
  Random random(3);
  std::vector<bool> solid(kWorld.node_count());
  for (std::size_t i = 0; i < solid.size(); ++i) solid[i] = random.below(40) == 0;
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    const Orbit orbit{random.below(628) / 100.0, random.below(300) / 100.0 - 1.5, 0, {}};
    const OrbitLens lens(orbit, kWorld, kView);
    const EyeRay ray = lens.ray(random.below(800) + 0.137, random.below(600) + 0.291);
    const auto found = first_on_ray(kWorld, ray, [&](Cell cell, Cell) { return solid[kWorld.node(cell)]; });
    EXPECT_EQ(found, first_by_brute_force(ray, solid));
    met += found ? 1 : 0;
  }
  EXPECT_GT(met, 40);
}

using UnitFace = std::tuple<int, int, int, int, Colour>;

/// Rectangles taken apart into the faces of single cells; each of them once.
std::set<UnitFace> taken_apart(const SolidMesh& mesh) {
  std::set<UnitFace> all;
  for (std::size_t block = 0; block < mesh.block_count(); ++block)
    for (const SolidFace& face : mesh.faces(block))
      for (int i = 0; i < face.across; ++i)
        for (int j = 0; j < face.on; ++j) {
          const int axis = face.side / 2;
          const int x = face.x + (axis == 0 ? 0 : i),
                    y = face.y + (axis == 0   ? i
                                  : axis == 1 ? 0
                                              : j),
                    z = face.z + (axis == 2 ? 0 : j);
          EXPECT_TRUE(all.insert({x, y, z, face.side, face.colour}).second);
        }
  return all;
}

Palette solid_palette() {
  Palette palette;
  palette.free = 0xFFFFFFFF;
  palette.obstacle = 0xFF445566;
  palette.mover = 0xFFAA00AA;
  palette.surprise = 0xFF0080FF;
  return palette;
}

/// By the definition: between an obstacle and a free cell of the world.
std::set<UnitFace> by_definition(const Run& run) {
  const Palette palette = solid_palette();
  const SearchState& state = run.timeline().state();
  const Box& world = run.lattice();
  const auto colour = [&](Cell cell) -> Colour {
    const NodeId node = world.node(cell);
    if (state.moving(node)) return palette.mover;
    const bool truth = state.truly_blocked(node), known = state.known_blocked(node);
    if (!truth && !known) return 0;
    const auto& surprises = run.scenario().surprises;
    if (truth && run.scenario().map.blocked[node] == kFree)
      for (const Surprise& surprise : surprises)
        for (const CellChange& change : surprise.cells)
          if (change.blocked && !surprise.announced && change.cell == cell) return palette.surprise;
    return known ? palette.obstacle : mix(palette.free, palette.obstacle, 0.5f);
  };
  constexpr std::array<Cell, 6> kSides = {
      {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
  std::set<UnitFace> all;
  for (NodeId node = 0; node < world.node_count(); ++node) {
    const Cell cell = world.position(node);
    const Colour own = colour(cell);
    for (int side = 0; own != 0 && side < 6; ++side) {
      const Cell by = kSides[static_cast<std::size_t>(side)];
      const Cell next{cell.x + by.x, cell.y + by.y, cell.z + by.z};
      if (world.contains(next) && colour(next) == 0) all.insert({cell.x, cell.y, cell.z, side, own});
    }
  }
  return all;
}

/// Larger than one block, with something that moves and a surprise.
Scenario busy_world() {
  Random random(11);
  Scenario scenario;
  scenario.map = GridMap(40, 35, 9);
  for (NodeId node = 0; node < scenario.map.blocked.size(); ++node)
    if (random.below(6) == 0) scenario.map.set(scenario.map.box().position(node), true);
  scenario.start = {1, 1, 1};
  scenario.goal = {38, 33, 7};
  scenario.map.set(scenario.start, false);
  scenario.map.set(scenario.goal, false);
  scenario.planners = {{"dstar-lite", {}, {}}};
  scenario.robot.knowledge = Knowledge::nothing;
  scenario.robot.sensor_radius = 4;
  Surprise surprise;
  surprise.at.move = 6;
  for (int z = 2; z < 5; ++z) surprise.cells.push_back({{20, 18, z}, true});
  scenario.surprises = {surprise};
  scenario.movers = {{.way = {{5, 5, 3}, {30, 28, 5}}, .width = 3, .height = 2, .depth = 2, .speed = 4}};
  return scenario;
}

void bring(SolidMesh& mesh, const Run& run, SceneMemory& memory) {
  mesh.follow(run, memory.of(run).digest, solid_palette());
  mesh.make(run, {}, Deadline::never());
  EXPECT_EQ(mesh.waiting(), 0u);
}

TEST(SolidMesh, HasTheFacesBetweenObstaclesAndFreeSpaceAtEveryMoment) {
  Session session(busy_world());
  session.settle();
  SolidMesh mesh;
  SceneMemory memory;
  Random random(4);
  const std::size_t end = session.run().timeline().size();
  std::size_t made = 0;
  for (int i = 0; i < 12; ++i) {
    const std::size_t at = i == 0 ? 0 : i == 1 ? end : random.below(static_cast<std::uint32_t>(end));
    ASSERT_TRUE(session.apply(Seek{at}).ok());
    session.settle();
    const std::uint64_t before = mesh.block_count() > 0 ? mesh.revision(0) : 0;
    bring(mesh, session.run(), memory);
    made += mesh.revision(0) != before ? 1 : 0;
    EXPECT_EQ(taken_apart(mesh), by_definition(session.run())) << at;
  }
  EXPECT_GT(made, 2u);
  const std::uint64_t before = mesh.revision();
  bring(mesh, session.run(), memory);
  EXPECT_EQ(mesh.revision(), before) << "nothing has changed";
}

TEST(SolidMesh, AStrokeMakesItsOwnBlocksAnewAndNoOther) {
  Scenario scenario;
  scenario.map = GridMap(128, 64, 64);
  scenario.start = {1, 1, 1};
  scenario.goal = {9, 1, 1};
  scenario.planners = {{"astar", {}, {}}};
  Session session(scenario);
  session.settle();
  SolidMesh mesh;
  SceneMemory memory;
  bring(mesh, session.run(), memory);
  ASSERT_EQ(mesh.block_count(), 16u);
  std::vector<std::uint64_t> before;
  for (std::size_t i = 0; i < 16; ++i) before.push_back(mesh.revision(i));
  ASSERT_TRUE(session.apply(Seek{session.run().timeline().size()}).ok());
  ASSERT_TRUE(session.apply(PaintCells{{{{50, 40, 40}, true}}, 0}).ok());
  session.settle();
  ASSERT_TRUE(session.apply(Seek{session.run().timeline().size()}).ok());
  bring(mesh, session.run(), memory);
  EXPECT_EQ(mesh.face_count(), 6u);
  std::size_t made = 0;
  for (std::size_t i = 0; i < 16; ++i) made += mesh.revision(i) != before[i] ? 1 : 0;
  EXPECT_EQ(made, 1u) << "the one that it lies in";
  EXPECT_EQ(taken_apart(mesh), by_definition(session.run()));
}

/// A window makes some blocks a frame, those near the eye first; what it has come to in the end is the same.
TEST(SolidMesh, IsMadeBlockByBlockFromTheEyeOn) {
  Session session(busy_world());
  session.settle();
  SolidMesh mesh;
  SceneMemory memory;
  mesh.follow(session.run(), memory.of(session.run()).digest, solid_palette());
  ASSERT_EQ(mesh.block_count(), 4u);
  ASSERT_EQ(mesh.waiting(), 4u);
  const Point eye{60, 60, 20};
  for (const std::size_t next : {3u, 1u, 2u, 0u}) {
    EXPECT_TRUE(mesh.faces(next).empty());
    mesh.make(session.run(), eye, Deadline(0));
    EXPECT_FALSE(mesh.faces(next).empty()) << next;
  }
  EXPECT_EQ(mesh.waiting(), 0u);
  EXPECT_EQ(taken_apart(mesh), by_definition(session.run()));
}

/// A planner that begins anew on the same world has another log, and all blocks have to be looked at; but they are the same.
TEST(SolidMesh, KeepsTheFacesThatAreTheSameWithAnotherLog) {
  Session session(busy_world());
  session.settle();
  SolidMesh mesh;
  SceneMemory memory;
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  bring(mesh, session.run(), memory);
  const std::uint64_t before = mesh.revision(), log = session.run().log_id();
  ASSERT_TRUE(session.apply(ChoosePlanner{0, "astar"}).ok());
  session.settle();
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  ASSERT_NE(session.run().log_id(), log);
  bring(mesh, session.run(), memory);
  EXPECT_EQ(mesh.revision(), before);
}

TEST(SolidMesh, TellsALegendWhatItShows) {
  Session session(busy_world());
  session.settle();
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  session.settle();
  SolidMesh mesh;
  SceneMemory memory;
  const auto shows = [&](Sign sign) { return mesh.signs().test(static_cast<std::size_t>(sign)); };
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  bring(mesh, session.run(), memory);
  EXPECT_TRUE(shows(Sign::unknown));
  EXPECT_FALSE(shows(Sign::surprise));
  ASSERT_TRUE(session.apply(Seek{session.run().timeline().size()}).ok());
  bring(mesh, session.run(), memory);
  EXPECT_TRUE(shows(Sign::surprise));
  EXPECT_TRUE(shows(Sign::mover));
  EXPECT_TRUE(shows(Sign::obstacle)) << "the robot has seen some";
}

TEST(OpenCells, AreThoseOfTheStateAtEveryMoment) {
  Session session(busy_world());
  session.settle();
  OpenCells open;
  Random random(9);
  const std::size_t end = session.run().timeline().size();
  std::size_t waited = 0;
  for (int i = 0; i < 300; ++i) {
    const std::size_t cursor = session.run().timeline().cursor();
    const std::size_t to = i % 10 == 0 ? random.below(static_cast<std::uint32_t>(end))
                                       : std::min(end, cursor + random.below(40));
    ASSERT_TRUE(session.apply(Seek{to}).ok());
    open.follow(session.run(), Deadline(0));
    while (open.behind()) open.follow(session.run(), Deadline(0));
    std::vector<NodeId> found, expected;
    open.each([&](NodeId node) {
      found.push_back(node);
      return true;
    });
    for (NodeId node = 0; node < session.run().lattice().node_count(); ++node)
      if (session.run().timeline().state().queued(node)) expected.push_back(node);
    ASSERT_EQ(found, expected) << "at event " << to;
    waited += found.size();
  }
  EXPECT_GT(waited, 1000u);
}

TEST(OpenCells, LookOnlyWhereTheLogTellsOfAChange) {
  Scenario scenario;
  scenario.map = GridMap(64, 64, 64);
  scenario.start = {1, 1, 1};
  scenario.goal = {9, 3, 2};
  scenario.planners = {{"astar", {}, {}}};
  Session session(scenario);
  session.settle();
  OpenCells open;
  ASSERT_TRUE(session.apply(Seek{20}).ok());
  open.follow(session.run(), Deadline::never());
  const std::size_t before = open.scanned();
  EXPECT_EQ(before, 128u) << "all of it, once";
  ASSERT_TRUE(session.apply(Seek{60}).ok());
  open.follow(session.run(), Deadline::never());
  EXPECT_GT(open.scanned(), before);
  EXPECT_LE(open.scanned(), before + 8);
}

/// What an overlay draws in space is there while it is on, and not while it is off.
TEST(SolidScene, ShowsTheOverlaysThatAreOn) {
  Session session(busy_world());
  session.settle();
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  session.settle();
  SceneMemory memory;
  View view;
  view.slice = {Axis::z, 3};
  const auto shapes = [&](const OverlaySet& overlays) {
    view.overlays = overlays;
    const SolidScene scene =
        build_solid_scene(session.run(), view, {}, {0, 100, 50}, solid_palette(), memory);
    return scene.lines.size() + scene.boxes.size() + (scene.sheet.texels.empty() ? 0 : 1);
  };
  std::set<std::string> drawn;
  const std::size_t end = session.run().timeline().size();
  for (const std::size_t at : {end / 8, end / 2, end * 3 / 4, end}) {
    ASSERT_TRUE(session.apply(Seek{at}).ok());
    const std::size_t bare = shapes({});
    for (const OverlayInfo& info : overlays()) {
      OverlaySet one;
      one.set(info.overlay, true);
      if (shapes(one) > bare) drawn.emplace(info.id);
    }
  }
  for (const char* name :
       {"g", "rhs", "key", "order", "queue", "repair", "lp", "path", "trail", "sensor", "script"})
    EXPECT_TRUE(drawn.contains(name)) << name;
}

/// The picture on the slice has the colours of the same slice on a canvas, wherever it has one.
TEST(SolidScene, HasTheFieldOnTheSliceInTheColoursOfTheCanvas) {
  Session session(busy_world());
  session.settle();
  Palette palette = solid_palette();
  for (std::size_t i = 0; i < palette.field.size(); ++i)
    palette.field[i] = 0xFF000000u | static_cast<Colour>(i);
  View view;
  view.overlays = {};
  view.overlays.set(Overlay::g, true);
  for (const Slice slice : {Slice{Axis::z, 3}, Slice{Axis::y, 12}, Slice{Axis::x, 20}}) {
    view.slice = slice;
    SceneMemory memory;
    const SolidScene solid = build_solid_scene(session.run(), view, {}, {0, 100, 50}, palette, memory);
    const Sheet sheet = sheet_of(session.run().lattice(), slice);
    view.camera = {sheet.box.width() / 2.0, sheet.box.height() / 2.0, 8};
    const Scene plane = build_scene(session.run(), view, {1000, 1000}, palette, memory);
    ASSERT_EQ(solid.sheet.columns, sheet.box.width());
    ASSERT_EQ(solid.sheet.texels.size(), plane.raster.texels.size());
    EXPECT_EQ(solid.range, plane.range);
    std::size_t coloured = 0;
    for (std::size_t i = 0; i < plane.raster.texels.size(); ++i) {
      const Cell cell =
          sheet.cell(static_cast<int>(i) % solid.sheet.columns, static_cast<int>(i) / solid.sheet.columns);
      const bool has_value = field_value(session.run(), Overlay::g, cell).has_value();
      const bool blocked = session.run().timeline().state().truly_blocked(session.run().lattice().node(cell));
      EXPECT_EQ(solid.sheet.texels[i] != 0, has_value && !blocked)
          << cell.x << ' ' << cell.y << ' ' << cell.z;
      if (solid.sheet.texels[i] == 0) continue;
      EXPECT_EQ(solid.sheet.texels[i], plane.raster.texels[i]);
      ++coloured;
    }
    EXPECT_GT(coloured, 20u);
  }
}

/// A wall across an empty hall, with a path before it and what is behind it.
class Picking : public testing::Test {
 protected:
  Picking() {
    Scenario scenario;
    scenario.map = GridMap(20, 20, 10);
    for (int x = 0; x < 20; ++x)
      for (int z = 1; z < 9; ++z) scenario.map.set({x, 10, z}, x > 0 && x < 19);
    scenario.start = {3, 14, 5};
    scenario.goal = {16, 14, 5};
    scenario.planners = {{"astar", {}, {}}};
    session_ = std::make_unique<Session>(scenario);
    session_->settle();
    view_.overlays = {};
    view_.slice = {Axis::z, 2};
  }
  [[nodiscard]] std::optional<Cell> pick(Cell cell, const SolidOptions& options, const Orbit& orbit) {
    const OrbitLens lens(orbit, session_->run().lattice(), kView);
    const SolidScene scene =
        build_solid_scene(session_->run(), view_, options, lens.eye(), solid_palette(), memory_);
    const auto pixel = lens.pixel(centre_of(cell));
    return cell_on_ray(session_->run(), scene, lens.ray(pixel->x, pixel->y), 5 * lens.pixel_angle());
  }

  std::unique_ptr<Session> session_;
  SceneMemory memory_;
  View view_;
};

TEST_F(Picking, MeetsTheNearestOfWhatIsDrawn) {
  const Cell on_path{10, 14, 5}, on_wall{10, 10, 7};
  for (const bool glass : {false, true}) {
    const SolidOptions options{.see_through = glass};
    EXPECT_EQ(pick(on_path, options, front_view())->y, 10) << "no path is drawn: the wall behind it";
    view_.overlays.set(Overlay::path, true);
    EXPECT_EQ(pick(on_path, options, front_view()), on_path);
    EXPECT_EQ(pick(on_wall, options, front_view()), on_wall);
    view_.overlays.set(Overlay::path, false);
  }
  view_.overlays.set(Overlay::path, true);
  const Orbit behind{3.14159265, 0, 0, {}};
  EXPECT_EQ(pick(on_path, {}, behind)->y, 10) << "from behind the wall hides it";
  EXPECT_EQ(pick(on_path, {.see_through = true}, behind), on_path) << "but not as glass";
}

TEST_F(Picking, MeetsTheFieldOnTheSlice) {
  const Cell coloured{10, 14, 5}, bare{10, 3, 5};
  view_.slice = {Axis::z, 5};
  view_.overlays.set(Overlay::g, true);
  EXPECT_EQ(pick(coloured, {}, top_view()), coloured);
  EXPECT_EQ(pick(bare, {}, top_view()), std::nullopt) << "there the search has not been";
}

TEST(SolidScene, HasPathMarksAndTheFrameOfTheSlice) {
  Session session(busy_world());
  session.settle();
  SceneMemory memory;
  View view;
  view.slice = {Axis::y, 12};
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  const SolidScene before = build_solid_scene(session.run(), view, {}, {0, 100, 50}, solid_palette(), memory);
  ASSERT_EQ(before.marks.size(), 2u);
  EXPECT_EQ(before.marks[0].at, (Point{1.5, 1.5, 1.5}));
  EXPECT_EQ(before.marks[1].at, (Point{38.5, 33.5, 7.5}));
  EXPECT_EQ(std::count_if(before.lines.begin(), before.lines.end(),
                          [](const SolidLine& line) { return line.from[1] == 12.5f && line.to[1] == 12.5f; }),
            4);
  EXPECT_FALSE(before.cut);
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 3}).ok());
  const SolidScene after =
      build_solid_scene(session.run(), view, {.cut = true}, {0, 100, 50}, solid_palette(), memory);
  EXPECT_EQ(after.marks.size(), 3u);
  EXPECT_GT(after.lines.size(), before.lines.size());
  ASSERT_TRUE(after.cut);
  EXPECT_TRUE(after.cut->keeps_lower) << "seen from the front, what has the larger y is left out";
  EXPECT_EQ(after.cut->at, 13);
  std::size_t cells = 0, solid = 0;
  for (const SolidFace& face : after.cut_faces) cells += std::size_t{face.across} * face.on;
  const SearchState& state = session.run().timeline().state();
  for (int z = 0; z < 9; ++z)
    for (int x = 0; x < 40; ++x) {
      const NodeId node = session.run().lattice().node({x, 12, z});
      solid += state.truly_blocked(node) || state.known_blocked(node) ? 1 : 0;
    }
  EXPECT_EQ(cells, solid);
}

}  // namespace
}  // namespace replan::solid_test
