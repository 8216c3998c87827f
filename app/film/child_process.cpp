#include "app/film/child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace replan::app {
namespace {

constexpr int kComplaintLines = 3;

std::string reason(int code) {
  return std::generic_category().message(code);
}

/// What posix_spawn is told, given back in every case.
struct Spawning {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  std::vector<int> copies;

  Spawning() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    // A group of its own: Ctrl+C is for this program, which then leaves no file.
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  }
  /// Copies go by way of high numbers, so that none is overwritten before it has been handed over.
  void hand_over(int from, int to) {
    constexpr int kHigh = 64;
    const int copy = ::fcntl(from, F_DUPFD_CLOEXEC, kHigh);
    if (copy < 0) return;
    copies.push_back(copy);
    posix_spawn_file_actions_adddup2(&files, copy, to);
  }
  ~Spawning() {
    for (const int copy : copies) ::close(copy);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  Spawning(const Spawning&) = delete;
  Spawning& operator=(const Spawning&) = delete;
};

/// The last lines of a text, joined by "; ".
std::string last_lines(std::string_view text, int count) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    if (!line.empty() && line.find("Last message repeated") == line.npos) lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  std::string joined;
  const std::size_t first = lines.size() - std::min(lines.size(), static_cast<std::size_t>(count));
  for (std::size_t i = first; i < lines.size(); ++i)
    joined += (i > first ? "; " : "") + std::string(lines[i]);
  return joined;
}

}  // namespace

Result<std::unique_ptr<ChildProcess>> ChildProcess::start(const std::vector<std::string>& arguments,
                                                          std::span<const std::pair<int, int>> files) {
  std::unique_ptr<ChildProcess> child(new ChildProcess);
  child->name_ = arguments.front();
  // A socket instead of a pipe: a reader that has gone away is an error there and no signal.
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return Error{"cannot start " + child->name_ + ": " + reason(errno)};
  child->input_ = ends[0];
  child->complaints_ = ::memfd_create("complaints", MFD_CLOEXEC);
  Spawning how;
  how.hand_over(ends[1], STDIN_FILENO);
  how.hand_over(child->complaints_, STDERR_FILENO);
  for (const auto& [from, to] : files) how.hand_over(from, to);
  posix_spawn_file_actions_addopen(&how.files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int code =
      ::posix_spawnp(&child->process_, argv[0], &how.files, &how.attributes, argv.data(), environ);
  ::close(ends[1]);
  if (code != 0) {
    child->process_ = -1;
    return Error{"cannot start " + child->name_ + ": " + reason(code)};
  }
  return child;
}

bool ChildProcess::is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string_view folders = path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin";
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const std::string file = std::string(folders.substr(0, end)) + "/" + program;
    if (::access(file.c_str(), X_OK) == 0) return true;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return false;
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  close_input();
  if (complaints_ >= 0) ::close(complaints_);
}

bool ChildProcess::feed(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t taken = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (taken < 0 && errno == EINTR) continue;
    if (taken <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(taken));
  }
  return true;
}

void ChildProcess::close_input() {
  if (input_ >= 0) ::close(std::exchange(input_, -1));
}

Result<void> ChildProcess::finish() {
  close_input();
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  const std::string end = WIFSIGNALED(status)
                              ? std::string("was ended by a signal (") + ::strsignal(WTERMSIG(status)) + ")"
                              : "failed with code " + std::to_string(WEXITSTATUS(status));
  const std::string words = complaints();
  return Error{name_ + " " + end + (words.empty() ? " and said nothing" : ": " + words)};
}

std::string ChildProcess::complaints() const {
  struct stat info {};
  if (complaints_ < 0 || ::fstat(complaints_, &info) != 0) return {};
  constexpr off_t kMost = 4096;
  std::string text(static_cast<std::size_t>(std::min(info.st_size, kMost)), '\0');
  const ssize_t got =
      ::pread(complaints_, text.data(), text.size(), std::max<off_t>(0, info.st_size - kMost));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return last_lines(text, kComplaintLines);
}

}  // namespace replan::app
