#include "core/world/formats/scen_lines.hpp"

#include <algorithm>
#include <cmath>

namespace replan {
namespace {

std::string_view without_blanks_around(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  return without_trailing_blanks(text);
}

}  // namespace

std::string_view ScenFields::next() {
  if (!tabs_) return take_word(rest_);
  const std::size_t end = std::min(rest_.find('\t'), rest_.size());
  const std::string_view field = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  return without_blanks_around(field);
}

std::string_view ScenFields::rest() const {
  return without_blanks_around(rest_);
}

Error ScenLines::wrong(const std::string& what) const {
  return {origin_ + ":" + std::to_string(lines_.number()) + ": " + what};
}

Result<void> ScenLines::read_version(std::string_view kind) {
  std::string_view first = lines_.next().value_or("");
  if (take_word(first) != "version")
    return wrong("not a " + std::string(kind) + ": the first line must be 'version 1'");
  const std::string_view version = take_word(first);
  if ((version == "1" || version == "1.0") && take_word(first).empty()) return {};
  return wrong("scenario version " + shown(version) + " is not known: only 1 is");
}

std::optional<ScenFields> ScenLines::next_problem() {
  while (const auto line = lines_.next())
    if (!line->empty()) return ScenFields(*line);
  return std::nullopt;
}

Result<void> ScenLines::read_whole(ScenFields& fields, std::string_view name, int& number) const {
  const std::string_view word = fields.next();
  const auto value = number_from<int>(word);
  if (!value || *value < 0)
    return wrong("the " + std::string(name) + " must be a whole number from 0, not " + shown(word));
  number = *value;
  return {};
}

Result<void> ScenLines::read_length(ScenFields& fields, std::string_view name, double& length,
                                    std::string& printed) const {
  printed = fields.next();
  const auto value = number_from<double>(printed);
  if (!value || !std::isfinite(*value) || *value < 0)
    return wrong("the " + std::string(name) + " must be a number from 0, not " + shown(printed));
  length = *value;
  return {};
}

Result<void> ScenLines::check_end(const ScenFields& fields, int count) const {
  if (fields.rest().empty()) return {};
  return wrong("the line goes on after its " + std::to_string(count) + " fields: " + shown(fields.rest()));
}

}  // namespace replan
