// A file that takes its name once it is complete.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace replan {

/// Bytes on the disk of `path` that no folder names until commit(). Whatever ends the program before, even a
/// kill, leaves the old file under the name, or none. Where a file system cannot name an unnamed file,
/// commit() copies it. Systems that have no such files have the bytes in NAME.part until then.
class PendingFile {
 public:
  enum class Until : std::uint8_t { unnamed, part };
#if defined(__linux__)
  static constexpr Until kUsual = Until::unnamed;
#else
  static constexpr Until kUsual = Until::part;
#endif

  /// Follows a symbolic link. Refuses what is no plain file or is protected against writing; the error names
  /// the path and the reason.
  static Result<PendingFile> create(const std::string& path, Until until = kUsual);
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  /// Without commit() the bytes are gone.
  ~PendingFile();

  /// Open for reading and writing; closed by commit() and the destructor.
  [[nodiscard]] int descriptor() const {
    return file_;
  }
  /// Appends bytes.
  Result<void> write(std::string_view bytes);
  /// Flushes the bytes to the disk and puts them in place of the old file, with its rights.
  Result<void> commit();

 private:
  PendingFile() = default;

  std::string path_;    // as asked for, for errors
  std::string target_;  // where a symbolic link leads
  std::string part_;    // the name that the bytes have meanwhile; empty: none
  int file_ = -1;
};

/// A scratch file without a name, on the disk of `folder`; its descriptor, closed when a program is started.
/// The caller closes it. The error is the system's reason alone.
Result<int> open_scratch_file(const std::string& folder);

}  // namespace replan
