#include "core/base/pending_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/file.hpp"

namespace replan {
namespace {

Error cannot_write(const std::string& path, int code) {
  return {"cannot write '" + path + "': " + std::generic_category().message(code)};
}

/// Where a symbolic link ends, or the path itself.
std::string resolved(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_symlink(path, failed)) return path;
  const std::filesystem::path end = std::filesystem::weakly_canonical(path, failed);
  return failed ? path : end.string();
}

/// Whether the error says that this file system has no unnamed files.
bool has_no_unnamed_files(int code) {
  return code == EOPNOTSUPP || code == EISDIR || code == EINVAL;
}

/// Flushes the folder's entry, so that the new name survives a power cut. Not every file system can; none has
/// to.
void flush_folder(const std::string& target) {
  const int folder = ::open(file_folder(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

}  // namespace

Result<PendingFile> PendingFile::create(const std::string& path) {
  if (path.empty()) return Error{"cannot write: no file name is given"};
  PendingFile pending;
  pending.path_ = path;
  pending.target_ = resolved(path);
  struct stat old {};
  const bool exists = ::stat(pending.target_.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return Error{"cannot write '" + path + "': it is a folder"};
  if (exists && !S_ISREG(old.st_mode)) return Error{"cannot write '" + path + "': it is not a plain file"};
  // Renaming over a write-protected file would succeed: the protection is the user's word, so it is kept.
  if (exists && ::access(pending.target_.c_str(), W_OK) != 0) return cannot_write(path, errno);
  pending.file_ = ::open(file_folder(pending.target_).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (pending.file_ < 0 && has_no_unnamed_files(errno)) {
    pending.temporary_ = pending.target_ + ".XXXXXX";
    pending.file_ = ::mkostemp(pending.temporary_.data(), O_CLOEXEC);
  }
  if (pending.file_ < 0) return cannot_write(path, errno);
  return pending;
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      file_(std::exchange(other.file_, -1)) {}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  if (file_ >= 0) ::close(file_);
}

/// Returns 0 or the system's error code, as does take_name().
int PendingFile::give_rights_and_flush() const {
  struct stat old {};
  mode_t rights = 0;
  if (::stat(target_.c_str(), &old) == 0) {
    rights = old.st_mode & 07777;
  } else {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    rights = 0666 & ~mask;
  }
  return ::fchmod(file_, rights) == 0 && ::fsync(file_) == 0 ? 0 : errno;
}

int PendingFile::take_name() {
  if (temporary_.empty()) {
    // An unnamed file can be given a new name, but not put in place of an old one: that takes a rename.
    const std::string unnamed = "/proc/self/fd/" + std::to_string(file_);
    const auto name_it = [&](const std::string& name) {
      return ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
    };
    int code = name_it(target_);
    if (code != EEXIST) return code;
    for (int i = 0; code == EEXIST; ++i) {
      temporary_ = target_ + "." + std::to_string(::getpid()) + "-" + std::to_string(i);
      code = name_it(temporary_);
    }
    if (code != 0) {
      temporary_.clear();
      return code;
    }
  }
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) return errno;
  temporary_.clear();
  return 0;
}

Result<void> PendingFile::commit() {
  if (const int code = give_rights_and_flush(); code != 0) return cannot_write(path_, code);
  if (const int code = take_name(); code != 0) return cannot_write(path_, code);
  ::close(std::exchange(file_, -1));
  flush_folder(target_);
  return {};
}

Result<int> open_scratch_file(const std::string& folder) {
  int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0 && has_no_unnamed_files(errno)) {
    std::string name = folder + "/.scratch-XXXXXX";
    file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file >= 0) ::unlink(name.c_str());
  }
  if (file < 0)
    return Error{"cannot write to the folder '" + folder + "': " + std::generic_category().message(errno)};
  return file;
}

}  // namespace replan
