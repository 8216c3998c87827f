// What is to be known of a film before it is made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace replan::app {

/// WebM is what browsers record; the desktop program makes the others.
enum class FilmFormat : std::uint8_t { gif, webp, mp4, webm };
/// By the extension; nothing if it is none of a film.
std::optional<FilmFormat> film_format(const std::string& path);

/// Pixels of a picture or a film.
struct FrameSize {
  int width = 0, height = 0;
};
/// The size of a film file that is made of frames of that size: an .mp4 gets a black edge to even numbers.
FrameSize film_size(const std::string& path, FrameSize frames);

struct FilmSettings {
  std::string path;  ///< .gif, .webp or .mp4; in a page .webm
  int width = 0;     ///< pixels of the frames
  int height = 0;
  int fps = 30;
};

}  // namespace replan::app
