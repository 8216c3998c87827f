// The program as a child process: what it prints, and how it ends.
#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"

namespace replan::test {

/// How a child came out.
struct Outcome {
  int code = -1;  ///< exit code; 128 + signal if a signal ended it
  std::string out, err;

  /// stdout as JSON. It must be one document without anything around it.
  [[nodiscard]] nlohmann::json json() const {
    const auto document = nlohmann::json::parse(out, nullptr, false);
    EXPECT_FALSE(document.is_discarded()) << "not JSON: " << out;
    return document;
  }
};

inline std::string whole_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Becomes the program, with stdout in one file and stderr in another, and no display to open a window on.
[[noreturn]] inline void become_program(std::vector<std::string> arguments, int out, int err) {
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  arguments.insert(arguments.begin(), REPLAN_PROGRAM);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  execv(REPLAN_PROGRAM, argv.data());
  _exit(127);
}

inline int exit_code(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Runs the program with stdout going to the open file `out`.
inline int run_into(const std::vector<std::string>& arguments, int out, const std::string& err_path) {
  const int err = open(err_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const pid_t child = fork();
  if (child == 0) become_program(arguments, out, err);
  close(err);
  int status = 0;
  waitpid(child, &status, 0);
  return exit_code(status);
}

/// Runs the program to its end.
inline Outcome run_program(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const int out = open(folder.file("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  Outcome outcome;
  outcome.code = run_into(arguments, out, folder.file("err"));
  close(out);
  outcome.out = whole_file(folder.file("out"));
  outcome.err = whole_file(folder.file("err"));
  return outcome;
}

/// The keys of a JSON object.
inline std::set<std::string> keys(const nlohmann::json& object) {
  std::set<std::string> result;
  for (const auto& [key, value] : object.items()) result.insert(key);
  return result;
}

/// Bad input: exit code 2, nothing on stdout, one line on stderr that says all of `phrases`.
inline void expect_complaint(const std::vector<std::string>& arguments,
                             const std::vector<std::string>& phrases) {
  const Outcome outcome = run_program(arguments);
  std::string line;
  for (const std::string& argument : arguments) line += argument + " ";
  SCOPED_TRACE("replan " + line);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("replan: ")) << outcome.err;
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << "one line: " << outcome.err;
  for (const std::string& phrase : phrases)
    EXPECT_NE(outcome.err.find(phrase), std::string::npos)
        << "should say '" << phrase << "': " << outcome.err;
}

}  // namespace replan::test
