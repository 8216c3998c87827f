// runs.jsonl: a line for each run that is done, in the order in which they ended. What is held in memory of a line is its
// place alone, so that a batch of millions of runs can be taken up, put in order and added up.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.hpp"
#include "core/experiment/run_result.hpp"

namespace replan {

class Journal {
 public:
  /// A line without its end.
  struct Line {
    std::int64_t run = 0;
    std::int64_t at = 0;  ///< byte in the file
    std::int64_t bytes = 0;
  };

  /// Looks through a journal as it stands, whoever writes to it. A last line that was cut off is passed over; another one
  /// that is no result is an error with its number.
  static Result<Journal> read(const std::string& path);
  /// The same to be added to: the file is made if need be, and a line that was cut off is dropped.
  static Result<Journal> take_up(const std::string& path);
  Journal(Journal&& other) noexcept
      : path_(std::move(other.path_)),
        file_(std::exchange(other.file_, -1)),
        end_(other.end_),
        lines_(std::move(other.lines_)) {}
  Journal& operator=(Journal&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    std::swap(end_, other.end_);
    std::swap(lines_, other.lines_);
    return *this;
  }
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  [[nodiscard]] std::span<const Line> lines() const { return lines_; }
  [[nodiscard]] Result<RunResult> result(const Line& line) const;
  /// Writes a result down.
  Result<void> add(const RunResult& result);

 private:
  Journal(std::string path, int file) : path_(std::move(path)), file_(file) {}
  Result<void> look_through();

  std::string path_;
  int file_ = -1;
  std::int64_t end_ = 0;  // of the last whole line
  std::vector<Line> lines_;
};

}  // namespace replan
