// Every file of the fuzzers' corpus through its target: what was once found stays mended.
#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/support/shared_data.hpp"

namespace replan::fuzz_corpus_test {
namespace {

const std::filesystem::path kCorpus = std::filesystem::path(REPLAN_SOURCE_DIR) / "tests" / "fuzz" / "corpus";

TEST(FuzzCorpus, HasAFolderForEachTargetAndNoOthers) {
  std::size_t folders = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus))
    folders += entry.is_directory() ? 1 : 0;
  EXPECT_EQ(folders, fuzz::targets().size());
  EXPECT_GE(folders, 12u);
}

TEST(FuzzCorpus, EveryTargetKeepsItsLaws) {
  for (const fuzz::Target& target : fuzz::targets()) {
    const auto files = test::files_below(kCorpus / target.name, "");
    EXPECT_GE(files.size(), 3u) << target.name;
    for (const auto& file : files) {
      const auto bytes = read_file(file.string());
      ASSERT_TRUE(bytes.ok()) << bytes.error();
      EXPECT_NO_THROW(target.run(*bytes)) << file;
      // Torn and disturbed ones too: a sweep that is the same every time.
      for (std::size_t i = 0; i < std::min<std::size_t>(bytes->size(), 200); ++i) {
        std::string torn = *bytes;
        torn[i] = static_cast<char>(torn[i] ^ (1 << i % 8));
        EXPECT_NO_THROW(target.run(torn)) << file << " with byte " << i << " changed";
        EXPECT_NO_THROW(target.run(std::string_view(*bytes).substr(0, i))) << file << " cut at " << i;
      }
    }
  }
}

}  // namespace
}  // namespace replan::fuzz_corpus_test
