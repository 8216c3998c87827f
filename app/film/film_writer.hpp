// Frames into a film file, by FFmpeg's program through a pipe.
#pragma once

#include <memory>
#include <string>

#include "app/film/film_settings.hpp"
#include "core/base/pending_file.hpp"
#include "core/base/result.hpp"
#include "ui/image.hpp"

namespace replan::app {

class ChildProcess;

/// The file stands under its name only when finish() has succeeded; until then an old one stays whole. The
/// same frames give the same bytes with the same FFmpeg.
///
/// A GIF takes two passes, since its one palette needs all colours: the frames are kept without loss in an
/// unnamed file of the same folder while the palette is gathered, and finish() makes the GIF of them.
class FilmWriter {
 public:
  /// Fails with a sentence if FFmpeg is not installed, the path cannot be written or the settings do not fit.
  static Result<std::unique_ptr<FilmWriter>> open(const FilmSettings& settings);
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;
  /// Without finish() nothing is left.
  ~FilmWriter();

  /// The next frame, of the film's size. Waits for FFmpeg to take it.
  Result<void> add(const ui::Image& frame);
  /// Waits until the film is complete and puts it in place. Not to be called twice, nor without a frame.
  Result<void> finish();

 private:
  FilmWriter(FilmSettings settings, FilmFormat format, PendingFile file);
  Result<void> start();
  Result<void> start_gathering();
  Result<void> make_gif();
  [[nodiscard]] Error failed(const std::string& why) const;

  FilmSettings settings_;
  FilmFormat format_;
  PendingFile file_;
  int kept_ = -1;     // for a GIF: the frames without loss
  int palette_ = -1;  // and the palette's picture
  std::unique_ptr<ChildProcess> encoder_;
};

}  // namespace replan::app
