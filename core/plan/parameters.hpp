// Parameters that a planner, a robot or a generator declares once: one declaration feeds the window, the
// command line, scenario files and the documentation.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace replan {

/// What a parameter may hold.
enum class ParameterType : unsigned char { choice, real, whole, toggle };

/// One declared parameter.
struct Parameter {
  std::string_view key;    ///< as in `--set key=value` and scenario files
  std::string_view label;  ///< as in the window
  ParameterType type = ParameterType::real;
  double initial = 0;  ///< default; for a choice the index of the default one
  double low = 0;      ///< smallest value (numbers)
  double high = 1;     ///< largest value (numbers)
  std::string_view unit = {};
  std::vector<std::string_view> choices = {};
  std::string_view help = {};  ///< one or two sentences for tooltip and `--help`
  /// What a window calls the choices in a world of layers, where that is something else.
  std::vector<std::string_view> choices_in_space = {};
};

/// Values of parameters by key, held as numbers (choice: index; toggle: 0 or 1). What is not set has its
/// default.
class Settings {
 public:
  /// The value, or the parameter's default.
  [[nodiscard]] double get(const Parameter& parameter) const;
  /// The value under `key`, or `fallback`.
  [[nodiscard]] double get(std::string_view key, double fallback) const;
  [[nodiscard]] bool has(std::string_view key) const { return values_.contains(key); }
  void set(std::string_view key, double value) { values_.insert_or_assign(std::string(key), value); }
  void reset(std::string_view key) { values_.erase(std::string(key)); }
  [[nodiscard]] const std::map<std::string, double, std::less<>>& values() const { return values_; }
  friend bool operator==(const Settings&, const Settings&) = default;

 private:
  std::map<std::string, double, std::less<>> values_;
};

/// The parameter of that key, or nullptr.
const Parameter* find_parameter(std::span<const Parameter> parameters, std::string_view key);
/// Reads a value as typed by a user: a choice's name, a number in range, true/false. The error names the
/// range.
Result<double> parse_value(const Parameter& parameter, std::string_view text);
/// The value as text: what parse_value() reads back.
std::string format_value(const Parameter& parameter, double value);
/// Sets `key` from text; the error for an unknown key suggests the nearest known one.
Result<void> set_from_text(Settings& settings, std::span<const Parameter> parameters, std::string_view key,
                           std::string_view text);
/// Of `names` the one that `name` was probably meant to be (smallest edit distance, at most 3), or empty.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names);

}  // namespace replan
