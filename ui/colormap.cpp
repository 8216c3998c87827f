#include "ui/colormap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
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

// Every 17th entry of the published table.
constexpr std::array<Rgb, 16> kCividisStops = {{
    {0.0000f, 0.1351f, 0.3048f},
    {0.0000f, 0.1816f, 0.4219f},
    {0.1176f, 0.2259f, 0.4343f},
    {0.2089f, 0.2725f, 0.4248f},
    {0.2794f, 0.3187f, 0.4230f},
    {0.3422f, 0.3649f, 0.4286f},
    {0.4014f, 0.4118f, 0.4407f},
    {0.4584f, 0.4596f, 0.4605f},
    {0.5179f, 0.5085f, 0.4727f},
    {0.5821f, 0.5587f, 0.4681f},
    {0.6482f, 0.6106f, 0.4548f},
    {0.7162f, 0.6644f, 0.4324f},
    {0.7860f, 0.7204f, 0.3996f},
    {0.8578f, 0.7790f, 0.3533f},
    {0.9322f, 0.8402f, 0.2859f},
    {0.9957f, 0.9093f, 0.2178f},
}};

constexpr std::array<Rgb, 3> kGreyStops = {{{0, 0, 0}, {0.5f, 0.5f, 0.5f}, {1, 1, 1}}};

constexpr FieldColoursInfo kInfos[] = {
    {FieldColours::viridis, "viridis", "Viridis",
     "From violet over green to yellow: many steps can be told apart, also by people who see red and green alike."},
    {FieldColours::cividis, "cividis", "Cividis",
     "From blue to yellow: looks nearly the same to those who tell red from green and those who do not."},
    {FieldColours::grey, "grey", "Grey",
     "From dark to light: for print, and so that only the marks have a colour."}};

/// The part of a map that is used, 0 to 1: what begins or ends in the colour of the ground or of obstacles is cut off.
struct Stretch {
  float begin, end;
};
Stretch stretch_of(const Theme& theme, FieldColours colours) {
  switch (colours) {
    case FieldColours::viridis:
      return theme.is_dark ? Stretch{0.3f, 1} : Stretch{0, 1};
    case FieldColours::cividis:
      return theme.is_dark ? Stretch{0.52f, 1} : Stretch{0, 1};
    case FieldColours::grey:
      break;
  }
  return theme.is_dark ? Stretch{0.56f, 1} : Stretch{0, 0.76f};
}

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

std::span<const FieldColoursInfo> all_field_colours() {
  return kInfos;
}

const FieldColoursInfo& info_of(FieldColours colours) {
  return kInfos[static_cast<std::size_t>(colours)];
}

std::optional<FieldColours> field_colours_named(std::string_view id) {
  for (const FieldColoursInfo& info : kInfos)
    if (info.id == id) return info.colours;
  return std::nullopt;
}

const Colormap& published(FieldColours colours) {
  static const std::array<Colormap, std::size(kInfos)> maps = {tabulate(kViridisStops),
                                                               tabulate(kCividisStops), tabulate(kGreyStops)};
  return maps[static_cast<std::size_t>(colours)];
}

Colormap field_colours(const Theme& theme, FieldColours colours) {
  Colormap map{};
  const Stretch part = stretch_of(theme, colours);
  for (std::size_t i = 0; i < map.size(); ++i)
    map[i] =
        sample(published(colours), part.begin + (part.end - part.begin) * static_cast<float>(i) / 255.0f);
  return map;
}

Colormap field_colours_over_free(const Theme& theme, FieldColours colours) {
  Colormap map = field_colours(theme, colours);
  for (ImU32& colour : map) colour = over_free(theme, colour);
  return map;
}

ImU32 sample(const Colormap& map, float t) {
  // Written so that a NaN lands on the lowest colour instead of outside the table.
  const float clamped = t > 0.0f ? std::min(t, 1.0f) : 0.0f;
  return map[static_cast<std::size_t>(clamped * 255.0f + 0.5f)];
}

}  // namespace replan::ui
