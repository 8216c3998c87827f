// What a link may hold. Only for its reader and its writer, which refuse the same, so that what was written can be read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace replan {

inline constexpr int kLinkVersion = 1;
/// Bytes of the world's text, and the values in it: each takes some fifty bytes once it is read.
inline constexpr std::size_t kMostWorldBytes = std::size_t{1} << 25, kMostWorldValues = 2'000'000;
/// A link without its world is no longer than that.
inline constexpr std::size_t kMostLinkWords = 100'000;

/// About how many values a JSON text has: no fewer than there are.
inline std::size_t json_values_at_most(std::string_view text) {
  const auto begins_one = [](char c) { return c == ',' || c == '[' || c == '{'; };
  return 1 + static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_one));
}

}  // namespace replan
