#include "core/base/file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/pending_file.hpp"

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

Result<void> write_straight(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.valid()) return cannot("write", path, reason(errno));
  if (const int code = write_all(file.number(), bytes); code != 0) return cannot("write", path, reason(code));
  if (!file.close()) return cannot("write", path, reason(errno));
  return {};
}

}  // namespace

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
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (exists && !S_ISREG(old.st_mode) && !S_ISDIR(old.st_mode)) return write_straight(path, bytes);
  Result<PendingFile> file = PendingFile::create(path);
  if (!file) return Error{file.error()};
  if (const auto written = file->write(bytes); !written) return written;
  return file->commit();
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
