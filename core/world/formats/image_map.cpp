#include "core/world/formats/image_map.hpp"

#include <cstdint>
#include <limits>

#include "core/base/file.hpp"

namespace replan {
namespace {

/// How bright a pixel is, from 0 to the largest value, on a white ground.
template <class Value>
std::int64_t brightness(const PictureOf<Value>& picture, const Value* pixel) {
  constexpr std::int64_t kWhite = std::numeric_limits<Value>::max();
  // The weights of red, green and blue in 1/256, as stb_image has them.
  const std::int64_t grey =
      picture.channels < 3 ? pixel[0] : (77 * pixel[0] + 150 * pixel[1] + 29 * pixel[2]) / 256;
  const std::int64_t alpha = picture.has_alpha() ? pixel[picture.channels - 1] : kWhite;
  return (grey * alpha + kWhite * (kWhite - alpha) + kWhite / 2) / kWhite;
}

}  // namespace

GridMap image_cells(const Picture& picture, const ImageMapOptions& options) {
  GridMap map(picture.width, picture.height);
  for (std::size_t i = 0; i < map.blocked.size(); ++i)
    if ((brightness(picture, picture.pixel(i)) < options.threshold) != options.invert)
      map.blocked[i] = kObstacle;
  return map;
}

HeightGrid image_heights(const DeepPicture& picture, bool invert) {
  constexpr std::int64_t kWhite = 65535;
  constexpr float kShade = 257;  // of sixteen bits that are one of eight
  HeightGrid grid{picture.width, picture.height, {}};
  grid.heights.reserve(picture.pixels());
  for (std::size_t i = 0; i < picture.pixels(); ++i) {
    const std::int64_t bright = brightness(picture, picture.pixel(i));
    grid.heights.push_back(static_cast<float>(invert ? kWhite - bright : bright) / kShade);
  }
  return grid;
}

Result<MapFile> read_height_picture(const std::string& path, const HeightReading& reading, bool invert) {
  const Result<DeepPicture> picture = read_deep_picture(path);
  if (!picture) return Error{picture.error()};
  return world_over(image_heights(*picture, invert), reading, path);
}

Result<GridMap> decode_image_map(std::string_view bytes, const std::string& origin,
                                 const ImageMapOptions& options) {
  const Result<Picture> picture = decode_picture(bytes, origin);
  if (!picture) return Error{picture.error()};
  return image_cells(*picture, options);
}

Result<GridMap> read_image_map(const std::string& path, const ImageMapOptions& options) {
  const Result<Picture> picture = read_picture(path);
  if (!picture) return Error{picture.error()};
  return image_cells(*picture, options);
}

Result<void> write_image_map(const GridMap& map, const std::string& path) {
  Picture picture{map.width, map.height, 1, std::vector<std::uint8_t>(map.blocked.size())};
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = map.blocked[i] != kFree ? 0 : 255;
  const Result<std::string> bytes = encode_grey(picture, file_extension(path));
  if (!bytes) return Error{"cannot write '" + path + "': " + bytes.error()};
  return write_file_atomically(path, *bytes);
}

}  // namespace replan
