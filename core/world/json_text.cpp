#include <cmath>

#include "core/world/json_reader.hpp"

namespace replan {
namespace {

constexpr std::size_t kColumns = 100;

std::string scalar(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The value on one line, or as much of it as shows that it is longer than `room`.
std::string flat(const Json& value, std::size_t room) {
  if (!value.is_structured()) return scalar(value);
  std::string text = value.is_object() ? "{" : "[";
  for (auto child = value.begin(); child != value.end() && text.size() <= room; ++child) {
    if (child != value.begin()) text += ", ";
    if (value.is_object()) text += scalar(child.key()) + ": ";
    text += flat(*child, room);
  }
  return text + (value.is_object() ? "}" : "]");
}

void append(std::string& text, const Json& value, std::size_t indent) {
  const std::size_t room = kColumns - std::min(indent, kColumns / 2);
  const std::string line = flat(value, room);
  if (indent > 0 && (line.size() <= room || !value.is_structured())) {
    text += line;
    return;
  }
  const std::string margin(indent + 2, ' ');
  text += value.is_object() ? "{" : "[";
  for (auto child = value.begin(); child != value.end(); ++child) {
    text += (child == value.begin() ? "\n" : ",\n") + margin;
    if (value.is_object()) text += scalar(child.key()) + ": ";
    append(text, *child, indent + 2);
  }
  text += "\n" + std::string(indent, ' ') + (value.is_object() ? "}" : "]");
}

}  // namespace

std::string pretty_json(const Json& document) {
  std::string text;
  append(text, document, 0);
  return text + "\n";
}

Json plain_number(double value) {
  if (value == std::floor(value) && std::abs(value) < 0x1p53) return static_cast<std::int64_t>(value);
  return value;
}

}  // namespace replan
