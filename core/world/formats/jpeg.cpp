#include "core/world/formats/jpeg.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <utility>

#include <jpeglib.h>
// After jpeglib.h, which it builds on.
#include <jerror.h>

#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

/// Passes over the pixels of one progressive file; a small one can ask for very many.
constexpr int kMostScans = 500;

/// libjpeg reports errors by a jump out of its depths; here they come to rest.
struct Decoder {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf back{};
  char message[JMSG_LENGTH_MAX] = {};

  Decoder();
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { jpeg_destroy_decompress(&info); }
};

[[noreturn]] void jump_back(j_common_ptr info) {
  auto* decoder = static_cast<Decoder*>(info->client_data);
  info->err->format_message(info, decoder->message);
  std::longjmp(decoder->back, 1);
}

/// libjpeg only warns where the data end early and fills up with grey; a map must not be made up.
void hear_warning(j_common_ptr info, int level) {
  if (level < 0 && (info->err->msg_code == JWRN_JPEG_EOF || info->err->msg_code == JWRN_HIT_MARKER))
    jump_back(info);
}

void count_scans(j_common_ptr info) {
  auto* decoder = static_cast<Decoder*>(info->client_data);
  if (decoder->info.input_scan_number <= kMostScans) return;
  std::snprintf(decoder->message, sizeof decoder->message, "it has more than %d scans", kMostScans);
  std::longjmp(decoder->back, 1);
}

Decoder::Decoder() {
  info.err = jpeg_std_error(&errors);
  info.client_data = this;
  errors.error_exit = jump_back;
  errors.emit_message = hear_warning;
  progress.progress_monitor = count_scans;
}

// Between setjmp and the jump there must be no object with a destructor: these two functions have none.

bool read_header(Decoder& decoder, std::string_view bytes) {
  if (setjmp(decoder.back) != 0) return false;
  jpeg_decompress_struct& info = decoder.info;
  jpeg_create_decompress(&info);
  info.progress = &decoder.progress;
  jpeg_save_markers(&info, JPEG_APP0 + 1, 0xFFFF);  // where the Exif data are
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  info.out_color_space = info.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
  return true;
}

bool read_rows(Decoder& decoder, std::uint8_t* values, std::size_t stride) {
  if (setjmp(decoder.back) != 0) return false;
  jpeg_decompress_struct& info = decoder.info;
  jpeg_start_decompress(&info);
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = values + info.output_scanline * stride;
    jpeg_read_scanlines(&info, &row, 1);
  }
  jpeg_finish_decompress(&info);
  return true;
}

Error broken(const std::string& origin, const Decoder& decoder) {
  return {origin + ": not a picture that can be read (JPEG): " + one_line(decoder.message)};
}

/// A file's own orientation.
int orientation_of(const jpeg_decompress_struct& info) {
  for (const auto* marker = info.marker_list; marker != nullptr; marker = marker->next) {
    const std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (data.starts_with("Exif")) return exif_orientation(data);
  }
  return 1;
}

}  // namespace

int exif_orientation(std::string_view exif) {
  constexpr std::size_t kTiff = 6, kEntry = 12, kOrientation = 0x0112, kShort = 3;
  const std::string_view tiff = exif.substr(std::min(kTiff, exif.size()));
  const bool little = tiff.starts_with("II");
  if (!little && !tiff.starts_with("MM")) return 1;
  const auto number = [&](std::size_t at, std::size_t size) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t from = at + (little ? size - 1 - i : i);
      value = value << 8 | (from < tiff.size() ? static_cast<unsigned char>(tiff[from]) : 0u);
    }
    return value;
  };
  const std::size_t directory = number(4, 4), count = number(directory, 2);
  for (std::size_t i = 0; i < count && directory + 2 + (i + 1) * kEntry <= tiff.size(); ++i) {
    const std::size_t entry = directory + 2 + i * kEntry;
    if (number(entry, 2) != kOrientation || number(entry + 2, 2) != kShort) continue;
    const std::size_t orientation = number(entry + 8, 2);
    return orientation >= 1 && orientation <= 8 ? static_cast<int>(orientation) : 1;
  }
  return 1;
}

bool is_jpeg(std::string_view bytes) {
  return bytes.starts_with("\xFF\xD8\xFF");
}

Result<Picture> decode_jpeg(std::string_view bytes, const std::string& origin, std::int64_t most,
                            Lying lying) {
  Decoder decoder;
  const bool read = read_header(decoder, bytes);
  // libjpeg has a limit of its own, a little below what a header can hold.
  const bool sized = read || decoder.errors.msg_code == JERR_IMAGE_TOO_BIG;
  if (!sized) return broken(origin, decoder);
  const std::int64_t width = decoder.info.image_width, height = decoder.info.image_height;
  if (!read || width * height > most) return too_many_pixels(origin, width, height, most);
  Picture picture{static_cast<int>(width),
                  static_cast<int>(height),
                  decoder.info.out_color_space == JCS_GRAYSCALE ? 1 : 3,
                  {}};
  const std::size_t stride = static_cast<std::size_t>(width) * static_cast<std::size_t>(picture.channels);
  picture.values.resize(stride * static_cast<std::size_t>(height));
  const int orientation = lying == Lying::upright ? orientation_of(decoder.info) : 1;
  if (!read_rows(decoder, picture.values.data(), stride)) return broken(origin, decoder);
  return turned_by_exif(std::move(picture), orientation);
}

}  // namespace replan
