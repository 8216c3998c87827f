// Costs as the debugger's sentences spell them.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "core/base/cost.hpp"

namespace replan {

/// "43.799", in cells; "infinite".
inline std::string cost_text(Cost cost) {
  if (cost.is_infinite()) return "infinite";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", cost.to_double());
  return text.data();
}

}  // namespace replan
