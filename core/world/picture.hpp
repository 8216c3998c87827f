// Pictures as rows of values, whatever file they come from. Maps are made of them in image_map.hpp and
// ros_map.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace replan {

/// A decoded picture, row 0 at the top. Deeper values are scaled to 0..255.
struct Picture {
  int width = 0;
  int height = 0;
  int channels = 1;  ///< 1 grey, 2 grey and alpha, 3 red green blue, 4 with alpha
  std::vector<std::uint8_t> values;

  [[nodiscard]] bool has_alpha() const { return channels == 2 || channels == 4; }
  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// The values of one pixel.
  [[nodiscard]] const std::uint8_t* pixel(std::size_t index) const {
    return values.data() + index * static_cast<std::size_t>(channels);
  }
  friend bool operator==(const Picture&, const Picture&) = default;
};

/// Decodes a PNG, BMP, JPEG or TGA, or a PGM or PPM (see pnm.hpp). A picture of more than kMaxCells pixels is
/// refused before it is decoded, and one whose compressed data swell beyond what its pixels need while they
/// do. The error begins with `origin` and gives the reason.
Result<Picture> decode_picture(std::string_view bytes, const std::string& origin);
/// As decode_picture() from a file.
Result<Picture> read_picture(const std::string& path);

/// Encodes a grey picture for a file name's extension (.png, .bmp, .tga or .pgm); nothing else is known.
Result<std::string> encode_grey(const Picture& picture, std::string_view extension);

/// What a reader says of a picture that is too large.
Error too_many_pixels(const std::string& origin, std::int64_t width, std::int64_t height);

}  // namespace replan
