#include "core/lesson/deeds.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "core/base/words.hpp"
#include "core/lattice/box_words.hpp"
#include "core/plan/parameters.hpp"

namespace replan {
namespace {

using Words = std::span<const std::string_view>;

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (text.empty()) return words;
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

Result<int> whole_number(std::string_view text, int low, int high) {
  int number = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc{} || end != text.data() + text.size() || number < low || number > high)
    return Error{"'" + std::string(text) + "' is no whole number from " + std::to_string(low) + " to " +
                 std::to_string(high)};
  return number;
}

Result<Deed> step_deed(Words words, const Box&) {
  static constexpr std::array<std::string_view, 5> kUnits = {"line", "expansion", "move", "replan",
                                                             "mission"};
  const auto unit = words.empty() ? kUnits.end() : std::find(kUnits.begin(), kUnits.end(), words[0]);
  if (unit == kUnits.end() || words.size() > 2)
    return Error{"a step is 'step UNIT [COUNT]', and a unit is line, expansion, move, replan or mission"};
  int count = 1;
  if (words.size() == 2) {
    const Result<int> number = whole_number(words[1], -1000, 1000);
    if (!number) return Error{number.error()};
    count = *number;
  }
  return Deed(Command(Step{static_cast<StepUnit>(unit - kUnits.begin()), count}));
}

Result<Deed> seek_deed(Words words, const Box&) {
  if (words.size() != 1)
    return Error{"'seek' takes the number of events that lie before the moment: 'seek 0'"};
  const Result<int> number = whole_number(words[0], 0, 1'000'000'000);
  if (!number) return Error{number.error()};
  return Deed(Command(Seek{static_cast<std::size_t>(*number)}));
}

Result<std::vector<CellChange>> changes(Words words, const Box& world, bool blocked) {
  if (words.empty()) return Error{"cells are missing: '3,1 3,2'"};
  std::vector<CellChange> cells;
  for (const std::string_view word : words) {
    const Result<Cell> cell = parse_lesson_cell(word, world);
    if (!cell) return Error{cell.error()};
    cells.push_back({*cell, blocked});
  }
  return cells;
}

template <class Change, bool kBlocked>
Result<Deed> cells_deed(Words words, const Box& world) {
  Result<std::vector<CellChange>> cells = changes(words, world, kBlocked);
  if (!cells) return Error{cells.error()};
  return Deed(Command(Change{std::move(cells.value())}));
}

Result<Deed> goal_deed(Words words, const Box& world) {
  if (words.size() != 1) return Error{"'goal' takes one cell: 'goal 5,2'"};
  const Result<Cell> cell = parse_lesson_cell(words[0], world);
  if (!cell) return Error{cell.error()};
  return Deed(Command(SetGoal{*cell}));
}

Result<Deed> panes_deed(Words words, const Box&) {
  if (words.size() != 1) return Error{"'panes' takes a number from 1 to 4"};
  const Result<int> count = whole_number(words[0], 1, 4);
  if (!count) return Error{count.error()};
  return Deed(Command(SetPanes{static_cast<std::size_t>(*count)}));
}

Result<Deed> lead_deed(Words words, const Box&) {
  if (words.size() != 1) return Error{"'lead' takes the number of a pane, from 1"};
  const Result<int> pane = whole_number(words[0], 1, 4);
  if (!pane) return Error{pane.error()};
  return Deed(Command(Lead{static_cast<std::size_t>(*pane - 1)}));
}

Result<Deed> end_deed(Words words, const Box&) {
  if (!words.empty()) return Error{"nothing follows 'end'"};
  return Deed(Command(RunToEnd{}));
}

Result<Deed> action_deed(Words words, const Box&) {
  if (words.size() != 1)
    return Error{"'action' takes the identifier of one; 'replan list actions' shows them"};
  return Deed(ActionDeed{std::string(words[0])});
}

struct DeedKind {
  std::string_view name;
  Result<Deed> (*read)(Words words, const Box& world);
};
constexpr std::array<DeedKind, 10> kDeeds = {{{"step", step_deed},
                                              {"seek", seek_deed},
                                              {"paint", cells_deed<PaintCells, true>},
                                              {"erase", cells_deed<PaintCells, false>},
                                              {"surprise", cells_deed<DropSurprise, true>},
                                              {"goal", goal_deed},
                                              {"panes", panes_deed},
                                              {"lead", lead_deed},
                                              {"end", end_deed},
                                              {"action", action_deed}}};

Error unknown_deed(std::string_view name) {
  std::vector<std::string_view> names;
  std::string list;
  for (const DeedKind& kind : kDeeds) {
    names.push_back(kind.name);
    list += (list.empty() ? "" : kind.name == kDeeds.back().name ? " or " : ", ") + std::string(kind.name);
  }
  const std::string_view nearest = nearest_name(name, names);
  return Error{
      "there is no deed '" + std::string(name) + "'" +
      (nearest.empty() ? "; it begins with " + list : "; did you mean '" + std::string(nearest) + "'?")};
}

}  // namespace

Result<Cell> parse_lesson_cell(std::string_view words, const Box& world) {
  std::array<int, 3> numbers{};
  std::size_t count = 0;
  std::string_view rest = words;
  while (count < numbers.size()) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const auto [end, failed] = std::from_chars(rest.data(), rest.data() + rest.size(), numbers[count]);
    if (failed != std::errc{}) break;
    ++count;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (!rest.starts_with(',')) break;
    rest.remove_prefix(1);
  }
  const std::size_t wanted = world.solid() ? 3 : 2;
  if (count != wanted || !rest.empty())
    return Error{"'" + std::string(words) + "' is no cell; write " + (wanted == 3 ? "3,1,0" : "3,1")};
  const Cell cell{numbers[0], numbers[1], numbers[2]};
  if (!world.contains(cell))
    return Error{"the cell " + cell_text(cell, world.solid()) +
                 " is outside the world: " + range_text(world)};
  return cell;
}

Result<Deed> parse_deed(std::string_view text, const Box& world) {
  const std::vector<std::string_view> words = words_of(text);
  if (words.empty()) return Error{"a deed is missing, such as 'step expansion'"};
  for (const DeedKind& kind : kDeeds)
    if (kind.name == words.front()) return kind.read(Words(words).subspan(1), world);
  return unknown_deed(words.front());
}

}  // namespace replan
