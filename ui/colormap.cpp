#include "ui/colormap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace replan::ui {
namespace {

struct Rgb {
  float r, g, b;
};

// Every 15th entry of the published table; Catmull-Rom between them restores the rest.
constexpr std::array<Rgb, 18> kViridisStops = {{
    {0.2670f, 0.0049f, 0.3294f},
    {0.2819f, 0.0897f, 0.4124f},
    {0.2803f, 0.1657f, 0.4765f},
    {0.2637f, 0.2376f, 0.5188f},
    {0.2374f, 0.3052f, 0.5419f},
    {0.2086f, 0.3678f, 0.5527f},
    {0.1823f, 0.4262f, 0.5571f},
    {0.1592f, 0.4822f, 0.5581f},
    {0.1378f, 0.5375f, 0.5549f},
    {0.1211f, 0.5927f, 0.5446f},
    {0.1281f, 0.6477f, 0.5235f},
    {0.1807f, 0.7014f, 0.4882f},
    {0.2741f, 0.7520f, 0.4366f},
    {0.3952f, 0.7975f, 0.3678f},
    {0.5356f, 0.8358f, 0.2819f},
    {0.6889f, 0.8654f, 0.1827f},
    {0.8456f, 0.8873f, 0.0997f},
    {0.9932f, 0.9062f, 0.1439f},
}};

float catmull_rom(float a, float b, float c, float d, float t) {
  return 0.5f *
         (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t * t * t);
}

ImU32 pack(Rgb colour) {
  const auto byte = [](float v) {
    return static_cast<ImU32>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255.0f));
  };
  return IM_COL32(byte(colour.r), byte(colour.g), byte(colour.b), 255u);
}

/// The stop beyond the end, so that the curve keeps bending there as it did before.
Rgb beyond(Rgb end, Rgb next, Rgb third) {
  return {3 * (end.r - next.r) + third.r, 3 * (end.g - next.g) + third.g, 3 * (end.b - next.b) + third.b};
}

Rgb interpolate(std::span<const Rgb> stops, float t) {
  const float position = t * static_cast<float>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  const float f = position - static_cast<float>(i);
  const Rgb b = stops[i];
  const Rgb c = stops[i + 1];
  const Rgb a = i > 0 ? stops[i - 1] : beyond(b, c, stops[2]);
  const Rgb d = i + 2 < stops.size() ? stops[i + 2] : beyond(c, b, stops[i - 1]);
  return {catmull_rom(a.r, b.r, c.r, d.r, f), catmull_rom(a.g, b.g, c.g, d.g, f),
          catmull_rom(a.b, b.b, c.b, d.b, f)};
}

Colormap tabulate(std::span<const Rgb> stops) {
  Colormap map{};
  for (std::size_t i = 0; i < map.size(); ++i)
    map[i] = pack(interpolate(stops, static_cast<float>(i) / 255.0f));
  return map;
}

}  // namespace

const Colormap& viridis() {
  static const Colormap map = tabulate(kViridisStops);
  return map;
}

Colormap field_colours(const Theme& theme) {
  Colormap map{};
  for (std::size_t i = 0; i < map.size(); ++i)
    map[i] = sample(viridis(), theme.field_begin + (1 - theme.field_begin) * static_cast<float>(i) / 255.0f);
  return map;
}

Colormap field_colours_over_free(const Theme& theme) {
  Colormap map = field_colours(theme);
  for (ImU32& colour : map) colour = over_free(theme, colour);
  return map;
}

ImU32 sample(const Colormap& map, float t) {
  // Written so that a NaN lands on the lowest colour instead of outside the table.
  const float clamped = t > 0.0f ? std::min(t, 1.0f) : 0.0f;
  return map[static_cast<std::size_t>(clamped * 255.0f + 0.5f)];
}

}  // namespace replan::ui
