#include "core/study/study_words.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace replan {

std::string told(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string signed_percent(double share) {
  return (share < 0 ? "-" : "+") + told(100 * std::abs(share), 1) + " %";
}

std::string filled(std::string_view sentence, std::initializer_list<std::string> values) {
  std::string text(sentence);
  std::size_t number = 0;
  for (const std::string& value : values) {
    const std::string place = "{" + std::to_string(++number) + "}";
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + value.size()))
      text.replace(at, place.size(), value);
  }
  return text;
}

}  // namespace replan
