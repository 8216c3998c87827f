#include "app/film/film_check.hpp"

#include <array>
#include <cstring>
#include <string_view>

#include <sys/stat.h>
#include <unistd.h>

namespace replan::app {
namespace {

/// Bytes at a place of a file; empty if the file ends before.
template <std::size_t N>
struct Bytes {
  std::array<unsigned char, N> data{};
  bool read = false;

  Bytes(int file, off_t at) {
    read = at >= 0 && ::pread(file, data.data(), N, at) == static_cast<ssize_t>(N);
  }
  [[nodiscard]] bool say(std::size_t from, std::string_view text) const {
    return read && from + text.size() <= N && std::memcmp(data.data() + from, text.data(), text.size()) == 0;
  }
  [[nodiscard]] off_t big_endian(std::size_t from, std::size_t count) const {
    off_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value * 256 + data[from + i];
    return value;
  }
};

/// A GIF begins with its name and ends with a semicolon.
bool is_whole_gif(int file, off_t size) {
  return Bytes<6>(file, 0).say(0, "GIF89a") && Bytes<1>(file, size - 1).say(0, ";");
}

/// A WebP tells its length in its head.
bool is_whole_webp(int file, off_t size) {
  const Bytes<12> head(file, 0);
  if (!head.say(0, "RIFF") || !head.say(8, "WEBP")) return false;
  off_t length = 0;
  for (std::size_t i = 8; i-- > 4;) length = length * 256 + head.data[i];
  return length + 8 == size;
}

/// An MP4 is a row of boxes, each with its length; one of them is the table of contents.
bool is_whole_mp4(int file, off_t size) {
  bool has_contents = false;
  off_t at = 0;
  while (at < size) {
    const Bytes<8> box(file, at);
    if (!box.read) return false;
    off_t length = box.big_endian(0, 4);
    if (length == 1) length = Bytes<8>(file, at + 8).big_endian(0, 8);  // too long for the short field
    if (length < 8) return false;
    has_contents = has_contents || box.say(4, "moov");
    at += length;
  }
  return has_contents && at == size;
}

}  // namespace

bool is_whole_film(int file, FilmFormat format) {
  struct stat info {};
  if (::fstat(file, &info) != 0) return false;
  switch (format) {
    case FilmFormat::gif:
      return is_whole_gif(file, info.st_size);
    case FilmFormat::webp:
      return is_whole_webp(file, info.st_size);
    case FilmFormat::webm:  // a browser's, which FFmpeg is not asked for
      return false;
    case FilmFormat::mp4:
      return is_whole_mp4(file, info.st_size);
  }
  return false;
}

}  // namespace replan::app
