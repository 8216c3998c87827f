#include "core/session/document_change.hpp"

#include <iterator>
#include <utility>

namespace replan {
namespace {

/// The scenario without the cells of its map and without its surprises.
std::shared_ptr<const Scenario> rest_of(const Scenario& scenario) {
  Scenario rest = scenario;
  rest.map.blocked.clear();
  rest.surprises.clear();
  return std::make_shared<const Scenario>(std::move(rest));
}

/// Puts another rest in place.
void replace_rest(Scenario& scenario, const Scenario& rest) {
  SharedBytes cells = std::move(scenario.map.blocked);
  Surprises surprises = std::move(scenario.surprises);
  scenario = rest;
  scenario.map.blocked = std::move(cells);
  scenario.surprises = std::move(surprises);
}

void replace_surprises(Scenario& scenario, std::size_t common, const std::vector<Surprise>& behind) {
  scenario.surprises.truncate(common);
  for (const Surprise& surprise : behind) scenario.surprises.push_back(surprise);
}

/// The cells that differ, or both maps as a whole where that takes less.
void note_map(DocumentChange& change, const SharedBytes& before, const SharedBytes& after) {
  const std::size_t worth_listing = before.size() / sizeof(DocumentChange::CellValue) + 64;
  bool lists = before.size() == after.size();
  const auto list = [&](std::size_t first, std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    for (std::size_t i = 0; i < a.size() && lists; ++i) {
      if (a[i] == b[i]) continue;
      change.cells.push_back({static_cast<std::uint32_t>(first + i), a[i], b[i]});
      lists = change.cells.size() <= worth_listing;
    }
  };
  if (lists) SharedBytes::each_unshared(before, after, list);
  if (lists) return;
  change.cells.clear();
  change.map_before = before;
  change.map_after = after;
}

std::vector<Surprise> behind(const Surprises& surprises, std::size_t common) {
  return {surprises.begin() + static_cast<std::ptrdiff_t>(common), surprises.end()};
}

}  // namespace

bool only_cells_differ(const Scenario& a, const Scenario& b) {
  const bool alike = Surprises::common(a.surprises, b.surprises) == a.surprises.size() &&
                     a.surprises.size() == b.surprises.size();
  return alike && *rest_of(a) == *rest_of(b);
}

DocumentChange change_between(const Scenario& before, const Scenario& after) {
  DocumentChange change;
  note_map(change, before.map.blocked, after.map.blocked);
  change.common = Surprises::common(before.surprises, after.surprises);
  change.surprises_before = behind(before.surprises, change.common);
  change.surprises_after = behind(after.surprises, change.common);
  auto rest_before = rest_of(before), rest_after = rest_of(after);
  if (*rest_before == *rest_after) return change;
  change.rest_before = std::move(rest_before);
  change.rest_after = std::move(rest_after);
  return change;
}

void take_back(const DocumentChange& change, Scenario& scenario) {
  if (change.rest_before) replace_rest(scenario, *change.rest_before);
  if (change.replaces_map()) scenario.map.blocked = change.map_before;
  // Backwards: a cell may have been written several times in one stroke.
  for (auto each = change.cells.rbegin(); each != change.cells.rend(); ++each)
    scenario.map.blocked[each->cell] = each->before;
  replace_surprises(scenario, change.common, change.surprises_before);
}

void make_again(const DocumentChange& change, Scenario& scenario) {
  if (change.rest_after) replace_rest(scenario, *change.rest_after);
  if (change.replaces_map()) scenario.map.blocked = change.map_after;
  for (const DocumentChange::CellValue& each : change.cells) scenario.map.blocked[each.cell] = each.after;
  replace_surprises(scenario, change.common, change.surprises_after);
}

void append(DocumentChange& first, DocumentChange second) {
  first.cells.insert(first.cells.end(), second.cells.begin(), second.cells.end());
  if (second.rest_after) {
    if (!first.rest_before) first.rest_before = std::move(second.rest_before);
    first.rest_after = std::move(second.rest_after);
  }
  if (second.common < first.common) {
    // The second change goes back further than the first: what lies between is as it was before both.
    const auto between = second.surprises_before.begin();
    const auto count = static_cast<std::ptrdiff_t>(first.common - second.common);
    first.surprises_before.insert(first.surprises_before.begin(), between, between + count);
    first.surprises_after.clear();
    first.common = second.common;
  } else {
    first.surprises_after.resize(second.common - first.common);
  }
  std::move(second.surprises_after.begin(), second.surprises_after.end(),
            std::back_inserter(first.surprises_after));
}

}  // namespace replan
