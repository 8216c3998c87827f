// Fields of comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <string_view>

namespace replan {

/// The text as a field: in quotes where it has commas, quotes or line ends.
inline std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace replan
