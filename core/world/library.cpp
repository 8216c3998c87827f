#include "core/world/library.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/plan/pages.hpp"
#include "core/world/map_file.hpp"

namespace replan {

namespace fs = std::filesystem;

std::string library_folder() {
  if (const char* wanted = std::getenv("REPLAN_MAPS"); wanted != nullptr && wanted[0] != '\0') return wanted;
  std::error_code failed;
  return fs::weakly_canonical(fs::path(assets_folder()) / ".." / "maps", failed).string();
}

std::vector<std::string> library_files(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code failed;
  for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const std::string path = entry->path().string();
    const bool world = file_extension(path) == ".json" || find_map_format(path) != nullptr;
    if (world && entry->is_regular_file(failed)) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace replan
