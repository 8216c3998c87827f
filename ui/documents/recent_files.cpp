#include "ui/documents/recent_files.hpp"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/base/file.hpp"
#include "core/base/folders.hpp"

namespace replan::ui {

using Json = nlohmann::json;

RecentFiles::RecentFiles(std::string file) : file_(std::move(file)) {
  read();
}

void RecentFiles::read() {
  if (file_.empty()) return;
  const Result<std::string> text = read_file(file_, 1 << 20);
  if (!text) return;
  const Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) return;
  paths_.clear();
  for (const Json& path : json["files"])
    if (path.is_string() && paths_.size() < kMost) paths_.push_back(path.get<std::string>());
}

Result<void> RecentFiles::write() {
  if (file_.empty()) return {};
  if (const Result<void> made = make_private_folder(file_folder(file_)); !made) return made;
  const Json json = {{"files", paths_}};
  return write_file_atomically(file_, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::vector<std::string> RecentFiles::folders() const {
  std::vector<std::string> folders;
  for (const std::string& path : paths_)
    if (std::string folder = file_folder(path);
        std::find(folders.begin(), folders.end(), folder) == folders.end())
      folders.push_back(std::move(folder));
  return folders;
}

Result<void> RecentFiles::add(const std::string& path) {
  std::error_code failed;
  const std::string absolute = std::filesystem::absolute(path, failed).lexically_normal().string();
  if (failed) return {};
  read();
  std::erase(paths_, absolute);
  paths_.insert(paths_.begin(), absolute);
  if (paths_.size() > kMost) paths_.resize(kMost);
  return write();
}

Result<void> RecentFiles::drop(const std::string& path) {
  read();
  std::erase(paths_, path);
  return write();
}

Result<void> RecentFiles::clear() {
  paths_.clear();
  return write();
}

}  // namespace replan::ui
