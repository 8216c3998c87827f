// Where frames go: a film file, or a folder of numbered pictures.
#pragma once

#include <memory>
#include <string>

#include "app/film/film_writer.hpp"
#include "app/film/frame_queue.hpp"

namespace replan::app {

/// Whether the path is that of a folder for frames: it ends in '/', or is a folder already.
bool is_frame_folder(const std::string& path);

/// Takes frames while others are being written. A film file appears when finish() has succeeded and not
/// before; in a folder each picture appears whole.
class Film {
 public:
  /// `settings.path` may be a folder for frames too; it is made if need be. Numbered pictures that are in it
  /// are replaced.
  static Result<std::unique_ptr<Film>> open(const FilmSettings& settings);
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  /// Without finish() no film is left; a folder keeps the pictures that it has.
  ~Film();

  /// Waits if the writing is behind. After an Error nothing more is taken.
  Result<void> add(ui::Image frame);
  /// Waits until everything is on the disk.
  Result<void> finish();

 private:
  Film() = default;

  std::size_t frames_ = 0;              // added
  std::string folder_;                  // for pictures; empty for a film file
  std::unique_ptr<FilmWriter> writer_;  // for a film file
  std::unique_ptr<FrameQueue> queue_;
};

}  // namespace replan::app
