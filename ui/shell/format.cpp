#include "ui/shell/format.hpp"

#include <array>
#include <ctime>

namespace replan::ui {

std::string fixed(double number, int decimals) {
  return decimal_text(number, decimals);
}

std::string node_text(const Run& run, NodeId node) {
  return replan::node_text(run.lattice(), node);
}

std::string bytes_text(std::uint64_t bytes) {
  const double size = static_cast<double>(bytes);
  if (size < 1e3) return std::to_string(bytes) + " B";
  if (size < 1e6) return fixed(size / 1e3, 1) + " kB";
  if (size < 1e9) return fixed(size / 1e6, 1) + " MB";
  return fixed(size / 1e9, 2) + " GB";
}

std::string date_text(std::int64_t seconds) {
  constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                     "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const std::time_t then = static_cast<std::time_t>(seconds), now = std::time(nullptr);
  std::tm at{}, today{};
  if (::localtime_r(&then, &at) == nullptr || ::localtime_r(&now, &today) == nullptr) return "";
  std::array<char, 64> text{};
  if (at.tm_year != today.tm_year)
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &at);
  else
    std::strftime(text.data(), text.size(), "%H:%M", &at);
  if (at.tm_year != today.tm_year || at.tm_yday == today.tm_yday) return text.data();
  return std::to_string(at.tm_mday) + " " + kMonths[at.tm_mon] + " " + text.data();
}

std::string as_sentence(std::string words) {
  const std::size_t end = words.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
  const bool plain_word = end != 0 && !words.empty() && (end == std::string::npos || words[end] == ' ');
  if (plain_word) words.front() = static_cast<char>(words.front() - 'a' + 'A');
  return words;
}

std::string last_event_text(const Run& run) {
  return event_text(run.log_view(), run.timeline().cursor());
}

}  // namespace replan::ui
