// The rooms of core lie one above the other, in the order of the table in CONTRIBUTING.md.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

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
  for (const char* room : {"base", "lattice", "field", "trace", "plan", "planners", "stages"})
    for (const auto& file : fs::directory_iterator(kRoot / "core" / room)) {
      std::ifstream text(file.path());
      for (std::string line; std::getline(text, line);) {
        const std::string included = between(line, "#include <", '>');
        const bool is_posix = included.starts_with("sys/") || included == "fcntl.h" || included == "unistd.h";
        EXPECT_TRUE(is_posix || included.find_first_of("./") == std::string::npos)
            << file.path() << " includes " << included;
        includes += included.empty() ? 0 : 1;
      }
    }
  EXPECT_GT(includes, 100u);
}

}  // namespace
}  // namespace replan::rooms_test
