// Help, manual page and completion: they name the same commands, options, planners and settings.
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "core/world/choices.hpp"
#include "core/world/map_file.hpp"
#include "tests/cli/child.hpp"

namespace replan::test::help_test {
namespace {

const std::vector<std::string> kCommands = {"run",   "batch",  "merge",   "compare", "anytime", "barn",
                                            "study", "render", "convert", "show",    "list"};

/// The options of a help text: the words that begin with "-" in its first column.
std::set<std::string> options_in(const std::string& help) {
  std::set<std::string> options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  -")) continue;
    const std::string names = line.substr(2, line.find(' ', 2) - 2);
    std::istringstream parts(names);
    for (std::string name; std::getline(parts, name, ',');) options.insert(name);
  }
  return options;
}

/// The manual page as plain words: the escapes of troff taken out.
std::string manual() {
  std::string text = whole_file(std::string(REPLAN_SOURCE_DIR) + "/assets/man/replan.1");
  text = std::regex_replace(text, std::regex(R"(\\f[BIRP])"), "");
  text.erase(std::remove(text.begin(), text.end(), '\\'), text.end());
  return text;
}

bool names(const std::string& text, const std::string& word) {
  const std::string escaped = std::regex_replace(word, std::regex(R"([.\-])"), R"(\$&)");
  return std::regex_search(text, std::regex("(^|[^a-zA-Z0-9_-])" + escaped + "($|[^a-zA-Z0-9_-])"));
}

TEST(Help, isThereForEachCommand) {
  const Outcome all = run_program({"--help"});
  EXPECT_EQ(all.code, 0);
  for (const std::string& command : kCommands) {
    EXPECT_TRUE(names(all.out, command)) << command;
    const Outcome one = run_program({command, "--help"});
    EXPECT_EQ(one.code, 0);
    EXPECT_EQ(one.err, "");
    EXPECT_NE(one.out.find("Examples:\n  replan " + command + " "), std::string::npos) << command;
  }
}

TEST(Help, namesEverySettingOfEveryPlanner) {
  for (const char* command : {"run", "batch", "render"}) {
    const std::string help = run_program({command, "--help"}).out;
    for (const PlannerInfo& info : choices()) {
      EXPECT_TRUE(names(help, std::string(info.id)) || info.parameters.size() == lattice_parameters().size())
          << info.id;
      for (const Parameter& parameter : info.parameters)
        EXPECT_TRUE(names(help, std::string(parameter.key))) << info.id << " " << parameter.key;
    }
  }
}

TEST(Help, namesTheMapsThatACommandTakes) {
  const std::string convert = run_program({"convert", "--help"}).out;
  for (const char* command : {"run", "render", "show"}) {
    const std::string help = run_program({command, "--help"}).out;
    for (const MapFormat& format : map_formats()) {
      const std::string extension = std::string(format.extension);
      EXPECT_NE(help.find(extension), std::string::npos) << command << " " << extension;
      EXPECT_NE(convert.find(extension), std::string::npos) << extension;
    }
  }
}

TEST(Help, versionIsTold) {
  const Outcome outcome = run_program({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(std::regex_match(outcome.out, std::regex(R"(replan \d+\.\d+\.\d+\n)"))) << outcome.out;
}

TEST(Manual, namesEveryCommandAndOption) {
  const std::string page = manual();
  ASSERT_FALSE(page.empty());
  std::set<std::string> options = options_in(run_program({"--help"}).out);
  for (const std::string& command : kCommands) {
    EXPECT_TRUE(names(page, "replan " + command)) << command;
    options.merge(options_in(run_program({command, "--help"}).out));
  }
  EXPECT_GE(options.size(), 18u);
  for (const std::string& option : options) EXPECT_TRUE(names(page, option)) << option;
}

TEST(Manual, namesNothingThatIsNotThere) {
  std::string helps = run_program({"--help"}).out;
  for (const std::string& command : kCommands) helps += run_program({command, "--help"}).out;
  const std::string page = manual();
  const std::regex option("--[a-z][a-z-]*");
  for (auto found = std::sregex_iterator(page.begin(), page.end(), option); found != std::sregex_iterator();
       ++found)
    EXPECT_TRUE(names(helps, found->str())) << found->str();
}

/// Planners and their settings come and go; the page says who lists them.
TEST(Manual, leadsToPlannersAndTheirSettings) {
  const std::string page = manual();
  for (const char* command :
       {"replan list planners", "replan list stages", "replan list robots", "replan run"})
    EXPECT_NE(page.find(command), std::string::npos) << command;
}

/// What bash would offer for a command line, one per line.
std::string completions(const std::string& words) {
  const TemporaryFolder folder;
  const std::string script =
      "PATH=$(dirname '" REPLAN_PROGRAM "'):$PATH; source '" REPLAN_SOURCE_DIR
      "/assets/completion/replan.bash'; COMP_WORDS=(" +
      words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _replan; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const std::string command =
      "bash --norc '" + folder.with("ask.bash", script) + "' > '" + folder.file("out") + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << whole_file(folder.file("ask.bash"));
  return "\n" + whole_file(folder.file("out"));
}

TEST(Completion, offersCommandsAndAllTheirOptions) {
  for (const std::string& command : kCommands) {
    EXPECT_NE(completions("replan ''").find("\n" + command + "\n"), std::string::npos) << command;
    const std::string offered = completions("replan " + command + " -");
    for (const std::string& option : options_in(run_program({command, "--help"}).out))
      EXPECT_NE(offered.find("\n" + option + "\n"), std::string::npos) << command << " " << option;
  }
}

TEST(Completion, offersPlannersOverlaysAndSettings) {
  EXPECT_NE(completions("replan run --planner as").find("\nastar\n"), std::string::npos);
  EXPECT_NE(completions("replan run --planner dijkstra,dld").find("\ndijkstra,dld-star-lite\n"),
            std::string::npos);
  EXPECT_NE(completions("replan render --overlay path,tr").find("\npath,trail\n"), std::string::npos);
  EXPECT_NE(completions("replan batch --set heu").find("\nheuristic=\n"), std::string::npos);
  EXPECT_NE(completions("replan list ov").find("\noverlays\n"), std::string::npos);
  EXPECT_NE(completions("replan render --theme d").find("\ndark\n"), std::string::npos);
}

}  // namespace
}  // namespace replan::test::help_test
