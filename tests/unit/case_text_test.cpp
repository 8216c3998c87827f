// A moment as text: what it shows, and the way back to it.
#include "core/export/case_text.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/session/run.hpp"

namespace replan::case_text_test {
namespace {

/// A wall with a gap, and a surprise that closes it while the robot drives.
Scenario closing_gap() {
  Scenario scenario;
  scenario.name = "gap \"one\"";
  scenario.map = GridMap(12, 7);
  for (int y = 0; y < 7; ++y)
    if (y != 3 && y != 0) scenario.map.set({6, y}, true);
  scenario.start = {1, 3};
  scenario.goal = {10, 3};
  scenario.planners = {{"astar", {}}, {"dld-star-lite", {}}};
  scenario.planners[1].settings.set("range", 1.5);
  Surprise surprise;
  surprise.at.move = 2;
  surprise.cells = {{{6, 3}, true}};
  scenario.surprises = {surprise};
  return scenario;
}

struct Driven {
  std::shared_ptr<const Scenario> scenario;
  replan::Run run;
  Driven(Scenario world, std::size_t pane)
      : scenario(std::make_shared<const Scenario>(std::move(world))), run(scenario, pane) {
    run.finish(Target::end());
  }
  [[nodiscard]] std::string text(std::size_t position, CaseFocus focus) {
    run.timeline().seek(position);
    return case_text(*scenario, run.log_view(), focus);
  }
};

TEST(CaseText, LeadsBackToTheSameState) {
  Random random(3);
  for (const std::size_t pane : {0u, 1u}) {
    Driven driven(closing_gap(), pane);
    const std::size_t size = driven.run.timeline().size();
    std::vector<std::size_t> positions = {0, 1, size};
    for (int i = 0; i < 20; ++i) positions.push_back(random.below(static_cast<std::uint32_t>(size)));
    for (const std::size_t position : positions) {
      const std::string text = driven.text(position, {.pane = pane});
      ASSERT_TRUE(is_case_text(text));
      const auto moment = parse_case_text(text, "the clipboard");
      ASSERT_TRUE(moment.ok()) << moment.error();
      EXPECT_EQ(moment->pane, pane);
      EXPECT_EQ(moment->event, position);
      EXPECT_EQ(moment->scenario, *driven.scenario);
      Driven again(moment->scenario, moment->pane);
      again.run.timeline().seek(moment->event);
      EXPECT_EQ(again.run.timeline().state().hash(), moment->state);
      EXPECT_EQ(moment->state, driven.run.timeline().state().hash());
    }
  }
}

TEST(CaseText, ShowsWorldValuesAndOpenList) {
  Driven driven(closing_gap(), 1);
  // In the middle of the repair: the robot has seen that the gap is shut.
  std::size_t position = 0;
  for (const Milestone& milestone : driven.run.milestones())
    if (milestone.kind == EventKind::plan_begin) position = milestone.event;
  while (driven.run.timeline().event(position).kind != EventKind::pop) ++position;
  const std::string text = driven.text(position + 2, {.pane = 1});
  EXPECT_NE(text.find("planner   dld-star-lite (DLD* Lite) "), std::string::npos) << text;
  EXPECT_NE(text.find(" range=1.5"), std::string::npos) << text;
  EXPECT_NE(text.find("world     12 x 7 cells"), std::string::npos) << text;
  EXPECT_NE(text.find("R"), std::string::npos);
  EXPECT_NE(text.find("......@....."), std::string::npos) << text;
  EXPECT_NE(text.find("\nU         "), std::string::npos) << text;
  EXPECT_NE(text.find("cells     around "), std::string::npos) << text;
  EXPECT_NE(text.find("  rhs"), std::string::npos) << text;
  EXPECT_NE(text.find("last      {\"event\":"), std::string::npos) << text;
  const std::string region = driven.text(position + 2, {.pane = 1, .region = CellBox{{0, 0}, {11, 6}}});
  EXPECT_NE(region.find("cells     of the region from (0, 0)"), std::string::npos) << region;
}

/// Trees and populations have no open list, and cells no state of their own.
TEST(CaseText, OfATreeOrAPopulationSaysWhatItKeeps) {
  for (const auto& [planner, words] :
       {std::pair{"rrt-star", "\ntree      "}, {"improved-ga", "\npaths     "}}) {
    Scenario world = closing_gap();
    world.surprises.clear();
    world.planners = {{planner, {}}};
    Driven driven(std::move(world), 0);
    const std::string text = driven.text(driven.run.timeline().size(), {.pane = 0});
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_NE(text.find("the best path costs "), std::string::npos) << text;
    EXPECT_EQ(text.find("\nU "), std::string::npos) << text;
    EXPECT_EQ(text.find("unseen"), std::string::npos) << text;
    EXPECT_EQ(text.find("settled"), std::string::npos) << text;
    EXPECT_TRUE(parse_case_text(text, "the clipboard").ok());
  }
}

TEST(CaseText, TheNextOfTheOpenListIsTheOneThatIsTaken) {
  for (const std::size_t pane : {0u, 1u}) {
    Driven driven(closing_gap(), pane);
    int checked = 0;
    for (std::size_t i = 0; i < driven.run.timeline().size(); ++i) {
      const Event& event = driven.run.timeline().event(i);
      if (event.kind != EventKind::pop) continue;
      const std::string text = driven.text(i, {.pane = pane});
      const std::size_t list = text.find("\nU         in order") != std::string::npos
                                   ? text.find("\nU         in order")
                                   : text.find("\nU         the first");
      ASSERT_NE(list, std::string::npos) << text;
      const std::size_t names = text.find('\n', list + 1), first = text.find('\n', names + 1) + 1;
      const Cell at = driven.run.lattice().position(event.node);
      const std::string cell = "(" + std::to_string(at.x) + ", " + std::to_string(at.y) + ") ";
      ASSERT_EQ(text.substr(first, cell.size()), cell) << text;
      ++checked;
    }
    EXPECT_GT(checked, 10);
  }
}

TEST(CaseText, OfALargeWorldAPartIsDrawn) {
  Scenario large = closing_gap();
  large.map = GridMap(400, 300);
  large.start = {1, 1};
  large.goal = {390, 290};
  large.surprises.clear();
  large.planners[1].settings.set("heuristic", 2);  // zero: it expands all that is nearer than the start
  auto scenario = std::make_shared<const Scenario>(large);
  replan::Run run(scenario, 0);
  run.finish(Target::plan());
  const std::string text = case_text(*scenario, run.log_view(), {.pane = 0, .pin = Cell{399, 299}});
  EXPECT_NE(text.find("these begin at (300, 240)"), std::string::npos);
  const auto moment = parse_case_text(text, "x");
  ASSERT_TRUE(moment.ok()) << moment.error();
  EXPECT_EQ(moment->scenario, large) << "the scenario is whole all the same";
  replan::Run lookahead(scenario, 1);
  lookahead.finish(Target::plan());
  lookahead.timeline().seek(lookahead.timeline().size());
  const CaseFocus region{.pane = 1, .region = CellBox{{380, 280}, {399, 299}}};
  const std::string listed = case_text(*scenario, lookahead.log_view(), region);
  EXPECT_NE(listed.find("\nand 336 more\n"), std::string::npos) << "of 400 cells 64 are listed";
}

TEST(CaseText, ShowsABoxLayerByLayer) {
  Scenario scenario = closing_gap();
  scenario.map = GridMap(6, 3, 3);
  for (int y = 0; y < 3; ++y)
    for (int z = 0; z < 2; ++z) scenario.map.set({3, y, z}, true);
  scenario.start = {0, 1, 0};
  scenario.goal = {5, 1, 1};
  scenario.surprises.edit(0).cells = {{{3, 1, 2}, true}};
  Driven driven(scenario, 1);
  const std::string text = driven.text(driven.run.timeline().size(), {.pane = 1, .pin = Cell{3, 0, 2}});
  EXPECT_NE(text.find("6 x 3 x 3 voxels"), std::string::npos) << text;
  EXPECT_NE(text.find("layer     1\n...@..\n...@.R\n...@..\nlayer     2\n......\n...@..\n......\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("cells     around (3, 0, 2)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("robot     (5, 1, 1)"), std::string::npos) << text;
  const auto moment = parse_case_text(text, "the clipboard");
  ASSERT_TRUE(moment.ok()) << moment.error();
  EXPECT_EQ(moment->scenario, *driven.scenario);
}

TEST(CaseText, ReadsWhatMailMadeOfIt) {
  Driven driven(closing_gap(), 1);
  std::string quoted = "Hello,\n> > ";
  for (const char c : driven.text(100, {.pane = 1}))
    quoted += c == '\n' ? std::string("\r\n> > ") : std::string(1, c);
  ASSERT_TRUE(is_case_text(quoted));
  const auto moment = parse_case_text(quoted, "the clipboard");
  ASSERT_TRUE(moment.ok()) << moment.error();
  EXPECT_EQ(moment->event, 100u);
}

TEST(CaseText, SaysInOneSentenceWhatIsWrong) {
  Driven driven(closing_gap(), 1);
  const std::string good = driven.text(100, {.pane = 1});
  const auto fault = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    const auto moment = parse_case_text(text.replace(at, from.size(), to), "the clipboard");
    if (moment.ok()) return std::string("no error");
    EXPECT_EQ(moment.error().find('\n'), std::string::npos);
    EXPECT_TRUE(moment.error().starts_with("the clipboard")) << moment.error();
    return moment.error();
  };
  EXPECT_NE(fault("\nscenario ", "\nscene ").find("copy the text whole"), std::string::npos);
  EXPECT_NE(fault("\nat ", "\n").find("'at'"), std::string::npos);
  EXPECT_NE(fault("\"pane\":1", "\"pane\":2").find("no planner number 2"), std::string::npos);
  EXPECT_NE(fault("\"event\":100", "\"event\":-1").find("line 'at'"), std::string::npos);
  EXPECT_NE(fault("\"state\":\"", "\"state\":\"z").find("16 digits"), std::string::npos);
  EXPECT_NE(fault("\"start\":[1,3]", "\"start\":[1,300]").find("line 'scenario'"), std::string::npos);
  EXPECT_NE(fault("\"rows\":", "\"file\":\"/etc/passwd\",\"rows\":").find("line 'scenario'"),
            std::string::npos);
  const std::string cut = good.substr(0, good.size() - 40);
  EXPECT_NE(parse_case_text(cut, "the clipboard").error().find("line 'scenario'"), std::string::npos);
  EXPECT_FALSE(is_case_text("....\n.S.G\n"));
}

}  // namespace
}  // namespace replan::case_text_test
