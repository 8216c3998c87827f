// Bytes made smaller, by zlib, and made whole again within a limit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace replan {

/// As a zlib stream (RFC 1950), as small as it gets.
std::string deflated(std::string_view bytes);
/// The bytes of a zlib stream. A few of its bytes can stand for a thousand times as many, so they are counted before
/// memory is taken for them: more than `most` are an error, and so is a stream that is damaged, cut off, or followed by
/// something else. The error says what is the matter, to be put after the name of what was read.
Result<std::string> inflated(std::string_view stream, std::size_t most);

}  // namespace replan
