// A file that says that its process lives: the system takes the lock back when the process ends, however it
// ends.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/base/result.hpp"

namespace replan {

class LockFile {
 public:
  /// Makes the file if need be and locks it; nothing if another process holds it. The error is the reason why there can
  /// be no such file.
  static Result<std::optional<LockFile>> take(const std::string& path);
  /// The same for those who leave alone what they cannot lock, whatever the reason.
  static std::optional<LockFile> try_lock(const std::string& path);
  LockFile(LockFile&& other) noexcept
      : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
  LockFile& operator=(LockFile&& other) noexcept;
  ~LockFile();

  /// Removes the file, and with it the lock.
  void remove();

 private:
  LockFile(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::string path_;
  int descriptor_;
};

}  // namespace replan
