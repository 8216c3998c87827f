// Portable bit, grey and pixel maps (Netpbm): P1 and P4 (.pbm), P2 and P5 (.pgm), P3 and P6 (.ppm), all of
// them .pnm; ROS writes its maps so.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/formats/picture.hpp"

namespace replan {

/// True if the bytes begin like a PBM, PGM or PPM.
bool is_pnm(std::string_view bytes);
/// Decodes a PBM, PGM or PPM: plain (P1, P2, P3; a byte order mark is passed over) or raw (P4, P5, P6),
/// comments in the header, values up to 65535 scaled to 0..255, a bit of 1 as black; at most `most` pixels.
/// The error names `origin`, for the header and for plain values with the line.
Result<Picture> decode_pnm(std::string_view bytes, const std::string& origin, std::int64_t most = kMaxCells);
/// As decode_pnm(), scaled to 0..65535.
Result<DeepPicture> decode_deep_pnm(std::string_view bytes, const std::string& origin,
                                    std::int64_t most = kMaxCells);
/// A grey picture as a raw PGM.
std::string pgm_text(const Picture& picture);

}  // namespace replan
