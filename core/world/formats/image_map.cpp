#include "core/world/formats/image_map.hpp"

#include "core/base/file.hpp"

namespace replan {
namespace {

/// How bright a pixel is, 0..255, on a white ground.
int brightness(const Picture& picture, const std::uint8_t* pixel) {
  // The weights of red, green and blue in 1/256, as stb_image has them.
  const int grey = picture.channels < 3 ? pixel[0] : (77 * pixel[0] + 150 * pixel[1] + 29 * pixel[2]) / 256;
  const int alpha = picture.has_alpha() ? pixel[picture.channels - 1] : 255;
  return (grey * alpha + 255 * (255 - alpha) + 127) / 255;
}

}  // namespace

GridMap image_cells(const Picture& picture, const ImageMapOptions& options) {
  GridMap map(picture.width, picture.height);
  for (std::size_t i = 0; i < map.blocked.size(); ++i)
    if ((brightness(picture, picture.pixel(i)) < options.threshold) != options.invert)
      map.blocked[i] = kObstacle;
  return map;
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
