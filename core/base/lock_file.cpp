#include "core/base/lock_file.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace replan {

Result<std::optional<LockFile>> LockFile::take(const std::string& path) {
  std::optional<LockFile> none;
  LockFile file(path, ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  if (file.descriptor_ < 0) return Error{std::generic_category().message(errno)};
  if (::flock(file.descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return none;
    return Error{std::generic_category().message(errno)};  // a disk that takes no locks
  }
  // Its holder may have removed it between our two calls; then the lock is on a file without a name.
  struct stat ours {
  }, named{};
  if (::fstat(file.descriptor_, &ours) != 0 || ::stat(path.c_str(), &named) != 0 ||
      ours.st_ino != named.st_ino)
    return none;
  return std::optional(std::move(file));
}

std::optional<LockFile> LockFile::try_lock(const std::string& path) {
  auto taken = take(path);
  return taken ? std::move(taken.value()) : std::nullopt;
}

LockFile& LockFile::operator=(LockFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

LockFile::~LockFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void LockFile::remove() {
  if (descriptor_ < 0) return;
  ::unlink(path_.c_str());
  ::close(std::exchange(descriptor_, -1));
}

}  // namespace replan
