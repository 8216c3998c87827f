// Pictures in memory: frames of the window, golden images, map pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.hpp"

namespace replan::ui {

/// RGBA, 8 bits each, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  [[nodiscard]] const std::uint8_t* at(int x, int y) const {
    return rgba.data() +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 4;
  }
};

Result<std::vector<std::uint8_t>> encode_png(const Image& image);
/// Written beside, flushed and renamed: a failure leaves the old file whole.
Result<void> write_png(const std::filesystem::path& path, const Image& image);
Result<Image> read_image(const std::filesystem::path& path);

/// How far two pictures are apart, over all bytes.
struct Difference {
  bool same_size = false;
  int max = 255;      ///< the largest difference of any channel
  double mean = 255;  ///< the mean difference of all channels
  double share = 1;   ///< the share of pixels that differ by more than the tolerance
};
Difference compare(const Image& a, const Image& b, int tolerance = 0);

}  // namespace replan::ui
