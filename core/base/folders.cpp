#include "core/base/folders.hpp"

#include <cstdlib>
#include <filesystem>

#include <sys/stat.h>

namespace replan {

std::string state_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  // A relative path is to be ignored, says the specification.
  if (state != nullptr && state[0] == '/') return std::string(state) + "/replan";
  const char* home = std::getenv("HOME");
  return home == nullptr || home[0] == '\0' ? "" : std::string(home) + "/.local/state/replan";
}

Result<void> make_folder(const std::string& path) {
  std::error_code failed;
  std::filesystem::create_directories(path, failed);
  if (failed) return Error{"cannot make the folder '" + path + "': " + failed.message()};
  return {};
}

Result<void> make_private_folder(const std::string& path) {
  std::error_code failed;
  const bool made = std::filesystem::create_directories(path, failed);
  if (failed) return Error{"cannot make the folder '" + path + "': " + failed.message()};
  if (made) ::chmod(path.c_str(), 0700);
  return {};
}

}  // namespace replan
