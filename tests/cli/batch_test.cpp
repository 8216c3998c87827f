// The contract of 'replan batch': what is counted, exit codes, JSON.
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "tests/cli/child.hpp"
#include "tests/support/shared_data.hpp"

namespace replan::test::batch_test {
namespace {

using nlohmann::json;

// A wall with a gap; the room at the lower right is closed.
constexpr const char* kMap =
    "type octile\nheight 6\nwidth 8\nmap\n"
    "........\n"
    "...@....\n"
    "...@....\n"
    "...@.@@@\n"
    "...@.@.@\n"
    ".....@@@\n";

class BatchCommand : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string map_ = folder_.with("room.map", kMap);
};

TEST_F(BatchCommand, holdsLengthsAgainstTheFile) {
  const std::string lines =
      "version 1\n"
      "0\troom.map\t8\t6\t0\t0\t2\t0\t2\n"
      "0\troom.map\t8\t6\t0\t0\t1\t1\t1.41421\n"
      "0\troom.map\t8\t6\t3\t1\t0\t0\t9\n"
      "1\troom.map\t8\t6\t4\t0\t7\t0\t3\n";
  const Outcome good =
      run_program({"batch", folder_.with("good.scen", lines), "--planner", "astar,dld-star-lite", "--json"});
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_EQ(good.err, "") << "no progress in a pipe";
  const json document = good.json();
  EXPECT_EQ(keys(document), std::set<std::string>{"planners"});
  for (const json& planner : document["planners"]) {
    for (const char* key :
         {"problems", "found", "mismatches", "max_relative_error", "total_ms", "expansions", "skipped"})
      EXPECT_TRUE(planner[key].is_number()) << key;
    EXPECT_EQ(planner["problems"], 4);
    EXPECT_EQ(planner["skipped"], 1);
    EXPECT_EQ(planner["found"], 3);
    EXPECT_EQ(planner["mismatches"], 0);
  }
  EXPECT_EQ(document["planners"][0]["comparable"], true);
  EXPECT_EQ(document["planners"][1]["comparable"], false);
  EXPECT_LT(document["planners"][0]["max_relative_error"].get<double>(), 1e-5);
}

TEST_F(BatchCommand, mismatchIsExitCodeOneAndNamesTheLine) {
  const std::string scen = folder_.with("bad.scen",
                                        "version 1\n"
                                        "0\troom.map\t8\t6\t0\t0\t2\t0\t2\n"
                                        "0\troom.map\t8\t6\t0\t0\t1\t1\t1.5\n"
                                        "0\troom.map\t8\t6\t0\t0\t6\t4\t9\n");
  const Outcome outcome = run_program({"batch", scen, "--planner", "astar", "--json"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.json()["planners"][0]["mismatches"], 2);
  EXPECT_EQ(outcome.json()["planners"][0]["found"], 2);
  EXPECT_NE(outcome.err.find("replan: " + scen + ":3: astar found 1.41421356, listed is 1.5"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find(scen + ":4: astar found no path"), std::string::npos) << outcome.err;
}

TEST_F(BatchCommand, takesAnEvenSample) {
  std::string lines = "version 1\n";
  for (int i = 1; i <= 7; ++i)
    lines += "0\troom.map\t8\t6\t0\t0\t" + std::to_string(i) + "\t0\t" + std::to_string(i) + "\n";
  const std::string scen = folder_.with("seven.scen", lines);
  const auto problems = [&](const char* limit) {
    return run_program({"batch", scen, "--planner", "astar", "--limit", limit, "--json"})
        .json()["planners"][0]["problems"];
  };
  EXPECT_EQ(problems("3"), 3);
  EXPECT_EQ(problems("1"), 1);
  EXPECT_EQ(problems("100"), 7);
  expect_complaint({"batch", scen, "--planner", "astar", "--limit", "0"}, {"--limit cannot be '0'"});
  expect_complaint({"batch", scen, "--planner", "astar", "--limit", "ten"}, {"--limit cannot be 'ten'"});
}

/// How often a file was opened while the watch lived.
class OpenWatch {
 public:
  explicit OpenWatch(const std::string& file) : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    // Equal events that follow each other are told once: closing stands between two openings.
    EXPECT_GE(inotify_add_watch(queue_, file.c_str(), IN_OPEN | IN_CLOSE), 0);
  }
  ~OpenWatch() { close(queue_); }
  OpenWatch(const OpenWatch&) = delete;
  OpenWatch& operator=(const OpenWatch&) = delete;

  [[nodiscard]] int count() const {
    int opened = 0;
    inotify_event events[256];  // without names: the file itself is watched
    for (ssize_t got = 0; (got = read(queue_, events, sizeof events)) > 0;)
      for (std::size_t i = 0; i < static_cast<std::size_t>(got) / sizeof *events; ++i)
        opened += (events[i].mask & IN_OPEN) != 0 ? 1 : 0;
    return opened;
  }

 private:
  int queue_;
};

TEST_F(BatchCommand, loadsEachMapOnce) {
  const std::string scen = folder_.with("one.scen", "version 1\n0\troom.map\t8\t6\t0\t0\t2\t0\t2\n");
  const json experiment = {{"format", "replan experiment"},
                           {"version", 1},
                           {"worlds", {"one.scen"}},
                           {"planners", json::array({{{"id", "astar"}}})}};
  const std::string file = folder_.with("one.json", experiment.dump());
  const OpenWatch watch(map_);
  ASSERT_EQ(run_program({"batch", file}).code, 0);
  const int once = watch.count();
  EXPECT_GT(once, 0);
  ASSERT_EQ(run_program({"batch", scen, "--planner", "astar"}).code, 0);
  EXPECT_EQ(watch.count(), once) << "as often as for an experiment that has its planners written out";
}

TEST_F(BatchCommand, refusesAnotherMap) {
  const std::string scen = folder_.with("other.scen", "version 1\n0\tother.map\t8\t6\t0\t0\t2\t0\t2\n");
  expect_complaint({"batch", scen, "--planner", "astar"}, {"'other.map'", "--map"});
  EXPECT_EQ(run_program({"batch", scen, "--map", map_, "--planner", "astar", "--json"}).code, 0);
  const std::string small = folder_.with("small.map", "type octile\nheight 1\nwidth 2\nmap\n..\n");
  expect_complaint({"batch", scen, "--map", small, "--planner", "astar"}, {scen + ":2: ", "8 x 6", "2 x 1"});
}

TEST(BatchCommandOnSharedData, publishedLengthsHold) {
  REPLAN_NEED_SHARED_DATA();
  const std::string data = (shared_data() / "movingai").string();
  for (const char* file : {"/dao/arena.map.scen", "/da2/ht_store.map.scen", "/mapf/empty-8-8.map.scen"}) {
    const Outcome outcome = run_program({"batch", data + file, "--planner", "astar,dstar-lite", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const json document = outcome.json();
    for (const json& planner : document["planners"]) {
      EXPECT_EQ(planner["mismatches"], 0) << file;
      EXPECT_EQ(planner["found"], planner["problems"]) << file;
    }
  }
}

}  // namespace
}  // namespace replan::test::batch_test
