#include "app/film/film.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <thread>

#include "app/film/film_writer.hpp"
#include "app/film/frame_queue.hpp"

namespace replan::app {
namespace {

namespace fs = std::filesystem;

fs::path frame_path(const std::string& folder, std::size_t number) {
  char name[32];
  std::snprintf(name, sizeof name, "%06zu.png", number);
  return fs::path(folder) / name;
}

Result<void> make_folder(const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return Error{"cannot make the folder " + folder + ": " + failed.message()};
  return {};
}

/// Pictures of an earlier, longer film would pass for the end of this one.
void remove_from(const std::string& folder, std::size_t number) {
  std::error_code failed;
  while (fs::remove(frame_path(folder, number++), failed)) {
  }
}

/// Compressing pictures takes longer than drawing them.
int picture_threads() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
}

}  // namespace

bool is_frame_folder(const std::string& path) {
  std::error_code failed;
  return path.ends_with('/') || fs::is_directory(path, failed);
}

struct Film::Sink {
  std::size_t frames = 0;              // added
  std::string folder;                  // for pictures; empty for a film file
  std::unique_ptr<FilmWriter> writer;  // for a film file
  std::unique_ptr<FrameQueue> queue;
};

Film::Film() : sink_(std::make_unique<Sink>()) {}

Result<std::unique_ptr<Film>> Film::open(const FilmSettings& settings) {
  std::unique_ptr<Film> film(new Film);
  if (is_frame_folder(settings.path)) {
    film->sink_->folder = settings.path;
    if (const Result<void> made = make_folder(settings.path); !made) return Error{made.error()};
    film->sink_->queue = std::make_unique<FrameQueue>(
        [folder = settings.path](std::size_t number, const ui::Image& frame) {
          return ui::write_png(frame_path(folder, number), frame);
        },
        picture_threads());
    return film;
  }
  auto writer = FilmWriter::open(settings);
  if (!writer) return Error{writer.error()};
  film->sink_->writer = std::move(*writer);
  film->sink_->queue = std::make_unique<FrameQueue>(
      [to = film->sink_->writer.get()](std::size_t, const ui::Image& frame) { return to->add(frame); }, 1);
  return film;
}

Film::~Film() = default;

bool Film::ready() const {
  return true;
}

Result<void> Film::add(ui::Image frame) {
  ++sink_->frames;
  return sink_->queue->push(std::move(frame));
}

Result<void> Film::finish() {
  if (Result<void> written = sink_->queue->finish(); !written) return written;
  if (sink_->writer) return sink_->writer->finish();
  remove_from(sink_->folder, sink_->frames);
  return {};
}

}  // namespace replan::app
