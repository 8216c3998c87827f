// Files as whole strings of bytes: read with a stated limit, written beside the old file and then put in its
// place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace replan {

/// The most bytes that read_file() takes unless told otherwise (1 GiB).
inline constexpr std::int64_t kMaxFileBytes = std::int64_t{1} << 30;

/// The bytes of a file. A file of more than `limit` bytes is refused before memory is taken for it. The error
/// names the path and the reason.
Result<std::string> read_file(const std::string& path, std::int64_t limit = kMaxFileBytes);

/// Writes `bytes` beside `path`, flushes them to the disk and renames the result to `path`, so that at every
/// moment the whole old or the whole new file stands there. After a failure the old file is untouched and
/// nothing is left beside it. A symbolic link is followed; what is not a plain file (a pipe, a device) is
/// written straight to. The error names the path and the reason.
Result<void> write_file_atomically(const std::string& path, std::string_view bytes);

/// All bytes to an open file. Returns 0 or the system's error code.
int write_all(int file, std::string_view bytes);

/// The extension in lower case with its dot (".map"), or empty.
std::string file_extension(std::string_view path);
/// The file name without its folder and its last extension: "x.map" of "a/x.map.scen".
std::string file_stem(std::string_view path);
/// The file name without its folder; '/' and '\' both part folders, as files from other systems name maps.
std::string file_name(std::string_view path);
/// The folder that a path lies in, "." where it names none.
std::string file_folder(std::string_view path);

}  // namespace replan
