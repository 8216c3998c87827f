#include "ui/documents/file_watch.hpp"

#include <sys/stat.h>

namespace replan::ui {

FileStamp stamp_of(const std::string& path) {
  struct stat info {};
  if (path.empty() || ::stat(path.c_str(), &info) != 0) return {};
  return {true, std::int64_t{info.st_mtim.tv_sec} * 1'000'000'000 + info.st_mtim.tv_nsec,
          static_cast<std::uint64_t>(info.st_size), static_cast<std::uint64_t>(info.st_ino)};
}

StampedFile stamped(const std::string& path) {
  return {path, stamp_of(path)};
}

void FileWatch::watch(std::vector<StampedFile> files) {
  files_ = std::move(files);
  std::erase_if(files_, [](const StampedFile& file) { return file.path.empty(); });
}

std::optional<std::string> FileWatch::changed() const {
  for (const StampedFile& file : files_)
    if (const FileStamp now = stamp_of(file.path); now.there && now != file.stamp) return file.path;
  return std::nullopt;
}

void FileWatch::accept() {
  for (StampedFile& file : files_) file.stamp = stamp_of(file.path);
}

}  // namespace replan::ui
