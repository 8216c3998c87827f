#include "core/world/formats/picture.hpp"

#include <cstdlib>
#include <memory>
#include <optional>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "core/base/cell.hpp"
#include "core/base/file.hpp"
#include "core/world/formats/jpeg.hpp"
#include "core/world/formats/pnm.hpp"
#include "core/world/formats/stb.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

/// The largest picture uncompressed with eight bytes a pixel, and a header.
constexpr std::int64_t kMaxPictureBytes = 8 * kMaxCells + 65536;

Error broken(const std::string& origin) {
  const char* reason = stbi_failure_reason();
  return {origin + ": not a picture that can be read (PNG, BMP, JPEG, TGA, GIF, PBM, PGM, PPM): " +
          one_line(reason != nullptr ? reason : "unknown format")};
}

/// The largest block that an honest file of that size can need: its data, grown by doubling, or its rows with
/// eight bytes a pixel, doubled because interlaced ones carry a little more than was guessed.
std::size_t memory_for(std::size_t bytes, std::int64_t width, std::int64_t height) {
  constexpr std::size_t kTables = std::size_t{1} << 16;
  const auto rows = static_cast<std::size_t>(height);
  return 2 * (bytes + rows * (8 * static_cast<std::size_t>(width) + 1)) + kTables;
}

const stbi_uc* as_bytes(std::string_view bytes) {
  return reinterpret_cast<const stbi_uc*>(bytes.data());
}

/// The sides that a picture's header gives.
struct PictureSize {
  std::int64_t width = 0, height = 0;
};

/// The size of a picture of stb_image's. A PNG's is looked up here, since stb_image gives none that it finds
/// too large itself; a BMP's height is below 0 where its first row is the top one.
std::optional<PictureSize> picture_size(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1A\n") && bytes.size() >= 24 && bytes.substr(12, 4) == "IHDR") {
    const auto side = [&](std::size_t at) {
      std::int64_t value = 0;
      for (const char c : bytes.substr(at, 4)) value = value << 8 | static_cast<unsigned char>(c);
      return value;
    };
    return PictureSize{side(16), side(20)};
  }
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(as_bytes(bytes), static_cast<int>(bytes.size()), &width, &height, &channels) == 0)
    return std::nullopt;
  return PictureSize{std::abs(std::int64_t{width}), std::abs(std::int64_t{height})};
}

std::size_t little_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  std::size_t value = 0;
  for (std::size_t i = size; i-- > 0;)
    value = value << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
  return value;
}

/// Passes over the parts of a GIF's block, each with its length before it; past the end if it has none.
std::size_t after_parts(std::string_view bytes, std::size_t at) {
  while (at < bytes.size() && bytes[at] != '\0') at += 1 + static_cast<unsigned char>(bytes[at]);
  return at + 1;
}

/// Whether a GIF ends before the data of its first frame do.
bool gif_ends_early(std::string_view bytes) {
  const auto colours = [&](std::size_t flags_at) {  // the bytes of a table
    const auto flags = static_cast<unsigned char>(bytes[flags_at]);
    return (flags & 0x80u) != 0 ? std::size_t{3} << ((flags & 7u) + 1) : 0;
  };
  if (bytes.size() < 13) return true;
  std::size_t at = 13 + colours(10);
  while (at < bytes.size() && bytes[at] == '!') at = after_parts(bytes, at + 2);
  if (at + 10 > bytes.size()) return true;
  return bytes[at] == ',' && after_parts(bytes, at + 10 + colours(at + 9) + 1) > bytes.size();
}

/// Whether a BMP ends before its last pixel.
bool bmp_ends_early(std::string_view bytes, const PictureSize& size) {
  const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
  const std::size_t depth = little_endian(bytes, little_endian(bytes, 14, 4) == 12 ? 24 : 28, 2);
  const std::size_t row = (width * depth + 31) / 32 * 4;  // padded, but for the last one
  return bytes.size() < little_endian(bytes, 10, 4) + row * (height - 1) + (width * depth + 7) / 8;
}

/// Whether a TGA ends before its last pixel.
bool tga_ends_early(std::string_view bytes, const PictureSize& size) {
  if (bytes.size() < 18) return true;
  const std::size_t kind = little_endian(bytes, 2, 1), wide = (little_endian(bytes, 16, 1) + 7) / 8;
  std::size_t at = 18 + little_endian(bytes, 0, 1);
  if (little_endian(bytes, 1, 1) != 0)  // a palette
    at += little_endian(bytes, 3, 2) + little_endian(bytes, 5, 2) * ((little_endian(bytes, 7, 1) + 7) / 8);
  const auto pixels = static_cast<std::size_t>(size.width * size.height);
  if (kind < 8) return bytes.size() < at + pixels * wide;
  for (std::size_t done = 0; done < pixels;) {  // runs, and pixels as they are
    if (at >= bytes.size()) return true;
    const std::size_t head = little_endian(bytes, at, 1), count = (head & 127u) + 1;
    at += 1 + (head > 127 ? wide : count * wide);
    done += count;
  }
  return bytes.size() < at;
}

/// Whether the file ends before its pixels do, where stb_image would make them up.
bool ends_early(std::string_view bytes, const PictureSize& size) {
  if (bytes.starts_with("\x89PNG")) return false;  // it sees that itself
  if (bytes.starts_with("GIF8")) return gif_ends_early(bytes);
  return bytes.starts_with("BM") ? bmp_ends_early(bytes, size) : tga_ends_early(bytes, size);
}

void append_bytes(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

/// Lets stb_image decode what it knows, with `load` for values of that depth.
template <class Value, class Load>
Result<PictureOf<Value>> decode_by_stb(std::string_view bytes, const std::string& origin, std::int64_t most,
                                       Load load) {
  if (bytes.size() > static_cast<std::size_t>(kMaxPictureBytes))
    return Error{origin + ": the picture has more than " + std::to_string(kMaxPictureBytes) + " bytes"};
  const auto size = picture_size(bytes);
  if (!size) return broken(origin);
  if (size->width == 0 || size->height == 0) return Error{origin + ": the picture has no pixels"};
  if (size->width > most / size->height) return too_many_pixels(origin, size->width, size->height, most);
  if (ends_early(bytes, *size)) return Error{origin + ": the file ends before the picture does"};
  const PictureMemory bounded(memory_for(bytes.size(), size->width, size->height));
  PictureOf<Value> picture;
  const std::unique_ptr<Value, decltype(&stbi_image_free)> pixels(
      load(as_bytes(bytes), static_cast<int>(bytes.size()), &picture.width, &picture.height,
           &picture.channels, 0),
      &stbi_image_free);
  if (!pixels) return broken(origin);
  picture.values.assign(pixels.get(),
                        pixels.get() + picture.pixels() * static_cast<std::size_t>(picture.channels));
  return picture;
}

DeepPicture deepened(const Picture& picture) {
  DeepPicture deep{picture.width, picture.height, picture.channels, {}};
  deep.values.reserve(picture.values.size());
  for (const std::uint8_t value : picture.values)
    deep.values.push_back(static_cast<std::uint16_t>(value * 257));
  return deep;
}

}  // namespace

Error too_many_pixels(const std::string& origin, std::int64_t width, std::int64_t height, std::int64_t most) {
  return {origin + ": the picture is too large: " + std::to_string(width) + " x " + std::to_string(height) +
          " pixels, at most " + std::to_string(most) + (most == kMaxCells ? " (8192 x 8192)" : "") +
          " are read"};
}

Picture turned_by_exif(Picture stored, int orientation) {
  if (orientation < 2 || orientation > 8) return stored;
  const bool swapped = orientation >= 5;
  Picture turned{
      swapped ? stored.height : stored.width, swapped ? stored.width : stored.height, stored.channels, {}};
  turned.values.reserve(stored.values.size());
  const auto is_one_of = [&](std::string_view values) {
    return values.find(static_cast<char>('0' + orientation)) != std::string_view::npos;
  };
  // Whether the stored columns and rows run the other way, once the sides are swapped where they have to be.
  const bool from_right = is_one_of("2378"), from_bottom = is_one_of("3467");
  for (int y = 0; y < turned.height; ++y)
    for (int x = 0; x < turned.width; ++x) {
      const int column = swapped ? y : x, row = swapped ? x : y;
      const int from_x = from_right ? stored.width - 1 - column : column;
      const int from_y = from_bottom ? stored.height - 1 - row : row;
      const std::uint8_t* pixel =
          stored.pixel(static_cast<std::size_t>(from_y) * static_cast<std::size_t>(stored.width) +
                       static_cast<std::size_t>(from_x));
      turned.values.insert(turned.values.end(), pixel, pixel + stored.channels);
    }
  return turned;
}

Result<Picture> decode_picture(std::string_view bytes, const std::string& origin, std::int64_t most,
                               Lying lying) {
  if (bytes.empty()) return Error{origin + ": the file is empty"};
  if (is_pnm(bytes)) return decode_pnm(bytes, origin, most);
  if (is_jpeg(bytes)) return decode_jpeg(bytes, origin, most, lying);
  return decode_by_stb<std::uint8_t>(bytes, origin, most, stbi_load_from_memory);
}

Result<DeepPicture> decode_deep_picture(std::string_view bytes, const std::string& origin,
                                        std::int64_t most) {
  if (bytes.empty()) return Error{origin + ": the file is empty"};
  if (is_pnm(bytes)) return decode_deep_pnm(bytes, origin, most);
  if (is_jpeg(bytes)) {
    const Result<Picture> picture = decode_jpeg(bytes, origin, most, Lying::upright);
    if (!picture) return Error{picture.error()};
    return deepened(*picture);
  }
  return decode_by_stb<std::uint16_t>(bytes, origin, most, stbi_load_16_from_memory);
}

Result<DeepPicture> read_deep_picture(const std::string& path) {
  const Result<std::string> bytes = read_file(path, kMaxPictureBytes);
  if (!bytes) return Error{bytes.error()};
  return decode_deep_picture(*bytes, path);
}

Result<Picture> read_picture(const std::string& path, Lying lying) {
  const Result<std::string> bytes = read_file(path, kMaxPictureBytes);
  if (!bytes) return Error{bytes.error()};
  return decode_picture(*bytes, path, kMaxCells, lying);
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
