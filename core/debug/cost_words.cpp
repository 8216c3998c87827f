#include "core/debug/cost_words.hpp"

#include <algorithm>
#include <cmath>

namespace replan {

std::string cost_to_fall_below(std::optional<double> best, double least) {
  constexpr double kHair = 1e-3;
  const bool can_fall = best && *best > least + kHair;
  const double wanted = can_fall ? std::max(0.9 * *best, (*best + least) / 2) : 1.1 * least;
  // Rounded up, to a number that is easy to read, but below what the path costs.
  double scale = 1;
  for (int decimals = 0; decimals < 3; ++decimals, scale *= 10) {
    const double rounded = std::ceil(wanted * scale) / scale;
    if (!can_fall || rounded < *best) return decimal_text(rounded, decimals);
  }
  return decimal_text(wanted, 4);
}

std::string saving_text(const LengthUnit& lengths, Cost saves) {
  std::string text;
  for (int decimals = 1; decimals <= 4; ++decimals) {
    text = lengths.text(saves, decimals);
    if (text.find_first_of("123456789∞") != std::string::npos) break;
  }
  return "−" + text;
}

}  // namespace replan
