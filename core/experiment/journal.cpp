#include "core/experiment/journal.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "core/base/file.hpp"

namespace replan {
namespace {

constexpr std::size_t kJournalPiece = std::size_t{1} << 18;
/// No result is as long by far: times of 10 000 repeats take some 400 kB.
constexpr std::size_t kLongestLine = std::size_t{1} << 26;

Error cannot_use(const char* what, const std::string& path, int code) {
  return {std::string("cannot ") + what + " '" + path + "': " + std::generic_category().message(code)};
}

/// Up to so many bytes from there on, fewer at the file's end alone; -1: the system's error is in errno.
ssize_t read_at(int file, char* bytes, std::size_t count, std::int64_t at) {
  std::size_t filled = 0;
  while (filled < count) {
    const ssize_t got = ::pread(file, bytes + filled, count - filled,
                                static_cast<off_t>(at + static_cast<std::int64_t>(filled)));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return -1;
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  return static_cast<ssize_t>(filled);
}

}  // namespace

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

Result<Journal> Journal::read(const std::string& path) {
  Journal journal(path, ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (journal.file_ < 0) return cannot_use("read", path, errno);
  if (const auto looked = journal.look_through(); !looked) return Error{looked.error()};
  return journal;
}

Result<Journal> Journal::take_up(const std::string& path) {
  Journal journal(path, ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (journal.file_ < 0) return cannot_use("write", path, errno);
  if (const auto looked = journal.look_through(); !looked) return Error{looked.error()};
  if (::ftruncate(journal.file_, static_cast<off_t>(journal.end_)) != 0)
    return cannot_use("write", path, errno);
  return journal;
}

/// Piece by piece: what is held is what has been read behind the last whole line.
Result<void> Journal::look_through() {
  std::string held;
  for (bool more = true; more;) {
    const std::size_t before = held.size();
    held.resize(before + kJournalPiece);
    const ssize_t got =
        read_at(file_, held.data() + before, kJournalPiece, end_ + static_cast<std::int64_t>(before));
    if (got < 0) return cannot_use("read", path_, errno);
    held.resize(before + static_cast<std::size_t>(got));
    more = static_cast<std::size_t>(got) == kJournalPiece;
    std::size_t begin = 0;
    for (std::size_t end = held.find('\n', before); end != std::string::npos; end = held.find('\n', begin)) {
      const auto result = parse_result_line(held.substr(begin, end - begin), path_);
      if (!result)
        return Error{"line " + std::to_string(lines_.size() + 1) + " of '" + path_ +
                     "' is no result: delete that line, and its run is made again"};
      const auto bytes = static_cast<std::int64_t>(end - begin);
      lines_.push_back({result->run, end_, bytes});
      end_ += bytes + 1;
      begin = end + 1;
    }
    held.erase(0, begin);
    if (held.size() > kLongestLine)
      return Error{"line " + std::to_string(lines_.size() + 1) + " of '" + path_ +
                   "' is too long for a result: delete it, and its run is made again"};
  }
  return {};
}

Result<RunResult> Journal::result(const Line& line) const {
  std::string text(static_cast<std::size_t>(line.bytes), '\0');
  const ssize_t got = read_at(file_, text.data(), text.size(), line.at);
  if (got < 0) return cannot_use("read", path_, errno);
  if (static_cast<std::int64_t>(got) != line.bytes)
    return Error{"'" + path_ + "' has become shorter while it was read: let one process alone write to it"};
  return parse_result_line(text, path_);
}

Result<void> Journal::add(const RunResult& result) {
  const std::string line = result_line(result);
  if (const int code = write_all(file_, line + "\n"); code != 0) return cannot_use("write", path_, code);
  const auto bytes = static_cast<std::int64_t>(line.size());
  lines_.push_back({result.run, end_, bytes});
  end_ += bytes + 1;
  return {};
}

}  // namespace replan
