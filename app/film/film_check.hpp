// Whether a film file is whole, by its own structure.
#pragma once

#include "app/film/film_settings.hpp"

namespace replan::app {

/// FFmpeg does not notice every failed write: on a full disk it ends a WebP early and says that all went
/// well. True if the open file is a whole film of that format.
bool is_whole_film(int file, FilmFormat format);

}  // namespace replan::app
