#include "core/plan/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/real_text.hpp"
#include "core/base/words.hpp"

namespace replan {

double Settings::get(const Parameter& parameter) const {
  return get(parameter.key, parameter.initial);
}

double Settings::get(std::string_view key, double fallback) const {
  const auto found = values_.find(key);
  return found == values_.end() ? fallback : found->second;
}

const Parameter* find_parameter(std::span<const Parameter> parameters, std::string_view key) {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.key == key; });
  return found == parameters.end() ? nullptr : &*found;
}

namespace {

std::string allowed(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::toggle:
      return "true or false";
    case ParameterType::choice:
      return "one of: " + joined(parameter.choices);
    case ParameterType::whole:
    case ParameterType::real:
      break;
  }
  return std::string(parameter.type == ParameterType::whole ? "a whole number" : "a number") + " from " +
         real_text(parameter.low) + " to " + real_text(parameter.high) +
         (parameter.unit.empty() ? "" : " " + std::string(parameter.unit));
}

Error bad_value(const Parameter& parameter, std::string_view text) {
  return {"'" + std::string(parameter.key) + "' cannot be '" + std::string(text) + "': give " +
          allowed(parameter)};
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

Result<double> parse_value(const Parameter& parameter, std::string_view text) {
  if (parameter.type == ParameterType::choice) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    if (found == parameter.choices.end()) return bad_value(parameter, text);
    return static_cast<double>(found - parameter.choices.begin());
  }
  if (parameter.type == ParameterType::toggle) {
    if (text == "true" || text == "on" || text == "1") return 1.0;
    if (text == "false" || text == "off" || text == "0") return 0.0;
    return bad_value(parameter, text);
  }
  const auto value = real_from(text);
  const bool fits = value && std::isfinite(*value) && *value >= parameter.low && *value <= parameter.high &&
                    (parameter.type == ParameterType::real || *value == std::floor(*value));
  if (!fits) return bad_value(parameter, text);
  return *value;
}

std::string format_value(const Parameter& parameter, double value) {
  if (parameter.type == ParameterType::toggle) return value != 0 ? "true" : "false";
  if (parameter.type == ParameterType::choice)
    return std::string(parameter.choices.at(static_cast<std::size_t>(value)));
  return real_text(value);
}

Result<void> set_from_text(Settings& settings, std::span<const Parameter> parameters, std::string_view key,
                           std::string_view text) {
  const Parameter* parameter = find_parameter(parameters, key);
  if (parameter == nullptr) {
    std::vector<std::string_view> keys;
    for (const Parameter& known : parameters) keys.push_back(known.key);
    const std::string_view nearest = nearest_name(key, keys);
    std::string list;
    for (const std::string_view known : keys) list += (list.empty() ? "" : ", ") + std::string(known);
    return Error{"unknown setting '" + std::string(key) + "'" +
                 (nearest.empty() ? "; known: " + list : "; did you mean '" + std::string(nearest) + "'?")};
  }
  Result<double> value = parse_value(*parameter, text);
  if (!value) return Error{value.error()};
  settings.set(key, *value);
  return {};
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names) {
  std::string_view best;
  std::size_t best_distance = 4;
  for (const std::string_view candidate : names) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace replan
