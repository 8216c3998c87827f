// 'replan run' and 'replan render' of a link.
#include "core/link/link.hpp"

#include "core/session/session.hpp"
#include "core/trace/log_hash.hpp"
#include "tests/cli/child.hpp"

namespace replan::test::link_command_test {
namespace {

constexpr const char* kScenario = R"({"replan": 1, "map": {"rows": ["......", "..@...", "......"]},
  "start": [0, 1], "goal": [5, 1], "planners": [{"id": "dld-star-lite"}, {"id": "astar"}], "robot": {"knowledge": "map"}})";

class LinkCommand : public ::testing::Test {
 protected:
  LinkCommand() {
    Session session(*read_scenario(scenario_));
    session.settle();
    LinkView view;
    view.event = 40;
    view.pin = Cell{3, 1};
    view.tab = "cell";
    view.dark = false;
    view.overlays = parse_overlays(std::vector<std::string>{"path", "g"}).value();
    LogHash hash(40);
    hash.advance(session.run().timeline(), Deadline::never());
    view.log = hash.short_value();
    link_ = "https://example.org/r.html" + link_text(session.scenario(), view).value();
  }

  TemporaryFolder folder_;
  std::string scenario_ = folder_.with("small.json", kScenario);
  std::string link_;
};

TEST_F(LinkCommand, RunsItsWorld) {
  const Outcome outcome = run_program({"run", link_});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with("the link: 6 x 3")) << outcome.out.substr(0, 80);
  EXPECT_NE(run_program({"run", link_ + "&colour=red"}).err.find("note: the link says 'colour'"),
            std::string::npos);
}

TEST_F(LinkCommand, DrawsItsMomentAsOptionsWould) {
  const std::string by_link = folder_.file("link.png"), by_options = folder_.file("options.png"),
                    later = folder_.file("later.png");
  const Outcome drawn = run_program({"render", link_, "-o", by_link, "--size", "900x600"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(drawn.err, "");
  EXPECT_EQ(
      run_program({"render", scenario_, "-o", by_options, "--size", "900x600", "--at", "40", "--pin", "3,1",
                   "--theme", "light", "--overlay", "path,g", "--action", "show_cell", "--panes", "2"})
          .code,
      0);
  EXPECT_EQ(run_program({"render", link_, "-o", later, "--size", "900x600", "--at-end"}).code, 0);
  EXPECT_FALSE(whole_file(by_link).empty());
  EXPECT_TRUE(whole_file(by_link) == whole_file(by_options));
  EXPECT_FALSE(whole_file(by_link) == whole_file(later)) << "options come before the link";
}

TEST_F(LinkCommand, SaysThatThePlanIsAnother) {
  const std::string file = folder_.file("a.png");
  std::string other = link_;
  const std::size_t at = other.find("&log=") + 5;
  other[at] = other[at] == '0' ? '1' : '0';
  const Outcome outcome = run_program({"render", other, "-o", file, "--size", "400x300"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("the moment may be another"), std::string::npos) << outcome.err;
  other.replace(other.find("at=40"), 5, "at=999999");
  expect_complaint({"render", other, "-o", file}, {"leads to event 999999, and the run ends after"});
}

TEST_F(LinkCommand, RefusesWhatIsDamaged) {
  expect_complaint({"run", link_.substr(0, link_.size() - 5)}, {"cut off"});
  expect_complaint({"render", "#v=3&at=1", "-o", "a.png"}, {"version 3"});
  expect_complaint({"#v=3&at=1"}, {"version 3"});
}

}  // namespace
}  // namespace replan::test::link_command_test
