// Pictures as rows of values, whatever file they come from. Maps are made of them in image_map.hpp and
// ros_map.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"

namespace replan {

/// A decoded picture, row 0 at the top. Values are scaled to all that a `Value` can be.
template <class Value>
struct PictureOf {
  int width = 0;
  int height = 0;
  int channels = 1;  ///< 1 grey, 2 grey and alpha, 3 red green blue, 4 with alpha
  std::vector<Value> values;

  [[nodiscard]] bool has_alpha() const { return channels == 2 || channels == 4; }
  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// The values of one pixel.
  [[nodiscard]] const Value* pixel(std::size_t index) const {
    return values.data() + index * static_cast<std::size_t>(channels);
  }
  friend bool operator==(const PictureOf&, const PictureOf&) = default;
};
using Picture = PictureOf<std::uint8_t>;
/// For heights, of which 256 are few.
using DeepPicture = PictureOf<std::uint16_t>;

/// How a picture lies that a camera has stored on its side or head (Exif in a JPEG).
enum class Lying : std::uint8_t {
  upright,    ///< turned as its file says: as every viewer shows it
  as_stored,  ///< left as it is: as map_server takes the picture of a ROS map
};

/// Decodes a PNG, BMP, TGA or GIF (of which the first frame counts), a JPEG (see jpeg.hpp), a PBM, PGM or PPM
/// (see pnm.hpp). A picture of more than `most` pixels is refused before it is decoded, and one whose
/// compressed data swell beyond what its pixels need while they do. The error begins with `origin` and gives
/// the reason.
Result<Picture> decode_picture(std::string_view bytes, const std::string& origin,
                               std::int64_t most = kMaxCells, Lying lying = Lying::upright);
/// As decode_picture() from a file.
Result<Picture> read_picture(const std::string& path, Lying lying = Lying::upright);

/// As decode_picture() and read_picture(), with sixteen bits of those files that have them.
Result<DeepPicture> decode_deep_picture(std::string_view bytes, const std::string& origin,
                                        std::int64_t most = kMaxCells);
Result<DeepPicture> read_deep_picture(const std::string& path);

/// A picture turned and mirrored as a value of Exif's Orientation, 1 to 8, says that it has to be.
Picture turned_by_exif(Picture stored, int orientation);

/// Encodes a grey picture for a file name's extension (.png, .bmp, .tga or .pgm); nothing else is known.
Result<std::string> encode_grey(const Picture& picture, std::string_view extension);

/// What a reader says of a picture that is too large.
Error too_many_pixels(const std::string& origin, std::int64_t width, std::int64_t height, std::int64_t most);

}  // namespace replan
