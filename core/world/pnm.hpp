// Portable grey and pixel maps (Netpbm): P2 and P5 (.pgm), P3 and P6 (.ppm), as ROS writes its maps.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/picture.hpp"

namespace replan {

/// True if the bytes begin like a PGM or PPM.
bool is_pnm(std::string_view bytes);
/// Decodes a PGM or PPM: plain (P2, P3) or raw (P5, P6), comments in the header, values up to 65535 scaled to
/// 0..255. The error names `origin`, for the header and for plain values with the line.
Result<Picture> decode_pnm(std::string_view bytes, const std::string& origin);
/// A grey picture as a raw PGM.
std::string pgm_text(const Picture& picture);

}  // namespace replan
