#include "core/world/library.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/base/file.hpp"
#include "core/plan/pages.hpp"
#include "core/world/map_file.hpp"

namespace replan {

namespace fs = std::filesystem;

namespace {

/// Not a world, though maps end like it.
constexpr const char* kOrder = "order.txt";

/// What the folder's order.txt says: which files come first, and which are none to be shown. Nothing if there is no such
/// file.
struct Order {
  std::vector<std::string> first, hidden;
};

Order order_of(const std::string& folder) {
  Order order;
  std::ifstream list(fs::path(folder) / kOrder);
  for (std::string line; std::getline(list, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '-')
      order.hidden.push_back(line.substr(1));
    else
      order.first.push_back(line);
  }
  return order;
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
  const Order order = order_of(folder);
  const auto found = [&](const std::vector<std::string>& names, const std::string& path) {
    const std::string name = fs::path(path).lexically_relative(folder).string();
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  std::erase_if(
      files, [&](const std::string& path) { return found(order.hidden, path) < std::ssize(order.hidden); });
  const auto place = [&](const std::string& path) { return std::pair(found(order.first, path), path); };
  std::sort(files.begin(), files.end(),
            [&](const std::string& a, const std::string& b) { return place(a) < place(b); });
  return files;
}

}  // namespace replan
