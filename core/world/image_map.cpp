#include "core/world/image_map.hpp"

#include <memory>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "core/base/file.hpp"

namespace replan {
namespace {

/// An uncompressed picture of the largest map, four bytes a pixel, and a header.
constexpr std::int64_t kMaxImageBytes = 4 * kMaxCells + 65536;

Error broken(const std::string& origin) {
  const char* reason = stbi_failure_reason();
  return {origin + ": not a picture that can be read (PNG, BMP, JPEG, PGM, PPM): " +
          (reason != nullptr ? reason : "unknown format")};
}

void append_bytes(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

Result<GridMap> decode_image_map(std::string_view bytes, const std::string& origin,
                                 const ImageMapOptions& options) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (bytes.empty()) return Error{origin + ": the file is empty"};
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) return broken(origin);
  if (width <= 0 || height <= 0) return Error{origin + ": the picture has no pixels"};
  if (std::int64_t{width} * height > kMaxCells)
    return Error{origin + ": the picture is too large: " + std::to_string(width) + " x " +
                 std::to_string(height) + " pixels, at most " + std::to_string(kMaxCells) +
                 " (8192 x 8192) are read"};
  constexpr int kGreyAndAlpha = 2;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(data, size, &width, &height, &channels, kGreyAndAlpha), &stbi_image_free);
  if (!pixels) return broken(origin);
  GridMap map(width, height);
  for (std::size_t i = 0; i < map.blocked.size(); ++i) {
    const int grey = pixels.get()[2 * i], alpha = pixels.get()[2 * i + 1];
    const int brightness = (grey * alpha + 255 * (255 - alpha) + 127) / 255;
    map.blocked[i] = (brightness < options.threshold) != options.invert ? 1 : 0;
  }
  return map;
}

Result<GridMap> read_image_map(const std::string& path, const ImageMapOptions& options) {
  const Result<std::string> bytes = read_file(path, kMaxImageBytes);
  if (!bytes) return Error{bytes.error()};
  return decode_image_map(*bytes, path, options);
}

Result<void> write_map_png(const GridMap& map, const std::string& path) {
  std::vector<unsigned char> pixels(map.blocked.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = map.blocked[i] != 0 ? 0 : 255;
  std::string bytes;
  if (stbi_write_png_to_func(append_bytes, &bytes, map.width, map.height, 1, pixels.data(), map.width) == 0)
    return Error{"cannot write '" + path + "': the picture could not be encoded"};
  return write_file_atomically(path, bytes);
}

}  // namespace replan
