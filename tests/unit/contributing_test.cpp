// What CONTRIBUTING.md shows as a program is one.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace replan::contributing_test {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(std::filesystem::path(REPLAN_SOURCE_DIR) / file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The first block of that language in a Markdown page.
std::string first_block(const std::string& page, const std::string& language) {
  const std::string fence = "\n```" + language + "\n";
  const std::size_t begin = page.find(fence);
  if (begin == std::string::npos) return "";
  const std::size_t first = begin + fence.size();
  return page.substr(first, page.find("```", first) - first);
}

/// Built by the tests and, outside the project, by `./test --all`.
TEST(Contributing, ShowsTheExampleAsItIsCompiled) {
  const std::string example = text_of("tests/embed/main.cpp");
  ASSERT_FALSE(example.empty());
  EXPECT_EQ(first_block(text_of("CONTRIBUTING.md"), "cpp"), example);
  EXPECT_LE(std::count(example.begin(), example.end(), '\n'), 30);
}

}  // namespace
}  // namespace replan::contributing_test
