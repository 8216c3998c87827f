// JPEG pictures, by libjpeg. Not by stb_image, whose decoder writes past the end of a table in a broken file.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/formats/picture.hpp"

namespace replan {

/// True if the bytes begin like a JPEG.
bool is_jpeg(std::string_view bytes);
/// Decodes a grey or coloured JPEG of at most `most` pixels, which is checked before it is decoded. A file
/// that ends early is an error, as is one with more passes over its pixels than any camera makes. The error
/// begins with `origin`.
Result<Picture> decode_jpeg(std::string_view bytes, const std::string& origin, std::int64_t most,
                            Lying lying = Lying::upright);
/// The Orientation, 1 to 8, in the Exif data of a JPEG ("Exif", two zeros, TIFF); 1 (upright) where there is
/// none that makes sense.
int exif_orientation(std::string_view exif);

}  // namespace replan
