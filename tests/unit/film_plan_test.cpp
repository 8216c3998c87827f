// Which moments a film shows.
#include "core/session/film_plan.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/session/session.hpp"
#include "core/session/stepping.hpp"

namespace replan::film_plan_test {
namespace {

using Kind = FilmSpeed::Kind;

/// A finished run of the demo: a plan, moves, a surprise, replans, the arrival.
class Film : public testing::Test {
 protected:
  Film() : session_(demo()) {
    for (const auto& run : session_.runs()) run->finish(Target::end());
    session_.update(0);
  }

  static Scenario demo() {
    auto scenario = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/demo.json");
    EXPECT_TRUE(scenario.ok());
    return scenario.ok() ? *scenario : Scenario{};
  }
  [[nodiscard]] const replan::Run& run() const { return session_.run(); }
  [[nodiscard]] std::size_t size() const { return run().timeline().size(); }
  [[nodiscard]] std::size_t count(EventKind kind) const {
    return static_cast<std::size_t>(std::count_if(run().milestones().begin(), run().milestones().end(),
                                                  [&](const Milestone& m) { return m.kind == kind; }));
  }
  [[nodiscard]] std::vector<FilmFrame> plan(const FilmOptions& options) const {
    auto frames = plan_film(run(), options);
    EXPECT_TRUE(frames.ok()) << (frames.ok() ? "" : frames.error());
    return frames.ok() ? *frames : std::vector<FilmFrame>{};
  }
  [[nodiscard]] std::size_t moment(std::string_view text) const {
    const auto position = moment_position(run(), text);
    EXPECT_TRUE(position.ok()) << text;
    return position.ok() ? *position : 0;
  }
  static std::size_t times(const std::vector<FilmFrame>& frames, std::size_t position) {
    return static_cast<std::size_t>(std::count_if(
        frames.begin(), frames.end(), [&](const FilmFrame& frame) { return frame.position == position; }));
  }
  static bool in_order(const std::vector<FilmFrame>& frames) {
    return std::is_sorted(frames.begin(), frames.end(),
                          [](const FilmFrame& a, const FilmFrame& b) { return a.position < b.position; });
  }

  Session session_;
};

TEST_F(Film, StandsStillBeforeEachRepairBegins) {
  for (const FilmSpeed speed : {FilmSpeed{}, FilmSpeed{Kind::expansion, 0}, FilmSpeed{Kind::events, 400}}) {
    FilmOptions options;
    options.speed = speed;
    const auto frames = plan(options);
    EXPECT_TRUE(in_order(frames));
    std::size_t repairs = 0;
    for (std::size_t p = 0; p < size(); ++p) {
      if (!is_before_repair(run(), p)) continue;
      ++repairs;
      EXPECT_GE(times(frames, p), 10u) << "a third of a second, at position " << p;
    }
    EXPECT_GT(repairs, 0u);
  }
}

TEST_F(Film, ShowsPlanDriveAndArrival) {
  const auto frames = plan({});
  EXPECT_TRUE(in_order(frames));
  EXPECT_EQ(frames.front().position, 0u);
  EXPECT_EQ(frames.back().position, size());
  EXPECT_GE(times(frames, size()), 30u) << "a second on the end";
  EXPECT_GT(frames.size(), count(EventKind::move) + 60);
  EXPECT_LT(frames.size(), 600u);
  EXPECT_EQ(frames, plan({})) << "a pure function";
}

TEST_F(Film, HoldsPlansForTheTimeAskedFor) {
  FilmOptions options;
  options.fps = 20;
  options.hold = 1.5;
  options.speed = {Kind::move, 0};
  EXPECT_EQ(times(plan(options), moment("plan")), 30u);
  EXPECT_EQ(times(plan(options), moment("replan:1")), 30u);
  options.hold = 0;
  EXPECT_EQ(times(plan(options), moment("replan:1")), 1u);
}

TEST_F(Film, OneMovePerFramePassesOverSearches) {
  FilmOptions options;
  options.speed = {Kind::move, 0};
  options.hold = 0;
  const auto frames = plan(options);
  for (std::size_t n = 1; n <= count(EventKind::move); ++n)
    EXPECT_GE(times(frames, moment("move:" + std::to_string(n))), 1u) << n;
  options.to = "plan";
  EXPECT_EQ(plan(options).size(), 1u + 1u + 30u) << "the beginning, the plan, and it for a second more";
}

TEST_F(Film, OneExpansionPerFrameLeavesNoneOut) {
  FilmOptions options;
  options.speed = {Kind::expansion, 0};
  options.to = "plan";
  const auto frames = plan(options);
  std::size_t expansions = 0;
  for (std::size_t p = 0; p < moment("plan"); ++p)
    if (run().timeline().event(p).kind == EventKind::pop) {
      ++expansions;
      EXPECT_EQ(times(frames, p), 1u) << p;
    }
  EXPECT_GT(expansions, 100u);
}

TEST_F(Film, SoManyEventsPerFrame) {
  FilmOptions options;
  options.speed = {Kind::events, 500};
  options.hold = 0;
  const auto frames = plan(options);
  EXPECT_TRUE(in_order(frames));
  for (std::size_t p = 0; p < size(); p += 500) EXPECT_GE(times(frames, p), 1u) << p;
  EXPECT_LT(frames.size(), size() / 500 + 120);
  EXPECT_EQ(times(frames, moment("replan:1")), 1u) << "a plan is shown, wherever it falls";
}

TEST_F(Film, SoManyMovesPerSecondWithTheWayBetween) {
  FilmOptions options;
  options.speed = {Kind::moves_per_second, 4};
  options.hold = 0;
  options.from = "move:1";
  const auto frames = plan(options);
  std::vector<double> ways;
  for (const FilmFrame& frame : frames)
    if (frame.position == moment("move:4")) ways.push_back(frame.travel);
  ASSERT_TRUE(ways.size() == 7 || ways.size() == 8) << ways.size();
  EXPECT_TRUE(std::is_sorted(ways.begin(), ways.end()));
  EXPECT_GT(ways.front(), 0);
  EXPECT_EQ(ways.back(), 1);
}

TEST_F(Film, FromAndToBoundIt) {
  FilmOptions options;
  for (const Kind kind : {Kind::automatic, Kind::events, Kind::expansion, Kind::move}) {
    options.speed = {kind, 7};
    for (const auto& [from, to] :
         {std::pair{"100", "2000"}, {"plan", "replan:1"}, {"move:2", "end"}, {"start", "50"}, {"9", "9"}}) {
      options.from = from;
      options.to = to;
      const auto frames = plan(options);
      ASSERT_FALSE(frames.empty());
      EXPECT_TRUE(in_order(frames)) << from << " " << to;
      EXPECT_EQ(frames.front().position, moment(from));
      EXPECT_EQ(frames.back().position, moment(to));
    }
  }
}

TEST_F(Film, ASearchCutShortIsShownSoFar) {
  FilmOptions options;
  options.to = std::to_string(moment("plan") / 2);
  EXPECT_GT(plan(options).size(), 60u);
}

TEST_F(Film, MistakesAreNamed) {
  const auto error = [&](const FilmOptions& options) {
    const auto frames = plan_film(run(), options);
    return frames ? std::string() : frames.error();
  };
  const auto says = [&](const FilmOptions& options, const char* phrase) {
    return error(options).find(phrase) != std::string::npos;
  };
  EXPECT_TRUE(says({.fps = 0}, "1 to 60"));
  EXPECT_TRUE(says({.fps = 61}, "61"));
  EXPECT_TRUE(says({.hold = -1}, "0 to 60 seconds"));
  EXPECT_TRUE(says({.from = "end", .to = "start"}, "end before"));
  EXPECT_TRUE(says({.from = "99999999"}, "beyond the run's end"));
  EXPECT_TRUE(says({.from = "lunch"}, "no moment 'lunch'"));
  EXPECT_TRUE(says({.from = "-1"}, "no moment '-1'"));
  EXPECT_TRUE(says({.to = "replan:1000"}, "only"));
  EXPECT_TRUE(says({.to = "move:0"}, "count from 1"));
  EXPECT_TRUE(says({.to = "move:x"}, "'x'"));
  EXPECT_TRUE(says({.to = "move:"}, "'' is no number"));
}

TEST(FilmLength, HasABound) {
  Scenario corridor;
  corridor.map = GridMap(200, 2);
  corridor.start = {0, 0};
  corridor.goal = {199, 0};
  corridor.planners = {{.id = "dstar-lite", .settings = {}}};
  Session session(corridor);
  session.runs().front()->finish(Target::end());
  session.update(0);
  FilmOptions options;
  options.fps = kFastestFilm;
  options.speed = {Kind::moves_per_second, 1};
  EXPECT_TRUE(plan_film(session.run(), options).ok());
  options.speed.number = 0.1;  // 600 frames for each of 199 moves
  const auto frames = plan_film(session.run(), options);
  ASSERT_FALSE(frames.ok());
  EXPECT_NE(frames.error().find("more than 100000 frames"), std::string::npos) << frames.error();
}

TEST(FilmSpeed, IsRead) {
  EXPECT_EQ(*parse_film_speed("auto"), (FilmSpeed{Kind::automatic, 0}));
  EXPECT_EQ(*parse_film_speed("expansion"), (FilmSpeed{Kind::expansion, 0}));
  EXPECT_EQ(*parse_film_speed("move"), (FilmSpeed{Kind::move, 0}));
  EXPECT_EQ(*parse_film_speed("50"), (FilmSpeed{Kind::events, 50}));
  EXPECT_EQ(*parse_film_speed("2.5/s"), (FilmSpeed{Kind::moves_per_second, 2.5}));
  for (const char* wrong :
       {"", "0", "-3", "fast", "2x", "/s", "0/s", "nan/s", "1e9/s", "1.5", "99999999999"}) {
    const auto speed = parse_film_speed(wrong);
    ASSERT_FALSE(speed.ok()) << wrong;
    EXPECT_NE(speed.error().find("'" + std::string(wrong) + "'"), std::string::npos);
  }
}

}  // namespace
}  // namespace replan::film_plan_test
