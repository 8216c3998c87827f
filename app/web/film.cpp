// Films by the page's own recorder: what it shows of a hidden canvas, as it goes by. A film takes as long to be made as it
// lasts, and is handed over as a download.
#include "app/film/film.hpp"

#include <emscripten.h>

#include "core/base/file.hpp"

namespace replan::app {
namespace {

// clang-format off
EM_JS(int, js_film_begin, (const char* name, int width, int height, int fps), {
  return Module.replan.film.begin(UTF8ToString(name), width, height, fps) ? 1 : 0;
});
EM_JS(void, js_film_add, (const unsigned char* rgba, int width, int height), {
  Module.replan.film.add(HEAPU8.subarray(rgba, rgba + width * height * 4), width, height);
});
EM_JS(int, js_film_ready, (void), { return Module.replan.film.ready() ? 1 : 0; });
EM_JS(void, js_film_end, (int keep), { Module.replan.film.end(keep !== 0); });
// clang-format on

}  // namespace

struct Film::Sink {
  FilmSettings settings;
  bool kept = false;
};

Film::Film() : sink_(std::make_unique<Sink>()) {}

Film::~Film() {
  if (!sink_->kept) js_film_end(0);
}

bool is_frame_folder(const std::string& path) {
  return path.ends_with('/');
}

std::optional<FilmFormat> film_format(const std::string& path) {
  return file_extension(path) == ".webm" ? std::optional(FilmFormat::webm) : std::nullopt;
}

FrameSize film_size(const std::string&, FrameSize frames) {
  return frames;
}

Result<std::unique_ptr<Film>> Film::open(const FilmSettings& settings) {
  if (file_extension(settings.path) != ".webm")
    return Error{settings.path +
                 ": in a browser a film's name ends in .webm; the desktop program makes others"};
  if (js_film_begin(file_name(settings.path).c_str(), settings.width, settings.height, settings.fps) == 0)
    return Error{
        "This browser does not record films. Take another browser, or the desktop program; pictures work "
        "here too."};
  std::unique_ptr<Film> film(new Film);
  film->sink_->settings = settings;
  return film;
}

bool Film::ready() const {
  return js_film_ready() != 0;
}

Result<void> Film::add(ui::Image frame) {
  js_film_add(frame.rgba.data(), frame.width, frame.height);
  return {};
}

Result<void> Film::finish() {
  sink_->kept = true;
  js_film_end(1);
  return {};
}

}  // namespace replan::app
