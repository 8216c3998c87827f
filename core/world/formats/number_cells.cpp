#include "core/world/formats/number_cells.hpp"

#include <algorithm>
#include <cmath>

#include "core/world/formats/text_lines.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

constexpr std::uint8_t kFirstNumber = 16;
constexpr std::size_t kMostNumbers = 64;  // told apart; those beyond count as the last of them

std::string number_text(double number) {
  return plain_number(number).dump();
}

/// "0, 100 and 205", or "0, 1, 2, 3, 4, 5, 6 and 57 more".
std::string listed(const std::vector<double>& numbers) {
  constexpr std::size_t kListed = 7;
  std::string list;
  const std::size_t named = numbers.size() > kListed + 1 ? kListed : numbers.size() - 1;
  for (std::size_t i = 0; i < named; ++i) list += (i == 0 ? "" : ", ") + number_text(numbers[i]);
  return list + " and " +
         (named + 1 == numbers.size() ? number_text(numbers.back())
                                      : std::to_string(numbers.size() - named) + " more");
}

bool is_among(const std::vector<double>& numbers, double number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

}  // namespace

std::optional<double> cell_number(std::string_view word) {
  if (word == "True" || word == "true") return 1;
  if (word == "False" || word == "false") return 0;
  if (word.size() > 1 && word.front() == '+') word.remove_prefix(1);
  const auto number = number_from<double>(word);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

void NumberCells::add(double number) {
  if (number == 0) number = 0;  // and not -0, which would be written so
  if (numbers_.empty() || numbers_[last_] != number) {
    const auto found = std::find(numbers_.begin(), numbers_.end(), number);
    const bool room = numbers_.size() < kMostNumbers || number == occupied_;
    const bool kept = found != numbers_.end() || room;
    last_ = static_cast<std::uint8_t>(kept ? static_cast<std::size_t>(found - numbers_.begin())
                                           : kMostNumbers - 1);
    if (found == numbers_.end() && room) numbers_.push_back(number);
  }
  cells_.push_back(static_cast<std::uint8_t>(kFirstNumber + last_));
}

bool NumberCells::needs_words() const {
  return std::any_of(numbers_.begin(), numbers_.end(), [](double n) { return n != 0 && n != 1; });
}

std::vector<double> NumberCells::numbers() const {
  std::vector<double> sorted = numbers_;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Result<std::vector<std::uint8_t>> NumberCells::finish(const std::string& origin,
                                                      std::vector<std::string>& notes) {
  double obstacle = 1;
  if (occupied_) {
    obstacle = *occupied_;
    if (!is_among(numbers_, obstacle))
      notes.push_back(origin + ": no cell is " + number_text(obstacle) +
                      ", which is to be the obstacle: no number makes an obstacle here");
  } else if (needs_words()) {
    if (numbers_.size() != 2 || !is_among(numbers_, 0))
      return Error{origin +
                   (numbers_.size() == 1 ? ": all numbers are " + number_text(numbers_[0])
                                         : ": there are the numbers " + listed(numbers())) +
                   ": say which one is the obstacle with --occupied VALUE, or in the Open dialog"};
    obstacle = numbers_[numbers_[0] == 0 ? 1 : 0];
    notes.push_back(origin + ": " + number_text(obstacle) +
                    " is taken for the obstacle and 0 for free; --occupied 0 is the other way round");
  }
  for (std::uint8_t& cell : cells_)
    if (cell >= kFirstNumber) cell = numbers_[cell - kFirstNumber] == obstacle ? kObstacle : kFree;
  return std::move(cells_);
}

}  // namespace replan
