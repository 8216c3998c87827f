// Numbers in the sentences of studies.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace replan {

/// With that many decimals.
std::string told(double value, int decimals);
/// 0.123 as "+12.3 %", -0.123 as "-12.3 %".
std::string signed_percent(double share);
/// The sentence with the values in its places: the first for {1}, the second for {2} ...
std::string filled(std::string_view sentence, std::initializer_list<std::string> values);

}  // namespace replan
