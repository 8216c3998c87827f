// What the commands print: results to stdout, one line of error to stderr, a progress bar where somebody
// watches.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/words.hpp"

namespace replan::cli {

/// Exit codes of the program.
inline constexpr int kDone = 0;      ///< everything asked for was done
inline constexpr int kFailed = 1;    ///< no path, or a check failed
inline constexpr int kBadInput = 2;  ///< the input or the output could not be used

/// Writes to stdout. A reader that has gone away ends the output quietly.
void print(std::string_view text);
/// Flushes stdout and returns `code`, or kBadInput with an error where stdout could not take everything (a
/// full disk).
int finish_output(int code);
/// One line on stderr: "replan: MESSAGE".
void complain(std::string_view message);

/// What the reader of a file has to say, a line each on stderr: "note: SENTENCE". So it does not get into
/// results that a program reads.
void tell_notes(std::span<const std::string> notes);

/// A number with that many decimals.
std::string decimals(double value, int count);
/// Text in lines of at most `width` columns, broken at blanks, each after the first indented by `indent`.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width = 100);

/// Rows of cells under column names, parted by two blanks.
class Table {
 public:
  enum class Align : unsigned char { left, right };
  struct Column {
    std::string name;
    Align align = Align::right;
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}
  /// As many cells as there are columns.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] std::string text() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// A bar with the time left on stderr if that is a terminal, nothing otherwise. Gone when it is destroyed.
class ProgressBar {
 public:
  ProgressBar(std::string label, std::size_t total);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void show(std::size_t done);

 private:
  [[nodiscard]] std::string time_left(std::chrono::steady_clock::time_point now, std::size_t done) const;

  std::string label_;
  std::size_t total_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  bool terminal_;
  std::chrono::steady_clock::time_point drawn_{};
};

}  // namespace replan::cli
