#include "app/cli/output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <unistd.h>

namespace replan::cli {
namespace {

int first_failure = 0;  // the first error number of a write to stdout

void remember_failure() {
  if (first_failure == 0) first_failure = errno != 0 ? errno : EIO;
}

/// One line on stderr, behind what stands on stdout.
void print_error_line(std::string line, std::string_view message) {
  for (const char c : message) line += c == '\n' ? ' ' : c;
  line += '\n';
  std::fflush(stdout);
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace

void print(std::string_view text) {
  if (first_failure != 0) return;
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) remember_failure();
}

int finish_output(int code) {
  errno = 0;
  if (std::fflush(stdout) != 0) remember_failure();
  if (first_failure == 0 || first_failure == EPIPE) return code;
  complain(std::string("cannot write the output: ") + std::strerror(first_failure));
  return kBadInput;
}

void complain(std::string_view message) {
  print_error_line("replan: ", message);
}

void tell_notes(std::span<const std::string> notes) {
  for (const std::string& note : notes) print_error_line("note: ", note);
}

std::string decimals(double value, int count) {
  char text[400];
  const int size = std::snprintf(text, sizeof text, "%.*f", count, value);
  return {text, static_cast<std::size_t>(std::clamp(size, 0, static_cast<int>(sizeof text) - 1))};
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  std::string result;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column > indent && column + 1 + end > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    }
    if (column > indent) result += ' ';
    result += text.substr(0, end);
    column += end + (column > indent ? 1 : 0);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string Table::text() const {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    widths.push_back(columns_[i].name.size());
    for (const auto& row : rows_) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string result;
  const auto put = [&](std::size_t column, const std::string& cell) {
    const std::string blanks(widths[column] - cell.size(), ' ');
    if (column > 0) result += "  ";
    result += columns_[column].align == Align::right ? blanks + cell : cell + blanks;
  };
  const auto end_line = [&] {
    result.erase(result.find_last_not_of(' ') + 1);
    result += '\n';
  };
  for (std::size_t i = 0; i < columns_.size(); ++i) put(i, columns_[i].name);
  end_line();
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) put(i, row[i]);
    end_line();
  }
  return result;
}

ProgressBar::ProgressBar(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (terminal_) std::fputs("\r\x1B[K", stderr);
}

/// ", 12 s left", going by the time so far; nothing before that says anything.
std::string ProgressBar::time_left(std::chrono::steady_clock::time_point now, std::size_t done) const {
  const double gone = std::chrono::duration<double>(now - begun_).count();
  if (gone < 1 || done == 0 || done >= total_) return {};
  const auto left =
      static_cast<long>(gone * static_cast<double>(total_ - done) / static_cast<double>(done)) + 1;
  return left < 120 ? ", " + std::to_string(left) + " s left"
                    : ", " + std::to_string(left / 60) + " min left";
}

void ProgressBar::show(std::size_t done) {
  constexpr std::size_t kWidth = 30;
  constexpr std::chrono::milliseconds kBetween{80};
  if (!terminal_ || total_ == 0) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - drawn_ < kBetween && done < total_) return;
  drawn_ = now;
  const std::size_t filled = kWidth * done / total_;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r\x1B[K%s [%s] %zu of %zu%s", label_.c_str(), bar.c_str(), done, total_,
               time_left(now, done).c_str());
  std::fflush(stderr);
}

}  // namespace replan::cli
