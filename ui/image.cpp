#include "ui/image.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <string>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "core/base/file.hpp"

namespace replan::ui {
namespace {

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* first = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

/// Flat colours and letters compress as well without filters, and in half the time.
bool choose_fast_png() {
  stbi_write_force_png_filter = 0;
  stbi_write_png_compression_level = 5;
  return true;
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_png(const Image& image) {
  [[maybe_unused]] static const bool kChosen = choose_fast_png();  // once, whichever thread comes first
  std::vector<std::uint8_t> bytes;
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(),
                             image.width * 4) == 0) {
    return Error{"The picture could not be encoded as PNG: out of memory, or it is empty."};
  }
  return bytes;
}

Result<void> write_png(const std::filesystem::path& path, const Image& image) {
  const Result<std::vector<std::uint8_t>> bytes = encode_png(image);
  if (!bytes) return Error{bytes.error()};
  return write_file_atomically(path.string(), {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

Result<Image> read_image(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{"Cannot open " + path.string() + ": " + std::strerror(errno) + "."};
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file), {}};
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &image.width, &image.height,
                            &channels, 4),
      stbi_image_free);
  if (!pixels)
    return Error{path.string() + " is not a picture that can be read (" + stbi_failure_reason() + ")."};
  const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
  image.rgba.assign(pixels.get(), pixels.get() + count);
  return image;
}

Difference compare(const Image& a, const Image& b, int tolerance) {
  Difference difference;
  if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size()) return difference;
  difference = {.same_size = true, .max = 0, .mean = 0, .share = 0};
  if (a.rgba.empty()) return difference;
  std::uint64_t sum = 0;
  std::uint64_t apart = 0;
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    int worst = 0;
    for (std::size_t i = pixel; i < pixel + 4; ++i) {
      const int d = std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
      sum += static_cast<std::uint64_t>(d);
      worst = std::max(worst, d);
    }
    difference.max = std::max(difference.max, worst);
    apart += worst > tolerance ? 1 : 0;
  }
  difference.mean = static_cast<double>(sum) / static_cast<double>(a.rgba.size());
  difference.share = static_cast<double>(apart) / (static_cast<double>(a.rgba.size()) / 4);
  return difference;
}

}  // namespace replan::ui
