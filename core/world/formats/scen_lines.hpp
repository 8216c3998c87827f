// What MovingAI's two lists of problems, `.scen` and `.3dscen`, have in common: a version, then a problem a
// line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {

/// The fields of a line: parted by tabs if there is one in it, so that a field may hold blanks; else by
/// blanks.
class ScenFields {
 public:
  explicit ScenFields(std::string_view line)
      : rest_(line), tabs_(line.find('\t') != std::string_view::npos) {}

  /// The next field without blanks around it; empty at the end.
  std::string_view next();
  /// What is left after the last field, without blanks around it.
  [[nodiscard]] std::string_view rest() const;

 private:
  std::string_view rest_;
  bool tabs_;
};

/// Goes through a list of problems, keeping the place for errors.
class ScenLines {
 public:
  ScenLines(std::string_view text, std::string origin) : lines_(text), origin_(std::move(origin)) {}

  [[nodiscard]] Error wrong(const std::string& what) const;
  /// The number of the line last returned, from 1.
  [[nodiscard]] int number() const { return lines_.number(); }
  /// Takes the first line, which must be "version 1"; `kind` is what the file is, in its error.
  Result<void> read_version(std::string_view kind);
  /// The next line, an empty one too; nothing at the end of the text.
  std::optional<std::string_view> next_line() { return lines_.next(); }
  /// The fields of the next line that is not empty; nothing at the end of the text.
  std::optional<ScenFields> next_problem();

  /// Reads a whole number from 0; `name` is what the error calls it.
  Result<void> read_whole(ScenFields& fields, std::string_view name, int& number) const;
  /// Reads a length from 0, as it is printed too; `name` is what the error calls it.
  Result<void> read_length(ScenFields& fields, std::string_view name, double& length,
                           std::string& printed) const;
  /// That the line ends after `count` fields.
  [[nodiscard]] Result<void> check_end(const ScenFields& fields, int count) const;

 private:
  LineReader lines_;
  std::string origin_;
};

}  // namespace replan
