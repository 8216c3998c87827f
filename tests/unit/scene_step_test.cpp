// The algorithm on the canvas: what a search has in hand, what waits, and how it looks from near and from afar.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/svg.hpp"
#include "core/session/player.hpp"
#include "core/session/session.hpp"
#include "core/session/stepping.hpp"
#include "tests/support/log_places.hpp"

namespace replan::scene_step_test {
namespace {

using test::after;

constexpr Viewport kView{640, 480};

Palette palette() {
  Palette colours;
  colours.background = 0xFF010101;
  colours.surround = 0xFF030303;
  colours.free = 0xFF000000;
  colours.obstacle = 0xFFFFFFFF;
  colours.unseen = 0xFF884422;
  colours.accent = 0xFFFFAA00;
  colours.text = 0xFFEEEEEE;
  colours.dim = 0xFF777777;
  colours.rhs = 0xFF11EE11;
  colours.path = 0xFF00FFFF;
  colours.field_opacity = 1;
  for (std::size_t i = 0; i < colours.field.size(); ++i)
    colours.field[i] = 0xFF400000u | static_cast<Colour>(i);
  return colours;
}

Scenario world(const std::string& planner = "dstar-lite") {
  Scenario scenario;
  scenario.map = GridMap(20, 10);
  for (int y = 0; y < 9; ++y)
    if (y != 2) scenario.map.set({10, y}, true);
  scenario.start = {2, 7};
  scenario.goal = {17, 7};
  scenario.planners = {{planner, {}}};
  Surprise surprise;
  surprise.at.move = 3;
  surprise.cells = {{{10, 9}, true}};
  surprise.announced = true;
  scenario.surprises = {surprise};
  return scenario;
}

std::unique_ptr<Run> finished(const Scenario& scenario) {
  auto run = std::make_unique<replan::Run>(std::make_shared<const Scenario>(scenario), 0);
  run->finish(Target::end());
  return run;
}

template <class S>
std::vector<S> shapes_of(const Scene& scene) {
  std::vector<S> found;
  for (const Shape& shape : scene.shapes)
    if (const S* each = std::get_if<S>(&shape)) found.push_back(*each);
  return found;
}

View view_of(std::initializer_list<Overlay> overlays, Camera camera = {}) {
  View view;
  view.overlays = {};
  for (const Overlay overlay : overlays) view.overlays.set(overlay, true);
  view.camera = camera;
  return view;
}

Scene scene_at(Run& run, std::size_t position, const View& view, Viewport size = kView) {
  run.timeline().seek(position);
  return build_scene(run, view, size, palette());
}

bool has_label(const Scene& scene, const std::string& part) {
  const auto labels = shapes_of<Label>(scene);
  return std::any_of(labels.begin(), labels.end(),
                     [&](const Label& label) { return label.text.find(part) != std::string::npos; });
}

std::vector<Ring> rings_around(const Scene& scene, Point at) {
  std::vector<Ring> rings = shapes_of<Ring>(scene);
  std::erase_if(rings, [&](const Ring& ring) { return ring.centre.x != at.x || ring.centre.y != at.y; });
  return rings;
}

TEST(Step, ARingStandsAroundTheVertexInHandWithEveryPlanner) {
  for (const char* planner : {"astar", "dijkstra", "dstar-lite", "dld-star-lite"}) {
    const auto run = finished(world(planner));
    const std::size_t position = after(*run, EventKind::pop, 9);
    const Cell u = run->lattice().position(run->timeline().event(position - 1).node);
    for (const double zoom : {0.4, 3.0, 12.0, 29.0, 80.0}) {
      const Scene scene = scene_at(*run, position, view_of({Overlay::step}, {u.x + 0.5, u.y + 0.5, zoom}));
      const auto rings = rings_around(scene, centre_of(u));
      ASSERT_FALSE(rings.empty()) << planner << " at " << zoom;
      EXPECT_EQ(rings.back().colour, palette().accent);
      EXPECT_EQ(rings.back().dash, 0);
      EXPECT_GE(rings.back().radius * zoom, 8) << "it can be found from afar";
      EXPECT_TRUE(scene.shows(Sign::in_hand));
    }
  }
}

TEST(Step, IsOnByDefaultAndShowsNothingWhileAPlanStands) {
  EXPECT_TRUE(default_overlays().has(Overlay::step));
  EXPECT_TRUE(default_overlays().has(Overlay::waiting));
  const auto run = finished(world());
  const Scene scene = scene_at(*run, after(*run, EventKind::plan_end, 0), view_of({Overlay::step}));
  EXPECT_FALSE(scene.shows(Sign::in_hand) || scene.shows(Sign::written) || scene.shows(Sign::tried));
  EXPECT_TRUE(shapes_of<Ring>(scene).empty());
}

TEST(Step, TheValueJustWrittenStandsBesideItsCell) {
  const auto run = finished(world());
  const std::size_t position = after(*run, EventKind::rhs, 1);  // the first is that of the goal
  const Cell cell = run->lattice().position(run->timeline().event(position - 1).node);
  for (const double zoom : {8.0, 29.0, 60.0}) {
    const Scene scene =
        scene_at(*run, position, view_of({Overlay::step}, {cell.x + 0.5, cell.y + 0.5, zoom}));
    EXPECT_TRUE(has_label(scene, "rhs: ∞ → 1.4")) << zoom;
    const auto frames = shapes_of<Outline>(scene);
    EXPECT_TRUE(std::any_of(frames.begin(), frames.end(), [&](const Outline& frame) {
      return frame.x == cell.x && frame.y == cell.y && frame.shape == OutlineShape::filled;
    }));
  }
}

TEST(Step, NearEnoughATriedNeighbourShowsItsSum) {
  const auto run = finished(world());
  const std::size_t position = after(*run, EventKind::rhs, 1);
  EXPECT_TRUE(has_label(scene_at(*run, position, view_of({Overlay::step}, {16, 7, 60})), "1.4+0.0"));
  EXPECT_FALSE(has_label(scene_at(*run, position, view_of({Overlay::step}, {16, 7, 29})), "1.4+0.0"));
  const auto clearance = finished(world("dist-dstar-lite"));
  Scene near_wall;
  std::size_t with_penalty = 0;
  for (std::size_t p = after(*clearance, EventKind::pop, 0); p < after(*clearance, EventKind::plan_end, 0);
       ++p) {
    near_wall = scene_at(*clearance, p, view_of({Overlay::step}, {10, 5, 60}));
    for (const Label& label : shapes_of<Label>(near_wall))
      with_penalty += label.text.starts_with('+') ? 1u : 0u;  // on a line of its own: the cell is narrow
  }
  EXPECT_GT(with_penalty, 0u) << "dist below c + g";
}

TEST(Step, StandsInADrawingToo) {
  const auto run = finished(world());
  const Scene scene = scene_at(*run, after(*run, EventKind::rhs, 1), view_of({Overlay::step}));
  const std::string svg = scene_svg(scene, palette());
  EXPECT_NE(svg.find("rhs: ∞ → 1.4"), std::string::npos);
  EXPECT_NE(svg.find("<circle"), std::string::npos);
  EXPECT_EQ(svg.find("stroke-dasharray=\"0\""), std::string::npos);
}

TEST(Waiting, BothNumbersStandInCellsThatDifferInTwoColours) {
  const auto run = finished(world());
  const std::size_t position = after(*run, EventKind::pop, 9) - 1;
  const View near = view_of({Overlay::waiting, Overlay::queue}, {15, 6, 27});
  const Scene scene = scene_at(*run, position, near);
  const SearchState& state = run->timeline().state();
  std::size_t differ = 0, waiting = 0;
  for (NodeId n = 0; n < run->lattice().node_count(); ++n) {
    differ += state.g(n) != state.rhs(n) ? 1 : 0;
    waiting += state.queued(n) ? 1 : 0;
  }
  ASSERT_GT(differ, 3u);
  const auto labels = shapes_of<Label>(scene);
  const auto of_colour = [&](Colour colour) {
    return static_cast<std::size_t>(std::count_if(
        labels.begin(), labels.end(), [&](const Label& label) { return label.colour == colour; }));
  };
  EXPECT_EQ(of_colour(palette().text), differ);
  EXPECT_EQ(of_colour(palette().rhs), differ);
  const auto frames = shapes_of<Outline>(scene);
  EXPECT_EQ(static_cast<std::size_t>(
                std::count_if(frames.begin(), frames.end(),
                              [](const Outline& frame) { return frame.shape == OutlineShape::corners; })),
            waiting);
  EXPECT_TRUE(scene.shows(Sign::two_values) && scene.shows(Sign::queue));
  const Scene farther = scene_at(*run, position, view_of({Overlay::waiting, Overlay::queue}, {15, 6, 15}));
  EXPECT_TRUE(shapes_of<Label>(farther).empty());
  EXPECT_EQ(shapes_of<Outline>(farther).size(), 4 + waiting) << "the world's edge and the open list";
  for (const double zoom : {2.0, 6.0, 11.0}) {
    const auto dots = shapes_of<Outline>(
        scene_at(*run, position, view_of({Overlay::waiting, Overlay::queue}, {15, 6, zoom})));
    EXPECT_EQ(dots.size(), 4 + waiting) << zoom;
    EXPECT_EQ(dots.back().shape, OutlineShape::filled);
    EXPECT_GE(dots.back().width * zoom, 2 - 1e-9) << "it can be seen";
  }
}

/// The box of a label in cells, as wide as its digits.
struct Box2 {
  double left, top, right, bottom;
};
Box2 box_of(const Label& label, double zoom) {
  const auto count =
      std::count_if(label.text.begin(), label.text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  const double width = 6 * static_cast<double>(count) / zoom, height = 8 / zoom;
  const bool right = label.anchor == Anchor::upper_right || label.anchor == Anchor::lower_right;
  const bool low = label.anchor == Anchor::lower_left || label.anchor == Anchor::lower_right;
  const bool middle = label.anchor == Anchor::middle;
  const double x = label.at.x - (middle  ? width / 2
                                 : right ? width
                                         : 0),
               y = label.at.y - (middle ? height / 2
                                 : low  ? height
                                        : 0);
  return {x, y, x + width, y + height};
}
bool meet(const Box2& a, const Box2& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

TEST(Numbers, NeverStandHalfThereBetweenTwoLayouts) {
  const auto run = finished(world());
  const std::size_t position = after(*run, EventKind::pop, 9) - 1;
  for (double zoom = 20; zoom < 90; zoom += 0.5) {
    const Scene scene =
        scene_at(*run, position, view_of({Overlay::numbers, Overlay::waiting}, {15, 6, zoom}));
    std::size_t middle = 0, corners = 0;
    for (const Label& label : shapes_of<Label>(scene)) {
      EXPECT_EQ(label.colour >> 24, 0xFFu) << zoom;
      EXPECT_EQ(label.ground >> 24, 0xFFu) << "what runs under it would strike it through";
      ++(label.anchor == Anchor::middle ? middle : corners);
    }
    EXPECT_TRUE(middle == 0 || corners == 0) << zoom;
    EXPECT_EQ(middle + corners > 0, scene.numbers != NumbersShown::none) << zoom;
  }
}

TEST(Numbers, BothStandInSettledCellsTooAndTheSceneSaysWhichThereAre) {
  const auto run = finished(world());
  const std::size_t planned = after(*run, EventKind::plan_end, 0);
  const View view = view_of({Overlay::numbers, Overlay::waiting}, {15, 6, 58});
  const Scene scene = scene_at(*run, planned, view);
  EXPECT_EQ(scene.numbers, NumbersShown::two);
  EXPECT_EQ(scene.written, kNumberG | kNumberRhs);
  std::size_t settled = 0;
  for (const Label& label : shapes_of<Label>(scene)) settled += label.colour == palette().text ? 1u : 0u;
  EXPECT_GT(settled, 20u);
  const auto afresh = finished(world("astar"));
  const Scene alone = scene_at(*afresh, after(*afresh, EventKind::plan_end, 0), view);
  EXPECT_EQ(alone.numbers, NumbersShown::one);
  EXPECT_EQ(alone.written, kNumberG) << "the planner has no rhs";
}

TEST(Numbers, DoNotMeetEachOtherInAnyLayout) {
  const auto run = finished(world("dist-dstar-lite"));
  for (const std::size_t position : {after(*run, EventKind::pop, 9) - 1, after(*run, EventKind::plan_end, 0)})
    for (const double zoom : {26.0, 33.0, 43.0, 44.0, 58.0, 71.0, 72.0, 87.0}) {
      const auto labels = shapes_of<Label>(
          scene_at(*run, position, view_of({Overlay::numbers, Overlay::waiting}, {15, 6, zoom})));
      for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
          ASSERT_FALSE(meet(box_of(labels[i], zoom), box_of(labels[k], zoom)))
              << labels[i].text << " on " << labels[k].text << " at " << zoom;
    }
}

TEST(Notes, LieOnNoNumberAndInsideTheView) {
  const auto run = finished(world());
  const View view = view_of({Overlay::numbers, Overlay::waiting, Overlay::step, Overlay::path}, {15, 6, 58});
  std::size_t looked_at = 0;
  for (std::size_t p = after(*run, EventKind::pop, 3); p < after(*run, EventKind::pop, 9); ++p) {
    const Scene scene = scene_at(*run, p, view);
    const auto labels = shapes_of<Label>(scene);
    for (const Label& note : labels) {
      if (note.ground >> 24 != 0) continue;  // a number
      ++looked_at;
      const Box2 box = box_of(note, 58);
      for (const Label& number : labels)
        if (number.ground >> 24 != 0) {
          EXPECT_FALSE(meet(box, box_of(number, 58))) << note.text << " on " << number.text;
        }
      EXPECT_GE(box.left, 15 - kView.width / 116.0);
      EXPECT_LE(box.right, 15 + kView.width / 116.0);
      EXPECT_GE(box.top, 6 - kView.height / 116.0);
      EXPECT_LE(box.bottom, 6 + kView.height / 116.0);
    }
  }
  EXPECT_GT(looked_at, 20u);
}

TEST(Waiting, CellsLookTheSameWithAnyPlanner) {
  for (const char* planner : {"astar", "dstar-lite"}) {
    const auto run = finished(world(planner));
    const Scene scene = scene_at(*run, after(*run, EventKind::plan_end, 0),
                                 view_of({Overlay::g, Overlay::queue, Overlay::waiting}));
    const SearchState& state = run->timeline().state();
    const Raster& raster = scene.raster;
    for (NodeId n = 0; n < run->lattice().node_count(); ++n) {
      const Cell cell = run->lattice().position(n);
      if (!state.queued(n) || state.known_blocked(n)) continue;
      EXPECT_EQ(raster.texels[static_cast<std::size_t>(cell.y * raster.columns + cell.x)], palette().free)
          << planner << " has not settled " << cell.x << ", " << cell.y;
    }
  }
}

TEST(Numbers, HaveLinesBetweenTheCellsAndTheKeyThatThePlannerDeclares) {
  const auto run = finished(world("astar"));
  const std::size_t position = after(*run, EventKind::pop, 9);
  const Scene scene = scene_at(*run, position, view_of({Overlay::numbers}, {4, 7, 80}));
  EXPECT_EQ(scene.numbers, NumbersShown::four);
  EXPECT_GT(shapes_of<Line>(scene).size(), 8u);
  // A*'s key is [f; h]: below each cell of the list stand its f and f - g.
  const SearchState& state = run->timeline().state();
  const auto text = [](Cost cost) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.1f", cost.to_double());
    return std::string(digits);
  };
  std::size_t found = 0;
  for (const Label& label : shapes_of<Label>(scene)) {
    if (label.anchor != Anchor::lower_right) continue;
    const NodeId n = run->lattice().node({static_cast<int>(label.at.x), static_cast<int>(label.at.y)});
    EXPECT_EQ(label.text, text(Cost{state.k1(n).raw - state.g(n).raw}));
    ++found;
  }
  EXPECT_GT(found, 0u);
}

TEST(Field, SaysWhichWayItsCostsGoAndTheValueThatIsPointedAt) {
  View view = view_of({Overlay::g});
  view.hovered = Cell{15, 7};
  const auto words = [&](const char* planner) {
    const auto run = finished(world(planner));
    return scene_at(*run, after(*run, EventKind::plan_end, 0), view).field_words;
  };
  EXPECT_EQ(words("astar"), "g: cost from the start");
  EXPECT_EQ(words("dstar-lite"), "g: cost to the goal");
  const auto run = finished(world());
  EXPECT_EQ(scene_at(*run, after(*run, EventKind::plan_end, 0), view).pointed, 2.0);
  view.hovered = Cell{10, 5};
  EXPECT_FALSE(scene_at(*run, run->timeline().cursor(), view).pointed) << "a wall";
}

TEST(Field, ColoursReachOverTheWholeRunOrOverWhatThereIsSoFar) {
  const auto run = finished(world());
  const std::size_t early = after(*run, EventKind::pop, 12);
  View view = view_of({Overlay::g});
  const auto whole = scene_at(*run, early, view).range;
  view.range = FieldSpan::so_far;
  const auto so_far = scene_at(*run, early, view).range;
  ASSERT_TRUE(whole && so_far);
  EXPECT_LT(so_far->high, whole->high / 2);
  double most = 0;
  for (NodeId n = 0; n < run->lattice().node_count(); ++n)
    if (const Cost g = run->timeline().state().g(n); !g.is_infinite()) most = std::max(most, g.to_double());
  EXPECT_DOUBLE_EQ(so_far->high, most);
}

TEST(FarOut, TheWorldHasAnEdgeAndThePointedCellARing) {
  Scenario scenario = world();
  scenario.map = GridMap(600, 400);
  scenario.surprises = {};
  const auto run = finished(scenario);
  View view = view_of({}, {300, 200, 0.5});
  view.hovered = Cell{500, 300};
  const Scene scene = scene_at(*run, run->timeline().size(), view);
  EXPECT_EQ(scene.background, palette().surround);
  std::size_t sides = 0;
  for (const Outline& side : shapes_of<Outline>(scene))
    if (side.colour == palette().obstacle && std::min(side.width, side.height) * 0.5 >= 1.5 - 1e-9) ++sides;
  EXPECT_EQ(sides, 4u);
  const auto rings = rings_around(scene, centre_of({500, 300, 0}));
  ASSERT_FALSE(rings.empty());
  EXPECT_GE(rings.back().radius * 0.5, 8);
  view.camera = {500, 300, 20};
  EXPECT_TRUE(shapes_of<Ring>(scene_at(*run, run->timeline().size(), view)).empty()) << "its frame is enough";
}

TEST(FarOut, CellsAreAveragedByTheirMeanColour) {
  for (const double share : {0.1, 0.3, 0.6, 1.0}) {
    Scenario scenario;
    scenario.map = GridMap(1000, 1000);
    Random random(5);
    for (int y = 2; y < 1000; ++y)
      for (int x = 0; x < 1000; ++x)
        if (random.chance(share)) scenario.map.set({x, y}, true);
    scenario.start = {0, 0};
    scenario.goal = {3, 0};
    scenario.planners = {{"dstar-lite", {}}};
    replan::Run run(std::make_shared<const Scenario>(scenario), 0);
    run.finish(Target::plan());
    for (const double zoom : {0.13, 0.2, 0.33, 0.5, 0.8}) {
      const View view = view_of({}, {500, 500, zoom});
      const Scene scene = build_scene(run, view, {200, 100}, palette());
      double sum = 0;
      std::size_t count = 0;
      const Raster& raster = scene.raster;
      for (int row = raster.rows / 4; row < raster.rows * 3 / 4; ++row)
        for (int column = 10; column < raster.columns - 10; ++column, ++count)
          sum += raster.texels[static_cast<std::size_t>(row * raster.columns + column)] & 255u;
      EXPECT_NEAR(sum / static_cast<double>(count) / 255, share, 0.1) << share << " at " << zoom;
    }
  }
}

TEST(FarOut, DotsAndHeadsStandInLargeCellsAloneAndLinesKeepToTheirCells) {
  const auto run = finished(world("dld-star-lite"));
  View view = view_of({Overlay::path, Overlay::rp});
  view.pinned = Cell{2, 7};
  const auto scene_of = [&](double zoom) {
    view.camera = {10, 5, zoom};
    return scene_at(*run, after(*run, EventKind::plan_end, 0), view);
  };
  const auto dots = [](const Scene& scene) {
    std::size_t count = 0;
    for (const Disc& disc : shapes_of<Disc>(scene))
      count += (disc.fill & 0xFFFFFFu) == (palette().accent & 0xFFFFFFu);
    return count;
  };
  const auto heads = [](const Scene& scene) {
    const auto arrows = shapes_of<Arrow>(scene);
    return std::count_if(arrows.begin(), arrows.end(), [](const Arrow& arrow) { return arrow.head > 0; });
  };
  EXPECT_GT(dots(scene_of(20)), 0u);
  EXPECT_GT(heads(scene_of(20)), 0);
  for (const double zoom : {0.2, 1.1, 4.0}) {
    const Scene scene = scene_of(zoom);
    EXPECT_EQ(dots(scene), 0u) << zoom;
    EXPECT_EQ(heads(scene), 0) << zoom;
    EXPECT_FALSE(shapes_of<Arrow>(scene).empty()) << "the chain itself stays";
    EXPECT_LE(shapes_of<Polyline>(scene).front().width, std::max(1.2, zoom) + 1e-6) << zoom;
  }
  EXPECT_EQ(shapes_of<Polyline>(scene_of(20)).front().width, 3);
}

TEST(Unseen, WhatAMapCallsUnknownHasAColourOfItsOwn) {
  Scenario scenario = world();
  scenario.map.set({3, 1}, true);
  scenario.map.set({4, 1}, true);
  auto unknown = std::make_shared<std::vector<bool>>(scenario.map.blocked.size());
  (*unknown)[scenario.map.index({3, 1})] = true;
  scenario.map_found.unknown = unknown;
  const auto run = finished(scenario);
  const auto colour_at = [&](const Scene& scene, Cell cell) {
    const Raster& raster = scene.raster;
    const auto column = static_cast<int>((cell.x + 0.5 - raster.x) / raster.width * raster.columns);
    const auto row = static_cast<int>((cell.y + 0.5 - raster.y) / raster.height * raster.rows);
    return raster.texels[static_cast<std::size_t>(row * raster.columns + column)];
  };
  const Scene near = scene_at(*run, 0, view_of({}));
  EXPECT_EQ(colour_at(near, {3, 1}), palette().unseen);
  EXPECT_EQ(colour_at(near, {4, 1}), palette().obstacle);
  EXPECT_TRUE(near.shows(Sign::unseen) && near.shows(Sign::obstacle) && near.shows(Sign::free));
}

TEST(BeforeARepair, IsWhereRhsHasJumpedAndNoVertexWasTaken) {
  const auto run = finished(world());
  std::vector<std::size_t> places;
  for (std::size_t p = 0; p <= run->timeline().size(); ++p)
    if (is_before_repair(*run, p)) places.push_back(p);
  ASSERT_EQ(places.size(), 1u);
  const std::size_t place = places.front();
  EXPECT_EQ(run->timeline().event(place).kind, EventKind::pop);
  run->timeline().seek(place);
  const SearchState& state = run->timeline().state();
  EXPECT_TRUE(state.known_blocked(run->lattice().node({10, 9}))) << "what is blocked now is known";
  std::size_t jumped = 0;
  for (NodeId n = 0; n < run->lattice().node_count(); ++n)
    jumped += !state.g(n).is_infinite() && state.rhs(n) > state.g(n) ? 1 : 0;
  EXPECT_GT(jumped, 0u) << "rhs has jumped and g has not";
  const auto afresh = finished(world("astar"));
  for (std::size_t p = 0; p <= afresh->timeline().size(); ++p)
    EXPECT_FALSE(is_before_repair(*afresh, p)) << "a plan from scratch repairs nothing";
}

/// Seconds that playing at a speed stands on a position, coming from the robot's move before it.
double seconds_on(Run& run, std::size_t place, double speed) {
  Player player;
  player.set_speed(speed);
  player.play(1);
  run.timeline().seek(after(run, EventKind::plan_begin, 1) - 1);
  double seconds = 0;
  for (int frame = 0; frame < 2000 && run.timeline().cursor() <= place; ++frame) {
    run.timeline().seek(player.advance(run, 0.01).cursor);
    if (run.timeline().cursor() == place) seconds += 0.01;
  }
  return seconds;
}

TEST(BeforeARepair, PlayingPausesAtAReadableSpeedAlone) {
  const auto run = finished(world());
  const std::size_t place = next_stop(*run, after(*run, EventKind::plan_begin, 1), StepUnit::expansion);
  ASSERT_TRUE(is_before_repair(*run, place));
  EXPECT_NEAR(seconds_on(*run, place, 240), Player::kRepairSeconds, 0.05);
  EXPECT_NEAR(seconds_on(*run, place, 0.5), 2, 0.05)
      << "slower than that it stands as long as any other step";
  EXPECT_LT(seconds_on(*run, place, 5000), 0.05);
}

}  // namespace
}  // namespace replan::scene_step_test
