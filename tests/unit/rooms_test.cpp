// The rooms of core lie one above the other, in the order of the table in CONTRIBUTING.md; and what is a list is asked,
// not told apart.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace replan::rooms_test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = REPLAN_SOURCE_DIR;

/// What stands between `before` and `after` in a line that begins with `before`; empty in any other.
std::string between(const std::string& line, const std::string& before, char after) {
  if (!line.starts_with(before)) return {};
  const std::size_t end = line.find(after, before.size());
  return end == std::string::npos ? "" : line.substr(before.size(), end - before.size());
}

/// The rooms by their folder's name, each with its place from below.
std::map<std::string, std::size_t> rooms() {
  std::map<std::string, std::size_t> places;
  std::ifstream page(kRoot / "CONTRIBUTING.md");
  for (std::string line; std::getline(page, line);)
    if (const std::string room = between(line, "| `core/", '`'); !room.empty())
      places.emplace(room, places.size());
  return places;
}

TEST(Rooms, AreAllInTheTable) {
  const auto places = rooms();
  for (const auto& folder : fs::directory_iterator(kRoot / "core"))
    if (folder.is_directory()) {
      EXPECT_TRUE(places.contains(folder.path().filename())) << folder.path();
    }
}

TEST(Rooms, IncludeOnlyWhatLiesBelowThem) {
  const auto places = rooms();
  std::size_t includes = 0;
  for (const auto& file : fs::recursive_directory_iterator(kRoot / "core")) {
    if (!file.is_regular_file()) continue;
    const std::string room = *fs::relative(file.path(), kRoot / "core").begin();
    std::ifstream text(file.path());
    for (std::string line; std::getline(text, line);) {
      const std::string included = between(line, "#include \"", '"');
      if (included.empty() || included.ends_with(".def")) continue;  // a registry knows what is above it
      const std::string other = between(included, "core/", '/');
      ASSERT_TRUE(places.contains(other)) << file.path() << " includes " << included;
      EXPECT_LE(places.at(other), places.at(room)) << file.path() << " includes " << included;
      ++includes;
    }
  }
  EXPECT_GT(includes, 300u);
}

/// The rooms of replan_plan, for programs that have no more than a compiler.
TEST(Rooms, OfPlanningNeedNoOtherLibrary) {
  std::size_t includes = 0;
  for (const char* room : {"base", "lattice", "space", "field", "trace", "plan", "planners", "stages"})
    for (const auto& file : fs::directory_iterator(kRoot / "core" / room)) {
      std::ifstream text(file.path());
      for (std::string line; std::getline(text, line);) {
        const std::string included = between(line, "#include <", '>');
        const bool is_posix = included.starts_with("sys/") || included == "fcntl.h" ||
                              included == "locale.h" || included == "unistd.h";
        EXPECT_TRUE(is_posix || included.find_first_of("./") == std::string::npos)
            << file.path() << " includes " << included;
        includes += included.empty() ? 0 : 1;
      }
    }
  EXPECT_GT(includes, 100u);
}

/// A build without threads has other bodies for two headers, and for nothing else.
TEST(Rooms, KnowThreadsByTwoHeadersAlone) {
  const std::vector<std::string> words = {
      "std::jthread", "std::thread", "std::this_thread", "std::stop_",   "condition_variable",
      "std::async",   "std::future", "<thread>",         "<stop_token>", "REPLAN_THREADS"};
  for (const char* part : {"core", "ui"})
    for (const auto& file : fs::recursive_directory_iterator(kRoot / part)) {
      if (!file.is_regular_file() || file.path().filename() == "stop.hpp" ||
          file.path().filename() == "threads.hpp" || file.path().filename() == "CMakeLists.txt")
        continue;
      std::ifstream text(file.path());
      for (std::string line; std::getline(text, line);)
        for (const std::string& word : words)
          EXPECT_EQ(line.find(word), std::string::npos)
              << file.path() << " says " << word << ": take core/base/"
              << "stop.hpp or threads.hpp";
    }
}

/// What the lines of a list name: `keyword(name)`, and more behind it.
std::vector<std::string> listed(const char* list, const std::vector<std::string>& keywords) {
  std::vector<std::string> names;
  std::ifstream text(kRoot / list);
  for (std::string line; std::getline(text, line);)
    for (const std::string& keyword : keywords)
      if (line.starts_with(keyword + "(")) {
        const std::size_t begin = keyword.size() + 1;
        names.push_back(line.substr(begin, line.find_first_of(",)", begin) - begin));
      }
  EXPECT_GT(names.size(), 5u) << list;
  return names;
}

/// How a line looks that knows one thing of a list: it has these words. Only a file in `room` may have such a line.
struct Knowing {
  std::vector<std::string> words;
  std::string room;
};

std::vector<Knowing> ways_of_knowing_one() {
  // A switch over actions, however it is written.
  std::vector<Knowing> ways = {
      {{"case ActionId::"}, ""}, {{"== ActionId::"}, ""}, {{"!= ActionId::"}, ""}, {{"case Overlay::"}, ""}};
  for (const std::string& id : listed("core/scene/overlays.def", {"REPLAN_FIELD", "REPLAN_MARK"})) {
    ways.push_back({{"Overlay::" + id}, "core/scene"});
    ways.push_back({{"ActionId::overlay_" + id}, ""});
  }
  const auto by_name = [&](const std::string& id, const char* function, const std::string& room) {
    for (const char* question : {function, "id == ", "id() == ", "tab == ", "id != ", "id() != ", "tab != "})
      ways.push_back({{question, '"' + id + '"'}, room});
  };
  for (const std::string& id : listed("ui/tools/tools.def", {"REPLAN_TOOL"})) {
    ways.push_back({{"ActionId::tool_" + id}, ""});
    by_name(id, "choose_tool(", "ui/tools");
  }
  for (const std::string& id : listed("ui/tabs/tabs.def", {"REPLAN_TAB"}))
    by_name(id, "show_tab(", "ui/tabs");
  return ways;
}

/// Whether the line has the word, and the word does not go on behind it.
bool has_word(const std::string& line, const std::string& word) {
  const auto goes_on = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (!goes_on(word.back()) || end == line.size() || !goes_on(line[end])) return true;
  }
  return false;
}

/// The lines of a file that must not know what they know.
std::vector<std::string> lines_that_know(const fs::path& file, const std::string& path,
                                         const std::vector<Knowing>& ways) {
  std::ifstream stream(file);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  std::vector<std::string> found;
  for (const Knowing& way : ways) {
    const bool may = !way.room.empty() && path.starts_with(way.room + "/");
    if (may || text.find(way.words.back()) == std::string::npos) continue;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (std::all_of(way.words.begin(), way.words.end(),
                      [&](const std::string& word) { return has_word(line, word); }))
        found.push_back(line);
  }
  return found;
}

/// Tools, tabs, overlays and actions are lists: who asks one of them what it is, and not which one it is, need not be
/// changed for another one. (An action may be done by its name.)
TEST(Rooms, NobodyTellsToolsTabsOverlaysOrActionsApart) {
  const std::vector<Knowing> ways = ways_of_knowing_one();
  std::size_t files = 0;
  for (const char* folder : {"app", "core", "ui"})
    for (const auto& file : fs::recursive_directory_iterator(kRoot / folder)) {
      if (file.path().extension() != ".cpp" && file.path().extension() != ".hpp") continue;
      ++files;
      const std::string path = fs::relative(file.path(), kRoot).string();
      for (const std::string& line : lines_that_know(file.path(), path, ways))
        ADD_FAILURE() << path << " knows one thing of a list:\n" << line;
    }
  EXPECT_GT(files, 250u);
}

}  // namespace
}  // namespace replan::rooms_test
