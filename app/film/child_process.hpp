// Another program that works for this one: fed through a pipe, its complaints kept.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

#include "core/base/result.hpp"

namespace replan::app {

class ChildProcess {
 public:
  /// Starts `arguments[0]`, looked for in PATH. It gets a pipe as its input, nothing as its output, and each
  /// descriptor of `files` under the number beside it. An interrupt typed at the terminal does not reach it.
  /// An Error says why it could not be started.
  static Result<std::unique_ptr<ChildProcess>> start(const std::vector<std::string>& arguments,
                                                     std::span<const std::pair<int, int>> files);
  /// Whether PATH leads to a program of that name.
  static bool is_installed(const std::string& program);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Kills it if it still runs.
  ~ChildProcess();

  /// Feeds its input; waits until it has taken all. False if it takes no more.
  bool feed(std::span<const std::uint8_t> bytes);
  /// Ends its input and waits for it. An Error says how it ended and what its last lines of complaint were.
  Result<void> finish();

 private:
  ChildProcess() = default;
  void close_input();
  [[nodiscard]] std::string complaints() const;

  std::string name_;
  pid_t process_ = -1;
  int input_ = -1;
  int complaints_ = -1;
};

}  // namespace replan::app
