#include "core/base/file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace replan {
namespace {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool valid() const { return number_ >= 0; }
  /// False if the system reports a late failure, such as a full network disk.
  bool close() {
    if (number_ < 0) return true;
    return ::close(std::exchange(number_, -1)) == 0;
  }

 private:
  int number_;
};

std::string reason(int code) {
  return std::generic_category().message(code);
}

Error cannot(const char* what, const std::string& path, const std::string& why) {
  return {std::string("cannot ") + what + " '" + path + "': " + why};
}

Error too_large(const std::string& path, std::int64_t limit) {
  return cannot("read", path, "it has more than the allowed " + std::to_string(limit) + " bytes");
}

/// Returns 0 or the system's error code.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), std::min<std::size_t>(bytes.size(), 1u << 30));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return EIO;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// The rights that a new file gets here: those of the file it replaces, or what the process's mask leaves.
mode_t rights_for(bool exists, const struct stat& old) {
  if (exists) return old.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

/// Fills the open temporary file and puts it in place of `target`. Returns 0 or the system's error code.
int fill_and_rename(Descriptor& file, const std::string& temporary, const std::string& target, mode_t rights,
                    std::string_view bytes) {
  if (const int code = write_all(file.number(), bytes); code != 0) return code;
  if (::fchmod(file.number(), rights) != 0 || ::fsync(file.number()) != 0) return errno;
  if (!file.close()) return errno;
  return std::rename(temporary.c_str(), target.c_str()) == 0 ? 0 : errno;
}

/// Flushes the folder's entry, so that the rename survives a power cut. Not every file system can; none has
/// to.
void flush_folder(const std::string& target) {
  const Descriptor folder(::open(file_folder(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.valid()) ::fsync(folder.number());
}

Result<void> write_straight(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.valid()) return cannot("write", path, reason(errno));
  if (const int code = write_all(file.number(), bytes); code != 0) return cannot("write", path, reason(code));
  if (!file.close()) return cannot("write", path, reason(errno));
  return {};
}

/// Where a symbolic link ends, or the path itself.
std::string resolved(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_symlink(path, failed)) return path;
  const std::filesystem::path end = std::filesystem::weakly_canonical(path, failed);
  return failed ? path : end.string();
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::int64_t limit) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.valid()) return cannot("read", path, reason(errno));
  struct stat info {};
  if (::fstat(file.number(), &info) != 0) return cannot("read", path, reason(errno));
  if (S_ISDIR(info.st_mode)) return cannot("read", path, "it is a folder");
  if (info.st_size > limit) return too_large(path, limit);
  // A pipe has no size: read on until its end. One byte more than expected shows the end without another
  // growth.
  std::string bytes(static_cast<std::size_t>(S_ISREG(info.st_mode) ? info.st_size : 1 << 16) + 1, '\0');
  std::size_t filled = 0;
  for (;;) {
    if (filled == bytes.size()) bytes.resize(bytes.size() * 2);
    const ssize_t got = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return cannot("read", path, reason(errno));
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled > static_cast<std::size_t>(limit)) return too_large(path, limit);
  }
  bytes.resize(filled);
  return bytes;
}

Result<void> write_file_atomically(const std::string& path, std::string_view bytes) {
  if (path.empty()) return Error{"cannot write: no file name is given"};
  const std::string target = resolved(path);
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return cannot("write", path, "it is a folder");
  if (exists && !S_ISREG(old.st_mode)) return write_straight(target, bytes);
  // Renaming over a write-protected file would succeed: the protection is the user's word, so it is kept.
  if (exists && ::access(target.c_str(), W_OK) != 0) return cannot("write", path, reason(errno));
  std::string temporary = target + ".XXXXXX";
  Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  if (!file.valid()) return cannot("write", path, reason(errno));
  if (const int code = fill_and_rename(file, temporary, target, rights_for(exists, old), bytes); code != 0) {
    ::unlink(temporary.c_str());
    return cannot("write", path, reason(code));
  }
  flush_folder(target);
  return {};
}

std::string file_extension(std::string_view path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

std::string file_stem(std::string_view path) {
  return std::filesystem::path(file_name(path)).stem().string();
}

std::string file_name(std::string_view path) {
  const std::size_t parting = path.find_last_of("/\\");
  return std::string(parting == std::string_view::npos ? path : path.substr(parting + 1));
}

std::string file_folder(std::string_view path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace replan
