// The files that were opened or saved last, from one start to the next.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace replan::ui {

class RecentFiles {
 public:
  static constexpr std::size_t kMost = 10;

  /// `file` is where they are kept (JSON); empty: nowhere. An unreadable one is as good as none.
  explicit RecentFiles(std::string file = {});

  /// Absolute paths, the latest first.
  [[nodiscard]] std::span<const std::string> paths() const { return paths_; }
  /// The folders that they lie in, each once, the latest first.
  [[nodiscard]] std::vector<std::string> folders() const;

  /// Puts a file first. What other windows have added meanwhile is kept.
  Result<void> add(const std::string& path);
  Result<void> drop(const std::string& path);
  Result<void> clear();

 private:
  void read();
  Result<void> write();

  std::string file_;
  std::vector<std::string> paths_;
};

}  // namespace replan::ui
