// What a scene shows, and that it shows the same however it was come by.
#include "core/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/scene/overview.hpp"
#include "core/scene/svg.hpp"
#include "core/session/session.hpp"

namespace replan::scene_test {
namespace {

constexpr Viewport kView{640, 480};

Palette palette() {
  Palette colours;
  colours.background = 0xFF010101;
  colours.free = 0xFF020202;
  colours.obstacle = 0xFF0000AA;
  colours.surprise = 0xFF00AA00;
  colours.mover = 0xFFAA00AA;
  colours.accent = 0xFFFFAA00;
  colours.path = 0xFFFFFFFF;
  colours.text = 0xFFEEEEEE;
  colours.arrow = 0x80FFFFFF;
  colours.warning = 0xFF00FFFF;
  colours.robot = 0xFF123456;
  colours.goal = 0xFF654321;
  colours.field_opacity = 1;
  for (std::size_t i = 0; i < colours.field.size(); ++i)
    colours.field[i] = 0xFF400000u | static_cast<Colour>(i);
  return colours;
}

/// 20 x 10 with a wall that leaves a gap at the bottom, which closes when the robot comes near.
Scenario world() {
  Scenario scenario;
  scenario.map = GridMap(20, 10);
  for (int y = 0; y < 9; ++y)
    if (y != 2) scenario.map.set({10, y}, true);
  scenario.start = {2, 7};
  scenario.goal = {17, 7};
  scenario.planners = {{"dstar-lite", {}}};
  Surprise surprise;
  surprise.at.move = 3;
  surprise.cells = {{{10, 9}, true}};
  scenario.surprises = {surprise};
  return scenario;
}

template <class S>
std::vector<S> shapes_of(const Scene& scene) {
  std::vector<S> found;
  for (const Shape& shape : scene.shapes)
    if (const S* each = std::get_if<S>(&shape)) found.push_back(*each);
  return found;
}

View plain_view() {
  View view;
  view.overlays = {};
  return view;
}

Colour texel_at(const Scene& scene, Point at) {
  const Raster& raster = scene.raster;
  const auto column = static_cast<int>((at.x - raster.x) / raster.width * raster.columns);
  const auto row = static_cast<int>((at.y - raster.y) / raster.height * raster.rows);
  return raster.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
                       static_cast<std::size_t>(column)];
}

void run_to_end(Session& session) {
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  session.settle();
  for (const auto& run : session.runs()) run->finish(Target::end());
  session.update(0);
}

TEST(Overlays, AtMostOneField) {
  OverlaySet set;
  set.set(Overlay::g, true);
  set.set(Overlay::path, true);
  set.set(Overlay::rhs, true);
  EXPECT_FALSE(set.has(Overlay::g));
  EXPECT_EQ(set.field(), Overlay::rhs);
  EXPECT_TRUE(set.has(Overlay::path));
  set.set(Overlay::rhs, false);
  EXPECT_FALSE(set.field().has_value());
}

TEST(Overlays, IdsAreReadAndNearMissesNamed) {
  const std::vector<std::string> good = {"g", "trail"}, bad = {"trial"};
  ASSERT_TRUE(parse_overlays(good).ok());
  EXPECT_TRUE(parse_overlays(good)->has(Overlay::trail));
  const auto failed = parse_overlays(bad);
  ASSERT_FALSE(failed.ok());
  EXPECT_NE(failed.error().find("trail"), std::string::npos) << failed.error();
  for (std::size_t i = 0; i < overlays().size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(overlays()[i].overlay), i);
}

TEST(Scene, FitShowsTheWholeWorldOnWholePixels) {
  const Camera camera = resolve({}, 20, 10, kView);
  EXPECT_EQ(camera.zoom, 29);
  EXPECT_LE(20 * camera.zoom, kView.width);
  const double corner = (0 - camera.x) * camera.zoom + kView.width / 2.0;
  EXPECT_NEAR(corner, std::round(corner), 1e-9);
}

TEST(Scene, PathRunsThroughTheRoutesVertices) {
  Session session(world());
  session.settle();
  View view = plain_view();
  view.overlays.set(Overlay::path, true);
  const auto lines = shapes_of<Polyline>(build_scene(session.run(), view, kView, palette()));
  ASSERT_EQ(lines.size(), 1u);
  const auto& run = session.run();
  const auto nodes = run.decision_at(run.timeline().cursor())->plan->path->nodes();
  ASSERT_EQ(lines[0].points.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Cell cell = run.lattice().position(nodes[i]);
    EXPECT_EQ(lines[0].points[i], centre_of(cell));
  }
}

TEST(Scene, TheNearestCellStandsBesideTheGoalWhileTheRobotMakesForIt) {
  Scenario scenario = world();
  for (int y = 0; y < 10; ++y) scenario.map.set({10, y}, true);
  scenario.surprises = {};
  const auto built = [](const Scenario& each) {
    replan::Run run(std::make_shared<const Scenario>(each), 0);
    run.finish(Target::plan());
    run.timeline().seek(run.timeline().size());
    return build_scene(run, plain_view(), kView, palette());
  };
  const auto disc_at = [](const Scene& scene, Point at, Glyph glyph) {
    const auto discs = shapes_of<Disc>(scene);
    return std::any_of(discs.begin(), discs.end(),
                       [&](const Disc& disc) { return disc.centre == at && disc.glyph == glyph; });
  };
  const Point goal{17.5, 7.5, 0.5}, nearest{9.5, 7.5, 0.5};
  EXPECT_FALSE(built(scenario).shows(Sign::nearest)) << "a robot that waits makes for its goal";
  scenario.robot.unreachable_goal = UnreachableGoal::nearest;
  const Scene shut = built(scenario);
  EXPECT_TRUE(shut.shows(Sign::nearest));
  EXPECT_TRUE(disc_at(shut, goal, Glyph::target)) << "the goal stays where it is";
  EXPECT_TRUE(disc_at(shut, nearest, Glyph::none));
  scenario.map.set({10, 2}, false);
  const Scene open = built(scenario);
  EXPECT_FALSE(open.shows(Sign::nearest));
  EXPECT_FALSE(disc_at(open, nearest, Glyph::none));
}

TEST(Scene, CellsHaveTheColourOfWhatTheyAre) {
  Session session(world());
  session.settle();
  View view = plain_view();
  const Scene before = build_scene(session.run(), view, kView, palette());
  EXPECT_EQ(texel_at(before, {10.5, 5.5}), palette().obstacle);
  EXPECT_EQ(texel_at(before, {10.5, 9.5}), palette().free);
  EXPECT_EQ(texel_at(before, {1.5, 1.5}), palette().free);
  run_to_end(session);
  EXPECT_EQ(texel_at(build_scene(session.run(), view, kView, palette()), {10.5, 9.5}), palette().surprise);
}

TEST(Scene, FieldRunsOverTheWholeMap) {
  Session session(world());
  session.settle();
  View view = plain_view();
  view.overlays.set(Overlay::g, true);
  const Scene scene = build_scene(session.run(), view, kView, palette());
  ASSERT_TRUE(scene.range.has_value());
  EXPECT_EQ(scene.range->low, 0);
  EXPECT_GT(scene.range->high, 15);
  EXPECT_EQ(texel_at(scene, {17.5, 7.5}), palette().field.front());
}

TEST(Scene, UnknownObstacleIsDimmedAndHatched) {
  Scenario scenario = world();
  scenario.robot.knowledge = Knowledge::nothing;
  scenario.robot.sensor_radius = 1;
  Session session(scenario);
  session.settle();
  View view = plain_view();
  EXPECT_EQ(texel_at(build_scene(session.run(), view, kView, palette()), {10.5, 1.5}), palette().free);
  view.overlays.set(Overlay::unknown, true);
  const Scene scene = build_scene(session.run(), view, kView, palette());
  EXPECT_TRUE(scene.shows(Sign::unknown));
  const Colour colour = texel_at(scene, {10.5, 1.5});
  EXPECT_NE(colour, palette().free);
  EXPECT_NE(colour, palette().obstacle);
  EXPECT_FALSE(shapes_of<Line>(scene).empty());
}

TEST(Scene, TrailAndRepairFollowTheRun) {
  Session session(world());
  session.settle();
  run_to_end(session);
  View view = plain_view();
  view.overlays.set(Overlay::trail, true);
  view.overlays.set(Overlay::repair, true);
  const auto& run = session.run();
  const Scene scene = build_scene(run, view, kView, palette());
  const auto lines = shapes_of<Polyline>(scene);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].points.size(), static_cast<std::size_t>(run.decisions().back().figures.moves) + 1);
  EXPECT_TRUE(scene.shows(Sign::repair));
  SceneMemory memory;
  const RepairFigures figures = memory.repair(run, run.timeline().size());
  EXPECT_EQ(figures.number, run.decisions().back().figures.replans);
  EXPECT_GT(figures.touched, 0);
  EXPECT_EQ(memory.expansions(run, run.timeline().size()),
            run.decisions().back().figures.counters.expansions);
}

TEST(Scene, ScannedCellsAreThoseThatJumpsPassedOver) {
  Scenario scenario = world();
  scenario.planners = {{"jps", {}}};
  Session session(scenario);
  session.settle();
  const replan::Run& run = session.run();
  Palette colours = palette();
  colours.good = 0xFF22CC22;
  View view = plain_view();
  view.overlays.set(Overlay::scanned, true);
  view.camera = {10, 5, 60};
  const Scene scene = build_scene(run, view, {1280, 640}, colours);
  EXPECT_TRUE(scene.shows(Sign::scanned));
  std::set<NodeId> shown, latest;
  for (const Outline& outline : shapes_of<Outline>(scene)) {
    if ((outline.colour & 0xFFFFFFu) != (colours.good & 0xFFFFFFu)) continue;
    const NodeId node = run.lattice().node({static_cast<int>(outline.x), static_cast<int>(outline.y)});
    shown.insert(node);
    if (outline.colour == colours.good) latest.insert(node);
  }
  const SearchState& state = run.timeline().state();
  std::uint64_t last = 0;
  for (NodeId n = 0; n < run.lattice().node_count(); ++n) last = std::max(last, state.value(own_field(0), n));
  for (NodeId n = 0; n < run.lattice().node_count(); ++n) {
    EXPECT_EQ(shown.contains(n), state.value(own_field(0), n) != 0) << "cell " << n;
    EXPECT_EQ(latest.contains(n), last > 0 && state.value(own_field(0), n) == last) << "cell " << n;
  }
  EXPECT_GT(shown.size(), 20u);

  Session other(world());
  other.settle();
  EXPECT_FALSE(build_scene(other.run(), view, kView, colours).shows(Sign::scanned)) << "D* Lite scans none";
}

/// The log tells a search from scratch by an epoch.
TEST(Scene, AReplanOfLpaStarCountsAsARepairExactlyWhileItsStartStays) {
  Scenario scenario = world();
  scenario.planners = {{"lpa-star", {}}};
  Surprise at_once = scenario.surprises[0];
  at_once.at.move = 0;
  at_once.cells = {{{5, 5}, true}};
  at_once.announced = true;
  scenario.surprises = {at_once, scenario.surprises[0]};
  replan::Run run(std::make_shared<const Scenario>(scenario), 0);
  run.finish(Target::end());
  SceneMemory memory;
  int repairs = 0, afresh = 0;
  bool epoch = false;
  for (std::size_t i = 0; i < run.timeline().size(); ++i) {
    const EventKind kind = run.timeline().event(i).kind;
    if (kind == EventKind::plan_begin) epoch = false;
    if (kind == EventKind::epoch) epoch = true;
    if (kind != EventKind::plan_end) continue;
    const RepairFigures figures = memory.repair(run, i + 1);
    if (figures.number == 0) continue;
    EXPECT_EQ(figures.cause.afresh(), epoch) << "replan " << figures.number;
    ++(epoch ? afresh : repairs);
  }
  EXPECT_GE(repairs, 1);
  EXPECT_GE(afresh, 1);
}

TEST(Scene, ObstaclesNeverVanishFromFarAway) {
  Scenario scenario;
  scenario.map = GridMap(1500, 1100);
  scenario.map.set({701, 333}, true);
  scenario.start = {1, 1};
  scenario.goal = {3, 3};
  scenario.planners = {{"dstar-lite", {}}};
  Session session(scenario);
  session.settle();
  for (const double zoom : {0.03, 0.1, 0.21, 0.37, 0.5, 0.83, 1.0}) {
    View view = plain_view();
    view.camera = {750, 550, zoom};
    const Scene scene = build_scene(session.run(), view, {1600, 1200}, palette());
    EXPECT_NE(texel_at(scene, {701.5, 333.5}), palette().free) << zoom;
    EXPECT_EQ(texel_at(scene, {200.5, 900.5}), palette().free) << zoom;
  }
}

TEST(Overview, IsMadeAnewWhereTheMapHasChangedAndNotElse) {
  Scenario scenario = world();
  scenario.map = GridMap(700, 300);
  for (int y = 100; y < 140; ++y)
    for (int x = 200; x < 240; ++x) scenario.map.set({x, y}, true);
  scenario.surprises = {};
  Session session(scenario);
  session.settle();
  SceneMemory memory;
  OverviewKeeper keeper;
  EXPECT_TRUE(keeper.follow(session.run(), memory, {}, palette(), 160));
  const Overview& small = keeper.picture();
  EXPECT_EQ(small.columns, 88) << "blocks of 8";
  EXPECT_EQ(small.rows, 38);
  const auto at = [&](int x, int y) { return small.texels[static_cast<std::size_t>(y / 8 * 88 + x / 8)]; };
  EXPECT_EQ(at(220, 120), palette().obstacle);
  EXPECT_EQ(at(20, 20), palette().free);
  EXPECT_FALSE(keeper.follow(session.run(), memory, {}, palette(), 160));
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  EXPECT_FALSE(keeper.follow(session.run(), memory, {}, palette(), 160)) << "another moment, the same map";
  std::vector<CellChange> wall;
  for (int y = 16; y < 24; ++y)
    for (int x = 16; x < 24; ++x) wall.push_back({{x, y}, true});
  ASSERT_TRUE(session.apply(PaintCells{wall, 0}).ok());
  session.settle();
  EXPECT_TRUE(keeper.follow(session.run(), memory, {}, palette(), 160));
  EXPECT_EQ(at(20, 20), palette().obstacle);
}

TEST(Scene, NumbersAppearAt44AndCornersAt72Pixels) {
  Session session(world());
  session.settle();
  View view = plain_view();
  view.overlays.set(Overlay::numbers, true);
  const auto labels = [&](double zoom) {
    view.camera = {15, 7, zoom};
    return shapes_of<Label>(build_scene(session.run(), view, kView, palette()));
  };
  EXPECT_TRUE(labels(39).empty());
  const auto middle = labels(50);
  ASSERT_FALSE(middle.empty());
  EXPECT_TRUE(
      std::all_of(middle.begin(), middle.end(), [](const Label& l) { return l.anchor == Anchor::middle; }));
  const auto corners = labels(80);
  const auto has = [&](Anchor anchor) {
    return std::any_of(corners.begin(), corners.end(),
                       [anchor](const Label& l) { return l.anchor == anchor; });
  };
  EXPECT_TRUE(has(Anchor::upper_left));
  EXPECT_TRUE(has(Anchor::upper_right));
}

TEST(Scene, ArrowsVanishInSmallCells) {
  Session session(world());
  session.settle();
  View view = plain_view();
  view.overlays.set(Overlay::lp, true);
  const auto arrows = [&](double zoom) {
    view.camera = {10, 5, zoom};
    return shapes_of<Arrow>(build_scene(session.run(), view, kView, palette())).size();
  };
  EXPECT_EQ(arrows(9), 0u);
  EXPECT_GT(arrows(14), 10u);
}

TEST(Scene, RemoteParentsShowOnlyOfPlannersThatUseThem) {
  for (const auto& [planner, uses] : {std::pair{"dstar-lite", false}, {"dld-star-lite", true}}) {
    Scenario scenario = world();
    scenario.planners = {{planner, {}}};
    Session session(scenario);
    session.settle();
    View view = plain_view();
    view.overlays.set(Overlay::rp, true);
    view.camera = {10, 5, 60};
    const Scene scene = build_scene(session.run(), view, kView, palette());
    EXPECT_EQ(scene.shows(Sign::rp), uses) << planner;
    EXPECT_EQ(!shapes_of<Arrow>(scene).empty(), uses) << planner;
  }
}

bool same(const Scene& a, const Scene& b) {
  return a.raster.texels == b.raster.texels && a.shapes.size() == b.shapes.size() && a.range == b.range &&
         a.signs == b.signs && scene_svg(a, palette()) == scene_svg(b, palette());
}

/// The places from which rays of sight checks go out, and how many rays there are.
std::pair<std::set<std::pair<double, double>>, int> rays_of(const Scene& scene, const Palette& colours) {
  std::set<std::pair<double, double>> from;
  int rays = 0;
  for (const Line& line : shapes_of<Line>(scene)) {
    const bool arm_of_cross = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y) < 0.9;
    if ((line.colour != colours.good && line.colour != colours.bad) || arm_of_cross) continue;
    from.insert({line.from.x, line.from.y});
    ++rays;
  }
  return {from, rays};
}

TEST(Scene, OfAPathReadOutByLeapsTheRaysOfOneVertexShow) {
  Scenario scenario = world();
  scenario.surprises.clear();
  scenario.planners = {{"los-dstar-lite", {}}};
  scenario.planners[0].settings.set("sight_checks", 1);
  Session session(scenario);
  session.settle();
  View view = plain_view();
  view.overlays.set(Overlay::sight, true);
  Palette colours = palette();
  colours.good = 0xFF00FF12;
  colours.bad = 0xFF0012FF;
  const Timeline& log = session.run().timeline();
  std::set<NodeId> leaping;
  int most = 0;
  for (std::size_t p = 1; p <= log.size(); ++p) {
    if (log.event(p - 1).kind != EventKind::sight) continue;
    leaping.insert(log.event(p - 1).node);
    ASSERT_TRUE(session.apply(Seek{p}).ok());
    const auto [from, rays] = rays_of(build_scene(session.run(), view, kView, colours), colours);
    EXPECT_EQ(from.size(), 1u) << "at " << p;
    most = std::max(most, rays);
  }
  EXPECT_GT(leaping.size(), 1u);
  EXPECT_GT(most, 1);
}

TEST(Scene, MemoryChangesNothing) {
  Session session(world());
  session.settle();
  run_to_end(session);
  SceneMemory memory;
  const std::size_t size = session.run().timeline().size();
  for (const double zoom : {0.4, 6.0, 30.0})
    for (const std::size_t position : {size, size / 2, std::size_t{0}, size / 3, size - 1}) {
      ASSERT_TRUE(session.apply(Seek{position}).ok());
      View view;
      for (const OverlayInfo& info : overlays())
        if (!info.is_field()) view.overlays.set(info.overlay, true);
      view.camera = {10, 5, zoom};
      const Scene with = build_scene(session.run(), view, kView, palette(), memory);
      EXPECT_TRUE(same(with, build_scene(session.run(), view, kView, palette())))
          << zoom << " at " << position;
    }
}

TEST(Scene, MemorySurvivesAnEditThatCutsTheLog) {
  Session session(world());
  session.settle();
  SceneMemory memory;
  View view;
  build_scene(session.run(), view, kView, palette(), memory);
  ASSERT_TRUE(session.apply(PaintCells{{{{6, 7}, true}, {{6, 6}, true}}, 1}).ok());
  session.settle();
  EXPECT_TRUE(same(build_scene(session.run(), view, kView, palette(), memory),
                   build_scene(session.run(), view, kView, palette())));
  ASSERT_TRUE(session.apply(Undo{}).ok());
  session.settle();
  EXPECT_TRUE(same(build_scene(session.run(), view, kView, palette(), memory),
                   build_scene(session.run(), view, kView, palette())));
}

/// Whether every tag is closed in order, and how often one of that name opens.
bool well_formed(const std::string& xml, const std::string& name, int& count) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return false;
    const std::string word = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag[0] == '/') {
      if (open.empty() || "/" + open.back() != tag) return false;
      open.pop_back();
      continue;
    }
    if (word == name) ++count;
    if (!tag.ends_with('/')) open.push_back(word);
  }
  return open.empty();
}

TEST(SceneSvg, IsWellFormedAndHasEveryPolyline) {
  Session session(world());
  session.settle();
  run_to_end(session);
  ASSERT_TRUE(session.apply(Seek{session.run().timeline().size() * 2 / 3}).ok());
  View view;
  view.overlays.set(Overlay::numbers, true);
  view.camera = {10, 5, 80};
  const Scene scene = build_scene(session.run(), view, kView, palette());
  int polylines = 0;
  EXPECT_TRUE(well_formed(scene_svg(scene, palette()), "polyline", polylines));
  EXPECT_EQ(static_cast<std::size_t>(polylines), shapes_of<Polyline>(scene).size());
  EXPECT_GT(polylines, 0);
}

TEST(Scene, ShowsWhatIsToComeUntilItHasHappened) {
  Scenario scenario = world();
  MovingObstacle mover;
  mover.way = {{1, 1}, {6, 1}, {6, 4}};
  mover.width = mover.height = 2;
  mover.at_end = WayEnd::loop;
  scenario.movers = {mover};
  Session session(scenario);
  session.settle();
  View view = plain_view();
  EXPECT_TRUE(shapes_of<Label>(build_scene(session.run(), view, kView, palette())).empty());
  view.overlays.set(Overlay::script, true);
  view.selected_mover = 0;
  const Scene before = build_scene(session.run(), view, kView, palette());
  EXPECT_TRUE(before.shows(Sign::to_come) && before.shows(Sign::mover));
  const auto labels = shapes_of<Label>(before);
  ASSERT_EQ(labels.size(), 1u);
  EXPECT_EQ(labels[0].text, "step 3");
  const auto ways = shapes_of<Polyline>(before);
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_GT(ways[0].dash, 0);
  // Through the middle of the box, and home again.
  EXPECT_EQ(ways[0].points, (std::vector<Point>{{2, 2, 0.5}, {7, 2, 0.5}, {7, 5, 0.5}, {2, 2, 0.5}}));
  EXPECT_EQ(ways[0].colour, palette().accent);
  EXPECT_NE(scene_svg(before, palette()).find("stroke-dasharray"), std::string::npos);
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 4}).ok());
  const Scene after = build_scene(session.run(), view, kView, palette());
  EXPECT_FALSE(after.shows(Sign::to_come));
  EXPECT_TRUE(shapes_of<Label>(after).empty());
  EXPECT_TRUE(after.shows(Sign::mover));
}

/// Two layers with a wall between them that a hatch leads through, and a goal above.
Scenario decks() {
  Scenario scenario;
  scenario.map = GridMap(9, 5, 3);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 9; ++x)
      if (x != 4 || y != 2) scenario.map.set({x, y, 1}, true);
  scenario.map.set({1, 0, 2}, true);
  scenario.start = {0, 2, 0};
  scenario.goal = {8, 2, 2};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot.sensor_radius = 2;
  Surprise surprise;
  surprise.at.move = 1;
  surprise.cells = {{{7, 0, 0}, true}, {{7, 4, 2}, true}};
  scenario.surprises = {surprise};
  scenario.movers = {{.way = {{2, 0, 0}, {6, 0, 2}}, .width = 1, .height = 1, .depth = 1, .from = 50}};
  return scenario;
}

View slice_view(int slice, std::initializer_list<Overlay> overlays) {
  View view = plain_view();
  for (const Overlay overlay : overlays) view.overlays.set(overlay, true);
  view.slice.layer = slice;
  return view;
}

TEST(Slice, ShowsTheCellsAndMarksOfOneLayer) {
  Session session(decks());
  session.settle();
  std::vector<Scene> slices;
  for (int z = 0; z < 3; ++z)
    slices.push_back(build_scene(session.run(), slice_view(z, {Overlay::lp}), kView, palette()));
  EXPECT_EQ(texel_at(slices[0], {1.5, 0.5}), palette().free);
  EXPECT_EQ(texel_at(slices[1], {1.5, 0.5}), palette().obstacle);
  EXPECT_EQ(texel_at(slices[1], {4.5, 2.5}), palette().free);
  EXPECT_EQ(texel_at(slices[2], {1.5, 0.5}), palette().obstacle);
  EXPECT_EQ(texel_at(slices[2], {2.5, 0.5}), palette().free);
  EXPECT_GT(shapes_of<Arrow>(slices[2]).size(), 5u);
  EXPECT_LE(shapes_of<Arrow>(slices[1]).size(), 1u) << "of the layer between, the hatch alone is free";
  const Scene beyond = build_scene(session.run(), slice_view(7, {}), kView, palette());
  EXPECT_EQ(beyond.raster.texels, slices[2].raster.texels) << "beyond the last layer there is none";
}

TEST(Slice, CellsSmallerThanAPixelAreThoseOfTheLayerToo) {
  Scenario scenario = decks();
  scenario.map = GridMap(400, 300, 2);
  for (int y = 0; y < 300; ++y)
    for (int x = 200; x < 400; ++x) scenario.map.set({x, y, 1}, true);
  scenario.start = {3, 3, 0};
  scenario.goal = {9, 3, 0};
  scenario.surprises = {};
  scenario.movers = {};
  Session session(scenario);
  session.settle();
  SceneMemory memory;
  View view = slice_view(0, {});
  view.camera = {200, 150, 0.4};
  const auto right = [&](int slice) {
    view.slice.layer = slice;
    return texel_at(build_scene(session.run(), view, kView, palette(), memory), {300, 150});
  };
  EXPECT_EQ(right(0), palette().free);
  EXPECT_EQ(right(1), palette().obstacle) << "the coverage of the layer before is forgotten";
  EXPECT_EQ(right(0), palette().free);
}

TEST(Slice, LinesAndThingsOfOtherLayersAreFaint) {
  Session session(decks());
  session.settle();
  const auto opacity = [](Colour colour) { return colour >> 24; };
  for (int z = 0; z < 3; ++z) {
    const Scene scene =
        build_scene(session.run(), slice_view(z, {Overlay::path, Overlay::script}), kView, palette());
    std::size_t strong = 0, faint = 0;
    for (const Polyline& line : shapes_of<Polyline>(scene)) {
      if (line.dash > 0) continue;
      const bool here = opacity(line.colour) == 255;
      ++(here ? strong : faint);
      for (const Point& point : line.points) {
        const bool within = here ? point.z >= z && point.z <= z + 1 : point.z <= z || point.z >= z + 1;
        EXPECT_TRUE(within) << point.z << " in slice " << z;
      }
    }
    EXPECT_GE(strong + faint, 2u);
    EXPECT_GE(faint, 1u);
    const auto discs = shapes_of<Disc>(scene);
    const auto target = std::find_if(discs.begin(), discs.end(),
                                     [](const Disc& disc) { return disc.glyph == Glyph::target; });
    ASSERT_NE(target, discs.end());
    EXPECT_EQ(opacity(target->fill) == 255, z == 2);
    EXPECT_EQ(scene.shows(Sign::to_come), z != 1) << "the surprise has no cell in the layer between";
  }
}

/// The world in which what is seen of another one along an axis lies along z.
Scenario turned(const Scenario& scenario, Axis along) {
  const SeenBox seen(scenario.map.box(), along);
  Scenario turned = scenario;
  turned.map = GridMap(seen.width(), seen.height(), seen.depth());
  for (NodeId node = 0; node < seen.node_count(); ++node)
    turned.map.set(seen.position(node), scenario.map.blocked[node] != 0);
  turned.start = seen.seen(scenario.start);
  turned.goal = seen.seen(scenario.goal);
  Surprise surprise = scenario.surprises[0];
  for (CellChange& change : surprise.cells) change.cell = seen.seen(change.cell);
  std::sort(surprise.cells.begin(), surprise.cells.end(),
            [](const CellChange& a, const CellChange& b) { return in_node_order(a.cell, b.cell); });
  surprise.at.near = seen.seen(*surprise.at.near);
  turned.surprises = {surprise};
  for (MovingObstacle& mover : turned.movers) {
    const Cell size{mover.width - 1, mover.height - 1, mover.depth - 1};
    for (Cell& low : mover.way)
      low = box_of(seen.seen(low), seen.seen(Cell{low.x + size.x, low.y + size.y, low.z + size.z})).low;
    const Cell sides = seen.turned({mover.width, mover.height, mover.depth});
    mover.width = sides.x;
    mover.height = sides.y;
    mover.depth = sides.z;
  }
  return turned;
}

/// Seen along an axis, a world looks as one does that is turned so that this axis is z.
TEST(Slice, AlongAnyAxisShowsTheWorldAsIfItWereTurned) {
  Random random(5);
  Scenario scenario;
  scenario.map = GridMap(13, 9, 7);
  for (NodeId node = 0; node < scenario.map.blocked.size(); ++node)
    if (random.below(4) == 0) scenario.map.set(scenario.map.box().position(node), true);
  scenario.start = {1, 2, 3};
  scenario.goal = {11, 7, 5};
  scenario.map.set(scenario.start, false);
  scenario.map.set(scenario.goal, false);
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot.sensor_radius = 2.5;
  Surprise surprise;
  surprise.at.near = Cell{6, 4, 3};
  surprise.at.within = 3;
  surprise.cells = {{{5, 4, 2}, true}, {{6, 4, 3}, true}, {{6, 5, 3}, false}, {{6, 4, 4}, true}};
  scenario.surprises = {surprise};
  scenario.movers = {{.way = {{2, 0, 1}, {9, 5, 3}}, .width = 3, .height = 2, .depth = 1, .from = 50}};
  Session plain(scenario);
  plain.settle();
  ASSERT_TRUE(plain.apply(Seek{0}).ok());
  for (const Axis along : {Axis::x, Axis::y, Axis::z}) {
    Session other(turned(scenario, along));
    other.settle();
    ASSERT_TRUE(other.apply(Seek{0}).ok());
    const SeenBox seen(scenario.map.box(), along);
    SceneMemory memory;
    for (const double zoom : {0.0, 0.3})
      for (int layer = 0; layer < seen.depth(); ++layer) {
        View view = slice_view(layer, {Overlay::sensor, Overlay::script, Overlay::unknown});
        if (zoom > 0) view.camera = {3, 3, zoom};
        const Scene expected = build_scene(other.run(), view, kView, palette());
        view.slice.along = along;
        const Scene scene = build_scene(plain.run(), view, kView, palette(), memory);
        EXPECT_EQ(scene.columns, expected.columns);
        EXPECT_EQ(scene.raster.texels, expected.raster.texels) << static_cast<int>(along) << ' ' << layer;
        EXPECT_EQ(scene_svg(scene, palette()), scene_svg(expected, palette())) << layer;
      }
  }
}

TEST(Slice, HoveredAndPinnedCellsAreTheWorlds) {
  Session session(decks());
  session.settle();
  View view = slice_view(2, {});
  view.slice.along = Axis::y;
  view.hovered = Cell{5, 2, 0};
  const auto squares = [&] {
    const auto all = shapes_of<Outline>(build_scene(session.run(), view, kView, palette()));
    return std::count_if(all.begin(), all.end(), [](const Outline& each) {
      return each.shape == OutlineShape::square && each.x == 5 && each.y == 2 && each.width == 1;
    });
  };
  EXPECT_EQ(squares(), 1) << "x = 5, and z = 0 is the lowest of three rows";
  view.hovered = Cell{5, 1, 0};
  EXPECT_EQ(squares(), 0) << "on the layer before";
}

TEST(Slice, TheSensorIsTheCutOfABall) {
  Session session(decks());
  session.settle();
  std::vector<double> radii;
  for (int z = 0; z < 3; ++z) {
    const auto rings =
        shapes_of<Ring>(build_scene(session.run(), slice_view(z, {Overlay::sensor}), kView, palette()));
    radii.push_back(rings.empty() ? 0 : rings.front().radius);
  }
  EXPECT_DOUBLE_EQ(radii[0], 2);
  EXPECT_DOUBLE_EQ(radii[1], std::sqrt(3));
  EXPECT_DOUBLE_EQ(radii[2], 0);
}

}  // namespace
}  // namespace replan::scene_test
