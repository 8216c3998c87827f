#include "core/world/library.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/base/file.hpp"
#include "core/plan/pages.hpp"
#include "core/world/map_file.hpp"

namespace replan {

namespace fs = std::filesystem;

namespace {

/// Not a world, though maps end like it.
constexpr const char* kOrder = "order.txt";

/// The lines of the folder's order.txt, without comments; none if it has no such file.
std::vector<std::string> named_order(const std::string& folder) {
  std::vector<std::string> names;
  std::ifstream list(fs::path(folder) / kOrder);
  for (std::string line; std::getline(list, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (!line.empty() && line.front() != '#') names.push_back(line);
  }
  return names;
}

}  // namespace

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
    if (world && entry->path().filename() != kOrder && entry->is_regular_file(failed)) files.push_back(path);
  }
  const std::vector<std::string> first = named_order(folder);
  const auto place = [&](const std::string& path) {
    const std::string name = fs::path(path).lexically_relative(folder).string();
    return std::pair(std::find(first.begin(), first.end(), name) - first.begin(), path);
  };
  std::sort(files.begin(), files.end(),
            [&](const std::string& a, const std::string& b) { return place(a) < place(b); });
  return files;
}

}  // namespace replan
