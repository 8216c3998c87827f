#include "core/world/picture.hpp"

#include <memory>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "core/base/cell.hpp"
#include "core/base/file.hpp"
#include "core/base/stb.hpp"
#include "core/world/pnm.hpp"

namespace replan {
namespace {

/// The largest picture uncompressed with eight bytes a pixel, and a header.
constexpr std::int64_t kMaxPictureBytes = 8 * kMaxCells + 65536;

Error broken(const std::string& origin) {
  const char* reason = stbi_failure_reason();
  return {origin + ": not a picture that can be read (PNG, BMP, JPEG, TGA, PGM, PPM): " +
          (reason != nullptr ? reason : "unknown format")};
}

/// The largest block that an honest file of that size can need: its data, grown by doubling, or its rows with
/// eight bytes a pixel, doubled because interlaced ones carry a little more than was guessed.
std::size_t memory_for(std::size_t bytes, int width, int height) {
  constexpr std::size_t kTables = std::size_t{1} << 16;
  const auto rows = static_cast<std::size_t>(height);
  return 2 * (bytes + rows * (8 * static_cast<std::size_t>(width) + 1)) + kTables;
}

void append_bytes(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

Error too_many_pixels(const std::string& origin, std::int64_t width, std::int64_t height) {
  return {origin + ": the picture is too large: " + std::to_string(width) + " x " + std::to_string(height) +
          " pixels, at most " + std::to_string(kMaxCells) + " (8192 x 8192) are read"};
}

Result<Picture> decode_picture(std::string_view bytes, const std::string& origin) {
  if (bytes.empty()) return Error{origin + ": the file is empty"};
  if (is_pnm(bytes)) return decode_pnm(bytes, origin);
  if (bytes.size() > static_cast<std::size_t>(kMaxPictureBytes))
    return Error{origin + ": the picture has more than " + std::to_string(kMaxPictureBytes) + " bytes"};
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  Picture picture;
  if (stbi_info_from_memory(data, size, &picture.width, &picture.height, &picture.channels) == 0)
    return broken(origin);
  if (picture.width <= 0 || picture.height <= 0) return Error{origin + ": the picture has no pixels"};
  if (std::int64_t{picture.width} * picture.height > kMaxCells)
    return too_many_pixels(origin, picture.width, picture.height);
  const PictureMemory bounded(memory_for(bytes.size(), picture.width, picture.height));
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(data, size, &picture.width, &picture.height, &picture.channels, 0),
      &stbi_image_free);
  if (!pixels) return broken(origin);
  picture.values.assign(pixels.get(),
                        pixels.get() + picture.pixels() * static_cast<std::size_t>(picture.channels));
  return picture;
}

Result<Picture> read_picture(const std::string& path) {
  const Result<std::string> bytes = read_file(path, kMaxPictureBytes);
  if (!bytes) return Error{bytes.error()};
  return decode_picture(*bytes, path);
}

Result<std::string> encode_grey(const Picture& picture, std::string_view extension) {
  const int width = picture.width, height = picture.height;
  const void* values = picture.values.data();
  std::string bytes;
  int done = 0;
  if (extension == ".pgm") return pgm_text(picture);
  if (extension == ".png")
    done = stbi_write_png_to_func(append_bytes, &bytes, width, height, 1, values, width);
  if (extension == ".bmp") done = stbi_write_bmp_to_func(append_bytes, &bytes, width, height, 1, values);
  if (extension == ".tga") done = stbi_write_tga_to_func(append_bytes, &bytes, width, height, 1, values);
  if (done == 0) return Error{"the picture could not be encoded as " + std::string(extension)};
  return bytes;
}

}  // namespace replan
