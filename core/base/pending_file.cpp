#include "core/base/pending_file.hpp"

#include <array>
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

/// All bytes of one file to the end of another. Returns 0 or the system's error code, as do those below.
int copy_bytes(int from, int to) {
  std::array<char, 1 << 16> bytes{};
  for (off_t at = 0;;) {
    const ssize_t got = ::pread(from, bytes.data(), bytes.size(), at);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno;
    if (got == 0) return 0;
    if (const int code = write_all(to, {bytes.data(), static_cast<std::size_t>(got)}); code != 0) return code;
    at += got;
  }
}

/// What a new file may be used for: the system takes off what the process's mask does. To ask for the mask would set it
/// for a moment, in all threads, and pages have none.
constexpr mode_t kNewRights = 0666;

/// Those of the old file, if there is one.
int give_rights_and_flush(int file, const std::string& target) {
  struct stat old {};
  if (::stat(target.c_str(), &old) == 0 && ::fchmod(file, old.st_mode & 07777) != 0) return errno;
  return ::fsync(file) == 0 ? 0 : errno;
}

/// A name beside the target that nobody else gives; another for each number.
std::string name_beside(const std::string& target, int number) {
  return target + "." + std::to_string(::getpid()) + "-" + std::to_string(number);
}

int name_unnamed(int file, const std::string& name) {
  const std::string unnamed = "/proc/self/fd/" + std::to_string(file);
  return ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
}

int rename_or_remove(const std::string& temporary, const std::string& target) {
  if (std::rename(temporary.c_str(), target.c_str()) == 0) return 0;
  const int code = errno;
  ::unlink(temporary.c_str());
  return code;
}

/// An unnamed file can be given a new name, but not put in place of an old one: that takes a rename.
int replace_by_unnamed(int file, const std::string& target) {
  int code = name_unnamed(file, target);
  if (code != EEXIST) return code;
  std::string temporary;
  for (int i = 0; code == EEXIST; ++i) {
    temporary = name_beside(target, i);
    code = name_unnamed(file, temporary);
  }
  return code == 0 ? rename_or_remove(temporary, target) : code;
}

/// For file systems where a file without a name can never have one.
int replace_by_copy(int file, const std::string& target) {
  std::string temporary;
  int copy = -1;
  for (int i = 0; i == 0 || (copy < 0 && errno == EEXIST); ++i) {
    temporary = name_beside(target, i);
    copy = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, kNewRights);
  }
  if (copy < 0) return errno;
  int code = copy_bytes(file, copy);
  if (code == 0) code = give_rights_and_flush(copy, target);
  if (::close(copy) != 0 && code == 0) code = errno;
  if (code == 0) return rename_or_remove(temporary, target);
  ::unlink(temporary.c_str());
  return code;
}

/// Takes the place of what a program that was ended has left behind.
Result<int> open_part(const std::string& name) {
  const int file = ::open(name.c_str(), O_CREAT | O_TRUNC | O_RDWR | O_CLOEXEC | O_NOFOLLOW, kNewRights);
  if (file < 0) return Error{std::generic_category().message(errno)};
  return file;
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

Result<PendingFile> PendingFile::create(const std::string& path, Until until) {
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
  if (until == Until::part) pending.part_ = pending.target_ + ".part";
  const Result<int> file =
      until == Until::part ? open_part(pending.part_) : open_scratch_file(file_folder(pending.target_));
  if (!file) return Error{"cannot write '" + path + "': " + file.error()};
  pending.file_ = *file;
  return pending;
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      part_(std::move(other.part_)),
      file_(std::exchange(other.file_, -1)) {}

PendingFile::~PendingFile() {
  if (file_ < 0) return;
  ::close(file_);
  if (!part_.empty()) ::unlink(part_.c_str());
}

Result<void> PendingFile::write(std::string_view bytes) {
  const int code = write_all(file_, bytes);
  if (code != 0) return cannot_write(path_, code);
  return {};
}

Result<void> PendingFile::commit() {
  int code = give_rights_and_flush(file_, target_);
  if (code == 0) code = part_.empty() ? replace_by_unnamed(file_, target_) : rename_or_remove(part_, target_);
  if (part_.empty() && (code == ENOENT || code == EXDEV)) code = replace_by_copy(file_, target_);
  if (code != 0) return cannot_write(path_, code);
  ::close(std::exchange(file_, -1));
  flush_folder(target_);
  return {};
}

Result<int> open_scratch_file(const std::string& folder) {
#if defined(O_TMPFILE)
  int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kNewRights);
  const bool unnamed = file >= 0 || !has_no_unnamed_files(errno);
#else
  int file = -1;
  const bool unnamed = false;
#endif
  if (!unnamed) {
    std::string name = folder + "/.scratch-XXXXXX";
    file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file >= 0) ::unlink(name.c_str());
  }
  if (file < 0) return Error{std::generic_category().message(errno)};
  return file;
}

}  // namespace replan
