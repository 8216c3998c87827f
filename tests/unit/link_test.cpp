// Links to a moment: what goes in comes out, and leads to the same events; what is no link is told in one sentence.
#include "core/link/link.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "core/base/base64.hpp"
#include "core/base/file.hpp"
#include "core/link/deflate.hpp"
#include "core/session/session.hpp"
#include "core/trace/log_hash.hpp"
#include "core/world/choices.hpp"
#include "tests/support/missions.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/worlds.hpp"

namespace replan::link_test {
namespace {

std::uint32_t hash_of(const Timeline& log, std::size_t events) {
  LogHash hash(events);
  EXPECT_TRUE(hash.advance(log, Deadline::never()));
  return hash.short_value();
}

std::string written(const Scenario& scenario, const LinkView& view = {}) {
  const Result<std::string> text = link_text(scenario, view);
  EXPECT_TRUE(text.ok()) << (text ? "" : text.error());
  return text ? *text : "";
}

/// A moment, and nothing else.
LinkView at(std::size_t event, std::optional<std::uint32_t> log = {}) {
  LinkView view;
  view.event = event;
  view.log = log;
  return view;
}

Scenario small_world() {
  Scenario scenario;
  scenario.name = "Gap";
  scenario.map = GridMap(8, 5);
  for (int y = 1; y < 5; ++y) scenario.map.set({3, y}, true);
  scenario.start = {0, 4};
  scenario.goal = {7, 4};
  scenario.planners = {{"dstar-lite", {}, {}}, {"astar", {}, {}}};
  scenario.robot.knowledge = Knowledge::map;
  return scenario;
}

Scenario voxels() {
  Scenario scenario = small_world();
  scenario.map = GridMap(6, 5, 4);
  scenario.start = {0, 0, 0};
  scenario.goal = {5, 4, 3};
  scenario.planners = {{"dstar-lite", {}, {}}, {"astar", {}, {}}};
  return scenario;
}

/// The sentence of a link that is wrong, which must be one.
std::string error_of(const std::string& text) {
  const auto link = parse_link(text);
  if (link.ok()) return "";
  EXPECT_TRUE(link.error().starts_with("the link: ")) << link.error();
  EXPECT_EQ(link.error().find('\n'), std::string::npos) << link.error();
  EXPECT_LT(link.error().size(), 400u) << link.error();
  return link.error();
}

void expect_sentence(const std::string& text, const std::string& part) {
  EXPECT_NE(error_of(text).find(part), std::string::npos) << text.substr(0, 200) << ": " << error_of(text);
}

std::string with_world(const std::string& bytes) {
  return "#v=1&world=" + base64url(deflated(bytes));
}

TEST(Base64Url, IsReadBackAndNothingElseIsRead) {
  Random random(5);
  std::string bytes;
  for (int size = 0; size < 200; ++size) {
    const std::string text = base64url(bytes);
    EXPECT_EQ(text.find_first_of("+/= "), std::string::npos);
    EXPECT_EQ(from_base64url(text), bytes);
    bytes += static_cast<char>(random.between(0, 255));
  }
  EXPECT_EQ(base64url("\xFB\xFF\xFE"), "-__-");
  for (const char* wrong : {"A", "AAAAA", "AA==", "A+AA", "A/AA", "AA A", "AA\n", "AB", "AAB", "\xC3\xA4"})
    EXPECT_FALSE(from_base64url(wrong).has_value()) << wrong;
}

TEST(Deflate, KeepsToItsLimitAndSeesDamage) {
  Random random(6);
  std::string bytes;
  for (int i = 0; i < 50'000; ++i) bytes += static_cast<char>(random.between(0, i % 256));
  for (const std::string& each : {bytes, std::string(), std::string("x"), std::string(1 << 20, '\0')}) {
    const std::string stream = deflated(each);
    const auto back = inflated(stream, each.size());
    ASSERT_TRUE(back.ok()) << back.error();
    EXPECT_EQ(*back, each);
    EXPECT_TRUE(each.empty() || !inflated(stream, each.size() - 1).ok());
    EXPECT_FALSE(inflated(stream + "x", each.size()).ok());
    for (const std::size_t cut : {std::size_t{0}, std::size_t{1}, stream.size() / 2, stream.size() - 1})
      EXPECT_FALSE(inflated(std::string_view(stream).substr(0, cut), each.size()).ok()) << cut;
  }
}

TEST(LogHashes, OfTheWholeLogAreItsOwnAndTheirPartsDiffer) {
  Session session(small_world());
  session.settle();
  const Timeline& log = session.run().timeline();
  LogHash whole(log.size());
  int slices = 1;
  while (!whole.advance(log, Deadline(0))) ++slices;
  EXPECT_EQ(whole.value(), log.log_hash());
  EXPECT_EQ(whole.share(), 1);
  EXPECT_NE(hash_of(log, log.size()), hash_of(log, log.size() - 1));
  EXPECT_NE(hash_of(log, 1), hash_of(log, 0));
}

/// The link of a world at some moments of its run leads to the same world and the same log up to there.
void expect_same_moments(const Scenario& scenario) {
  Session session(scenario);
  ASSERT_TRUE(session.apply(RunTo{3000}).ok());
  session.settle();
  const Timeline& log = session.run().timeline();
  for (const std::size_t event : {log.size() / 3, std::min<std::size_t>(log.size(), 3000)}) {
    const std::string text = written(session.scenario(), at(event, hash_of(log, event)));
    const auto link = parse_link("https://example.org/replan.html" + text);
    ASSERT_TRUE(link.ok()) << link.error();
    EXPECT_TRUE(link->notes.empty());
    EXPECT_EQ(link->scenario, linked_scenario(scenario));
    ASSERT_EQ(link->view.event, event);
    Session opened(link->scenario);
    opened.settle();
    ASSERT_TRUE(opened.apply(RunTo{event}).ok());
    opened.settle();
    ASSERT_GE(opened.run().timeline().size(), event);
    EXPECT_EQ(hash_of(opened.run().timeline(), event), link->view.log);
  }
}

TEST(Links, LeadToTheSameMomentOfEveryWorldOfTheLibrary) {
  std::size_t longest = 0;
  for (const auto& file : test::files_below(REPLAN_SOURCE_DIR "/maps", ".json")) {
    SCOPED_TRACE(file);
    const auto scenario = read_scenario(file.string());
    ASSERT_TRUE(scenario.ok()) << scenario.error();
    expect_same_moments(*scenario);
    longest = std::max(longest, written(*scenario).size());
  }
  EXPECT_LT(longest, kLongLink) << "worlds of lessons go through mail";
}

TEST(Links, LeadToTheSameMomentWithEveryPlannerInRandomWorlds) {
  Random random(7);
  for (const PlannerInfo& info : planners())
    for (const bool solid : {false, true}) {
      SCOPED_TRACE(std::string(info.id) + (solid ? " in space" : ""));
      if (!fits(info, solid ? Box(5, 5, 5) : Box(9, 9), 0)) continue;
      expect_same_moments(solid ? test::random_voxel_scenario(random, info)
                                : test::random_scenario(random, info));
    }
}

/// Edits of a running mission are part of what a link holds, in the order in which they were made.
TEST(Links, HoldWhatWasDoneByHandOnTheWay) {
  Session session(small_world());
  session.settle();
  const auto go = [&](std::size_t events) {
    static_cast<void>(session.apply(Step{StepUnit::move, static_cast<int>(events)}));
    session.settle();
  };
  const auto expect_back = [&](const char* what) {
    SCOPED_TRACE(what);
    ASSERT_TRUE(session.apply(RunToEnd{}).ok());
    session.settle();
    for (const auto& run : session.runs()) run->finish(Target::end());
    session.update(0);
    const Timeline& log = session.run().timeline();
    const auto link = parse_link(written(session.scenario(), at(log.size())));
    ASSERT_TRUE(link.ok()) << link.error();
    Session opened(link->scenario);
    ASSERT_TRUE(opened.apply(RunToEnd{}).ok());
    opened.settle();
    for (const auto& run : opened.runs()) run->finish(Target::end());
    opened.update(0);
    EXPECT_EQ(opened.run().timeline().size(), log.size());
    EXPECT_EQ(opened.run().timeline().log_hash(), log.log_hash());
    Scenario without = link->scenario;
    ASSERT_FALSE(without.surprises.empty());
    without.surprises.erase(without.surprises.size() - 1);
    Session other(without);
    other.settle();
    other.runs()[0]->finish(Target::end());
    EXPECT_NE(other.run().timeline().log_hash(), log.log_hash()) << "what was done makes a difference";
  };
  ASSERT_TRUE(session.apply(PaintCells{{{{1, 3}, true}}}).ok());  // before it has set out
  expect_back("a repair before the first step");
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  go(2);
  ASSERT_TRUE(session.apply(PaintCells{{{{2, 0}, true}, {{3, 1}, false}}}).ok());
  expect_back("cells that the robot is told of");
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  go(3);
  ASSERT_TRUE(session.apply(DropSurprise{{{{5, 4}, true}}}).ok());
  expect_back("cells that it has to see");
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  go(4);
  ASSERT_TRUE(session.apply(SetGoal{{7, 0}}).ok());
  expect_back("a goal that moves");
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  go(5);
  ASSERT_TRUE(session.apply(PutRobot{{6, 2}}).ok());
  expect_back("a robot that is put elsewhere");
  ASSERT_TRUE(session.apply(AddMover{{.way = {{5, 0}, {5, 3}}}}).ok());
  expect_back("something that moves");
}

TEST(Links, SayWhatIsLookedAt) {
  OverlaySet shown;
  shown.set(overlays()[1].overlay, true);
  const LinkView view{.event = 123,
                      .log = 0x01abcdef,
                      .lead = 1,
                      .lockstep = Lockstep::race,
                      .overlays = shown,
                      .dark = false,
                      .tab = "cell",
                      .pin = Cell{7, 0},
                      .camera = ViewSetup::Camera{3.5, -2.25, 48},
                      .slices = {},
                      .orbit = {},
                      .orbits = {}};
  const std::string text = written(small_world(), view);
  EXPECT_TRUE(text.starts_with("#v=1&at=123&log=01abcdef&lead=2&lockstep=race&panes=2&theme=light&overlays=" +
                               std::string(overlays()[1].id) +
                               "&tab=cell&pin=7,0&camera=3.5,-2.25,48&world="))
      << text;
  const auto link = parse_link(text);
  ASSERT_TRUE(link.ok()) << link.error();
  EXPECT_EQ(link->view, view);
  LinkView bare;
  bare.overlays = OverlaySet{};
  const auto none = parse_link(written(small_world(), bare));
  ASSERT_TRUE(none.ok()) << none.error();
  EXPECT_EQ(none->view.overlays, OverlaySet{}) << "no overlays are not the usual ones";
}

TEST(Links, SayHowAWorldInSpaceIsLookedAt) {
  LinkView view;
  view.pin = Cell{5, 4, 3};
  view.slices = {{Axis::z, 2}, {Axis::x, 5}};
  view.orbit = Orbit{-0.6, 1.2, 12.5, {1, 2.5, 3}};
  view.orbits = {1};
  view.cut = view.glass = true;
  const std::string text = written(voxels(), view);
  EXPECT_NE(text.find("&pin=5,4,3&slice=z2,x5&orbit=-34.377,68.755,12.5,1,2.5,3&orbits=2&solid=cut,glass&"),
            std::string::npos)
      << text;
  auto link = parse_link(text);
  ASSERT_TRUE(link.ok()) << link.error();
  EXPECT_NEAR(link->view.orbit->yaw, view.orbit->yaw, 1e-4);
  EXPECT_NEAR(link->view.orbit->pitch, view.orbit->pitch, 1e-4);
  EXPECT_EQ(link_text(link->scenario, link->view).value(), text) << "written again it is the same";
  link->view.orbit = view.orbit;
  EXPECT_EQ(link->view, view);
  LinkView follows;
  follows.follows_robot = true;
  EXPECT_EQ(parse_link(written(voxels(), follows))->view, follows);
}

TEST(Links, HoldTheMapOfAFileAndReadNone) {
  const test::TemporaryFolder folder;
  folder.with("a.map", "type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n");
  const std::string file = folder.with("a.json", R"({"replan": 1, "map": {"file": "a.map"}, "start": [0, 0],
    "goal": [2, 1], "planners": [{"id": "astar"}]})");
  const auto scenario = read_scenario(file);
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  const auto link = parse_link(written(*scenario));
  ASSERT_TRUE(link.ok()) << link.error();
  EXPECT_EQ(link->scenario.map, scenario->map);
  EXPECT_EQ(link->scenario.map_file, "");
  for (const std::string& path : {folder.file("a.map"), std::string("/dev/zero"), std::string("a.map")})
    expect_sentence(with_world(R"({"replan": 1, "map": {"file": ")" + path +
                               R"("}, "start": [0, 0], "goal": [2, 1], "planners": [{"id": "astar"}]})"),
                    "must hold its map itself");
}

TEST(Links, AreTakenAsMailAndBrowsersBringThem) {
  LinkView view = at(7);
  view.pin = Cell{1, 2};
  const std::string text = written(small_world(), view);
  std::string broken = "> <https://example.org/r.html" + text + ">\r\n";
  broken.insert(broken.size() / 2, "\r\n  ");
  std::string escaped = text, html;
  escaped.replace(escaped.find("1,2"), 3, "1%2c2");
  for (const char c : text) html += c == '&' ? "&amp;" : std::string(1, c);
  for (const std::string& each :
       {text, broken, escaped, html, text + "&utm_source=mail", "x.html" + text + "&"}) {
    EXPECT_TRUE(is_link(each)) << each;
    const auto link = parse_link(each);
    ASSERT_TRUE(link.ok()) << link.error() << "\n" << each;
    EXPECT_EQ(link->view.event, 7u);
    EXPECT_EQ(link->view.pin, (Cell{1, 2}));
    EXPECT_EQ(link->scenario, small_world());
  }
  for (const char* other :
       {"", "#", "maps/demo.json", "..#..\n..#..\n", "# v=1\n", "https://example.org/#top", "v=1&world=abc",
        "#world=abc", "https://youtube.com/watch?v=1&at=2"})
    EXPECT_FALSE(is_link(other)) << other;
}

TEST(Links, LeaveOutWhatAnotherVersionMayKnowAndSaySo) {
  const std::string text = written(small_world());
  const auto link = parse_link(text + "&weather=rain&pn=1,2&overlays=path,fog");
  ASSERT_TRUE(link.ok()) << link.error();
  ASSERT_EQ(link->notes.size(), 3u);
  EXPECT_NE(link->notes[0].find("weather"), std::string::npos);
  EXPECT_NE(link->notes[1].find("did you mean 'pin'?"), std::string::npos);
  EXPECT_NE(link->notes[2].find("fog"), std::string::npos);
  std::string flood = text;
  for (int i = 0; i < 1000; ++i) flood += "&x" + std::to_string(i) + "=1";
  EXPECT_LE(parse_link(flood)->notes.size(), 16u);
}

TEST(Links, LeaveOutPanes) {
  const auto link = parse_link(written(small_world()) + "");
  EXPECT_EQ(link->scenario.planners.size(), 2u);
  std::string one = written(small_world());
  one.replace(one.find("panes=2"), 7, "panes=1");
  const auto less = parse_link(one);
  ASSERT_TRUE(less.ok()) << less.error();
  ASSERT_EQ(less->scenario.planners.size(), 1u);
  EXPECT_EQ(less->scenario.planners[0].id, "dstar-lite");
}

TEST(Links, WrongOnesAreToldInASentence) {
  const std::string text = written(small_world()), world = text.substr(text.find("&world="));
  expect_sentence("", "'v=1' is missing");
  expect_sentence("#at=3" + world, "'v=1' is missing");
  expect_sentence("#v=2" + world, "version 2, and this Replan reads version 1: open it with a newer Replan");
  expect_sentence("#v=18446744073709551616" + world, "'v' cannot be");
  expect_sentence("#v=-1" + world, "'v' cannot be");
  expect_sentence("#v=0" + world, "'v' cannot be");
  expect_sentence("#v=1", "its world is missing");
  expect_sentence("#v=1&world=", "its world is missing");
  expect_sentence("#v=1&v=1" + world, "twice");
  expect_sentence("#v=1&pin=%2" + world, "%");
  for (const std::string& cut : {text.substr(0, text.size() - 1), text.substr(0, text.size() / 2) + "!",
                                 text.substr(0, text.size() - 9), text + "A", text + "AAAA", text + "="})
    if (cut.find("world=") != std::string::npos) expect_sentence(cut, "its world is damaged or cut off");
  const std::pair<const char*, const char*> wrong[] = {
      {"at", "-1"},          {"at", "1.5"},        {"at", "99999999999999999999"},
      {"at", "nan"},         {"log", "123"},       {"log", "0123456g"},
      {"panes", "0"},        {"panes", "3"},       {"lead", "3"},
      {"lead", "0"},         {"lockstep", "slow"}, {"theme", "pink"},
      {"pin", "8,0"},        {"pin", "1"},         {"pin", "1,2,3"},
      {"pin", "-1,0"},       {"pin", "x,y"},       {"pin", "1,99999999999"},
      {"camera", "1,2"},     {"camera", "1,2,0"},  {"camera", "1,2,nan"},
      {"camera", "1e9,2,3"}, {"camera", "inf,2,3"}};
  std::string bare = text;
  bare.replace(bare.find("&panes=2"), 8, "");
  for (const auto& [key, value] : wrong)
    expect_sentence(bare + "&" + key + "=" + value, "'" + std::string(key) + "' cannot be");
  const std::string space = written(voxels());
  for (const auto& [key, value] : {std::pair{"slice", "z4"},
                                   {"slice", "q1"},
                                   {"slice", ""},
                                   {"slice", "z1,z1,z1,z1,z1"},
                                   {"orbit", "1"},
                                   {"orbit", "1,90"},
                                   {"orbit", "1,2,0,0,0,0"},
                                   {"orbits", "5"},
                                   {"orbits", "0"},
                                   {"solid", "brick"},
                                   {"pin", "1,2"}})
    if (*value != '\0')
      expect_sentence(space + "&" + key + "=" + value, "'" + std::string(key) + "' cannot be");
}

TEST(Links, HostileWorldsAreRefusedBeforeTheyTakeMemory) {
  expect_sentence(with_world(std::string((std::size_t{1} << 25) + 1, '\0')),
                  "more than 32 MiB when it is unpacked");
  expect_sentence(with_world("[" + std::string(3'000'000, ',') + "]"),
                  "values, the most that a link may have");
  std::string deep(100'000, '[');
  EXPECT_NE(error_of(with_world(deep)), "");
  expect_sentence(with_world(R"({"replan": 1, "map": {"size": [8192, 8192], "obstacles": {}}, "start": [0, 0],
    "goal": [1, 1], "planners": [{"id": "astar"}]})"),
                  "67108864 cells, and a link may have at most 16777216");
  expect_sentence("#v=1&world=" + std::string(3'000'000, 'A'), "characters, and a link has at most");
  EXPECT_NE(error_of(with_world("")), "");
  EXPECT_NE(error_of(with_world("{}")), "");
  EXPECT_NE(error_of("#v=1&world=" + base64url("no zlib stream")), "");
}

/// A world without any order takes a bit for each cell, and letters hold six.
TEST(Links, OfALargeRandomWorldAreLongAndTooLargeOnesAreRefused) {
  Scenario scenario = small_world();
  scenario.map = GridMap(512, 512);
  Random random(11);
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 512; ++x)
      if (random.chance(0.3)) scenario.map.set({x, y}, true);
  for (const Cell end : {scenario.start, scenario.goal}) scenario.map.set(end, false);
  const std::string text = written(scenario);
  EXPECT_GT(text.size(), 40'000u);
  EXPECT_LT(text.size(), 80'000u);
  RecordProperty("characters", static_cast<int>(text.size()));
  EXPECT_EQ(parse_link(text)->scenario, scenario);
  scenario.map = GridMap(4096, 4097);
  const auto large = link_text(scenario, {});
  ASSERT_FALSE(large.ok());
  EXPECT_NE(large.error().find("save the world as a file instead"), std::string::npos) << large.error();
}

}  // namespace
}  // namespace replan::link_test
