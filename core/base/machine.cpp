#include "core/base/machine.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "core/base/threads.hpp"

namespace replan {
namespace {

/// As Linux names it; "an unnamed processor" elsewhere.
std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  constexpr std::string_view kName = "model name";
  for (std::string line; std::getline(in, line);)
    if (const std::size_t colon = line.find(": "); line.starts_with(kName) && colon != std::string::npos)
      return line.substr(colon + 2);
  return "an unnamed processor";
}

}  // namespace

std::string machine_sentence() {
  const std::size_t count = processor_count();
  std::string text = "They were taken on " + processor_name() + ", " + std::to_string(count) +
                     (count == 1 ? " processor." : " processors.");
  std::array<double, 1> load{};
  if (::getloadavg(load.data(), 1) != 1 || load[0] < 0.5 * static_cast<double>(count)) return text;
  std::array<char, 16> number{};
  std::snprintf(number.data(), number.size(), "%.1f", load[0]);
  return text + " Other work kept it busy (a load of " + number.data() + " as the study began).";
}

}  // namespace replan
