// How planners of the same kind are told apart that stand side by side.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace replan {

/// "dstar-lite" of the first and "dstar-lite#2" of the second one of that name: in tables, files and `--set` alike.
inline std::string nth_name(std::string_view name, std::size_t nth) {
  return std::string(name) + (nth > 1 ? "#" + std::to_string(nth) : "");
}

/// Each of the names, told apart from those before it.
inline std::vector<std::string> told_apart(const std::vector<std::string>& names) {
  std::vector<std::string> apart;
  for (auto name = names.begin(); name != names.end(); ++name) {
    const auto before = std::count(names.begin(), name, *name);
    apart.push_back(nth_name(*name, static_cast<std::size_t>(before) + 1));
  }
  return apart;
}

}  // namespace replan
