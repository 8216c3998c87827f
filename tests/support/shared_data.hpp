// The published benchmark data that some tests read. It is not part of the project: where it is absent, they
// skip.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace replan::test {

/// The folder of the shared data: REPLAN_SHARED_DATA, or beside the source tree; empty if it is not there.
inline std::filesystem::path shared_data() {
  const char* given = std::getenv("REPLAN_SHARED_DATA");
  std::filesystem::path folder =
      given != nullptr ? std::filesystem::path(given)
                       : std::filesystem::path(REPLAN_SOURCE_DIR).parent_path() / "shared" / "data";
  std::error_code failed;
  return std::filesystem::is_directory(folder, failed) ? folder : std::filesystem::path();
}

/// All files below a folder whose names end like that, sorted.
inline std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                                      const std::string& ending) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().string().ends_with(ending)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace replan::test

/// Skips the running test with a sentence if the shared data is absent.
#define REPLAN_NEED_SHARED_DATA()                                                                  \
  if (replan::test::shared_data().empty())                                                         \
  GTEST_SKIP() << "The benchmark data is absent: set REPLAN_SHARED_DATA to the folder that holds " \
                  "'movingai/'."
