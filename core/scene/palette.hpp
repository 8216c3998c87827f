// The colours of a scene. The window makes them from its theme; core knows no themes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace replan {

/// Bytes R, G, B, A from the lowest up.
using Colour = std::uint32_t;

struct Palette {
  Colour background = 0;  ///< of the window
  Colour surround = 0;    ///< around the world
  Colour free = 0;
  Colour obstacle = 0;
  Colour surprise = 0;
  Colour mover = 0;  ///< ways of moving obstacles
  Colour grid = 0;   ///< translucent
  Colour arrow = 0;  ///< translucent
  Colour path = 0;
  Colour accent = 0;
  Colour start = 0;
  Colour goal = 0;
  Colour robot = 0;
  Colour warning = 0;
  Colour bad = 0;
  Colour good = 0;
  Colour text = 0;
  Colour dim = 0;
  Colour outline = 0;  ///< around start, goal and robot
  Colour rhs = 0;      ///< the number rhs, beside g in the colour of text
  Colour unseen = 0;   ///< what a map calls unknown and counts as blocked
  std::array<Colour, 256> field{};
  float field_opacity = 0.55f;
};

/// a at t = 0, b at t = 1, alpha too.
inline Colour mix(Colour a, Colour b, float t) {
  Colour mixed = 0;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    const auto x = static_cast<float>(a >> shift & 255u), y = static_cast<float>(b >> shift & 255u);
    mixed |= static_cast<Colour>(std::lround(x + (y - x) * t)) << shift;
  }
  return mixed;
}

/// The colour with its opacity multiplied.
inline Colour faded(Colour colour, double opacity) {
  const double alpha = static_cast<double>(colour >> 24) * std::clamp(opacity, 0.0, 1.0);
  return (colour & 0xFFFFFFu) | static_cast<Colour>(std::lround(alpha)) << 24;
}

/// The ratio of the luminances of two opaque colours after WCAG 2, 1 to 21: from 4.5 on words can be read by everybody.
inline double contrast(Colour a, Colour b) {
  const auto luminance = [](Colour colour) {
    const auto linear = [colour](unsigned shift) {
      const double v = static_cast<double>(colour >> shift & 255u) / 255;
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(0) + 0.7152 * linear(8) + 0.0722 * linear(16);
  };
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

}  // namespace replan
