// Whether the files behind the open document have been changed by somebody else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace replan::ui {

/// What tells one state of a file from another without reading it.
struct FileStamp {
  bool there = false;
  std::int64_t modified = 0;  ///< nanoseconds since 1970
  std::uint64_t size = 0;
  std::uint64_t inode = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
FileStamp stamp_of(const std::string& path);

/// A file as it was when it was read.
struct StampedFile {
  std::string path;
  FileStamp stamp;
};
StampedFile stamped(const std::string& path);

class FileWatch {
 public:
  /// From now on these are the document's files. Empty paths are passed over.
  void watch(std::vector<StampedFile> files);
  /// The first file that is not as it was, or nothing. A file that has vanished is no change: nothing could
  /// be read from it.
  [[nodiscard]] std::optional<std::string> changed() const;
  /// Takes the files as they are now: what has changed was seen, and is not wanted.
  void accept();

 private:
  std::vector<StampedFile> files_;
};

}  // namespace replan::ui
