// Numbers in the sentences of studies.
#pragma once

#include <string>

namespace replan {

/// With that many decimals.
std::string told(double value, int decimals);
/// 0.123 as "+12.3 %", -0.123 as "-12.3 %".
std::string signed_percent(double share);

}  // namespace replan
