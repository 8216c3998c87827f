// Where frames go: a film file, or a folder of numbered pictures.
#pragma once

#include <memory>
#include <string>

#include "app/film/film_settings.hpp"
#include "core/base/result.hpp"
#include "ui/image.hpp"

namespace replan::app {

/// Whether the path is that of a folder for frames: it ends in '/', or is a folder already.
bool is_frame_folder(const std::string& path);

/// Takes frames while others are being written. A film file appears when finish() has succeeded and not
/// before; in a folder each picture appears whole. In a page its own recorder makes it (app/web/film.cpp).
class Film {
 public:
  /// `settings.path` may be a folder for frames too; it is made if need be. Numbered pictures that are in it
  /// are replaced.
  static Result<std::unique_ptr<Film>> open(const FilmSettings& settings);
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  /// Without finish() no film is left; a folder keeps the pictures that it has.
  ~Film();

  /// Whether a frame may come now. A page's recorder goes by the clock, so frames must not come faster than they show.
  [[nodiscard]] bool ready() const;
  /// Waits if the writing is behind. After an Error nothing more is taken.
  Result<void> add(ui::Image frame);
  /// Waits until everything is on the disk.
  Result<void> finish();

 private:
  struct Sink;

  Film();

  std::unique_ptr<Sink> sink_;
};

}  // namespace replan::app
