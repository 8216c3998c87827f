#include "app/recording.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/file.hpp"

namespace replan::app {

ui::Image cut_out(const ui::Image& picture, const ui::PixelArea& area, int width, int height) {
  ui::Image cut{width, height, {}};
  cut.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  const int left = std::clamp(static_cast<int>(area.min.x), 0, picture.width);
  const int top = std::clamp(static_cast<int>(area.min.y), 0, picture.height);
  const int columns = std::min({width, static_cast<int>(area.max.x) - left, picture.width - left});
  const int rows = std::min({height, static_cast<int>(area.max.y) - top, picture.height - top});
  for (int y = 0; y < rows && columns > 0; ++y)
    std::copy_n(picture.at(left, top + y), static_cast<std::size_t>(columns) * 4,
                cut.rgba.begin() + static_cast<std::ptrdiff_t>(y) * width * 4);
  for (std::size_t alpha = 3; alpha < cut.rgba.size(); alpha += 4) cut.rgba[alpha] = 255;
  return cut;
}

Result<void> Recording::start(const ui::CaptureRequest& request, const ui::PixelArea& area) {
  request_ = request;
  frames_ = 0;
  width_ = static_cast<int>(area.max.x) - static_cast<int>(area.min.x);
  height_ = static_cast<int>(area.max.y) - static_cast<int>(area.min.y);
  if (width_ < 1 || height_ < 1) return Error{"there is nothing to be seen of the canvas"};
  auto film = Film::open({request.path, width_, height_, request.film.fps});
  if (!film) return Error{film.error()};
  film_ = std::move(*film);
  return {};
}

void Recording::take(const ui::Image& picture, const ui::PixelArea& area) {
  if (!film_) return;
  if (const Result<void> taken = film_->add(cut_out(picture, area, width_, height_)); !taken) {
    film_.reset();
    broken_ = FilmOutcome{taken.error(), true};
    return;
  }
  ++frames_;
}

FilmOutcome Recording::completed(Film& film) const {
  if (frames_ == 0) return {"Nothing was recorded", false};
  if (const Result<void> done = film.finish(); !done) return {done.error(), true};
  const std::string name = is_frame_folder(request_.path) ? request_.path : file_name(request_.path);
  return {"Saved " + name + " (" + std::to_string(frames_) + (frames_ == 1 ? " frame)" : " frames)"), false};
}

void Recording::stop() {
  if (!film_) return;
  finisher_.start(
      [this, film = std::shared_ptr<Film>(std::move(film_))](const StopToken&) { return completed(*film); });
}

std::optional<FilmOutcome> Recording::outcome() {
  if (broken_) return std::exchange(broken_, std::nullopt);
  return finisher_.take();
}

std::optional<FilmOutcome> Recording::end() {
  stop();
  finisher_.wait();
  return outcome();
}

ui::RecordingState Recording::state() const {
  return {on(), !on() && finisher_.busy(), request_.window, static_cast<double>(frames_) / request_.film.fps};
}

}  // namespace replan::app
