#include "app/capture.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "app/render.hpp"
#include "core/base/file.hpp"

namespace replan::app {

void Capture::report() {
  shell_.panels().recording = recording_.state();
  if (maker_.on()) shell_.panels().recording.made = maker_.share();
}

void Capture::follow() {
  if (const auto request = shell_.take_capture()) take_up(*request);
  shell_.view().captured = (wanted_ && !wanted_->window) || (recording_.on() && !recording_.of_window());
  if (settling_ > 0 && --settling_ == 0) carry_out(*std::exchange(wanted_, std::nullopt));
  if (const auto outcome = recording_.outcome()) {
    window_.pace(0);
    shell_.tell(outcome->sentence, outcome->bad);
  }
  if (maker_.on()) {
    if (const Result<void> made = maker_.go_on(session_); !made && !made.error().empty())
      shell_.tell(made.error(), true);
  } else if (recording_.on()) {
    window_.capture([this](const ui::Image& image) { recording_.take(image, area(recording_.of_window())); });
  }
}

void Capture::take_up(const ui::CaptureRequest& request) {
  constexpr int kFramesOfADialog = 3;
  switch (request.kind) {
    case ui::CaptureRequest::Kind::stop:
      window_.pace(0);
      recording_.stop();
      return;
    case ui::CaptureRequest::Kind::give_up:
      maker_.cancel();
      shell_.tell("The film was not made", false);
      return;
    case ui::CaptureRequest::Kind::film:
    case ui::CaptureRequest::Kind::picture:
      wanted_ = request;
      settling_ = kFramesOfADialog;
  }
}

/// The pixels that a film or a picture is made of, as drawn last.
ui::PixelArea Capture::area(bool window) const {
  return window ? ui::PixelArea{{0, 0}, window_.stage().io().DisplaySize} : shell_.panels().canvas;
}

void Capture::carry_out(const ui::CaptureRequest& request) {
  if (request.kind == ui::CaptureRequest::Kind::picture) return take_picture(request);
  const bool live = request.film.part == ui::FilmPart::live;
  const Result<void> started = live ? recording_.start(request, area(request.window)) : make_film(request);
  if (!started) return shell_.tell(started.error(), true);
  if (live) window_.pace(recording_.step());
}

Result<void> Capture::make_film(const ui::CaptureRequest& request) {
  const ui::PixelArea shown = area(request.window);
  // Words and lines are as large, beside the world, as they are on the screen.
  const double larger =
      request.film.width > 0 ? request.film.width / static_cast<double>(shown.max.x - shown.min.x) : 1;
  const double scale =
      std::max(0.5, static_cast<double>(window_.stage().look().px.scale) * std::min(larger, 1.0));
  return maker_.begin(request, {filmed_view(shell_.view()), shell_.panels().panes, shown, scale}, session_);
}

void Capture::take_picture(const ui::CaptureRequest& request) {
  const std::string extension = file_extension(request.path);
  const ui::PixelArea part = area(request.window);
  const Viewport size{static_cast<int>(part.max.x - part.min.x), static_cast<int>(part.max.y - part.min.y)};
  if (extension == ".png") {
    window_.capture([this, part, size, path = request.path](const ui::Image& image) {
      tell_of_picture(path, ui::write_png(path, cut_out(image, part, size.width, size.height)), "");
    });
  } else if (extension == ".svg" && !request.window) {
    const std::size_t pane = session_.lead();
    tell_of_picture(request.path, write_drawing(request.path, session_.run(), shell_.view(), pane, size),
                    drawing_note(session_.run(), shell_.view(), pane));
  } else {
    shell_.tell(request.path + (request.window ? ": a picture of the window is a .png"
                                               : ": a picture is a .png or an .svg"),
                true);
  }
}

void Capture::tell_of_picture(const std::string& path, const Result<void>& written, const std::string& note) {
  const std::string saved = "Saved " + file_name(path) + (note.empty() ? "" : ": " + note);
  shell_.tell(written ? saved : written.error(), !written);
}

void Capture::end() {
  if (maker_.on()) maker_.cancel();
  if (!recording_.state().busy()) return;
  window_.hide();
  if (const auto outcome = recording_.end(); outcome && outcome->bad)
    std::fprintf(stderr, "replan: %s\n", outcome->sentence.c_str());
}

}  // namespace replan::app
