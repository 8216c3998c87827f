#include "app/film_maker.hpp"

#include <algorithm>
#include <utility>

namespace replan::app {
namespace {

int side(float low, float high) {
  return static_cast<int>(high) - static_cast<int>(low);
}

/// The same part of the world in a picture of another size.
void fit_camera(ui::ViewState& state, int width, int height, const ui::PixelArea& area) {
  const double across = static_cast<double>(width) / std::max(1, side(area.min.x, area.max.x));
  const double down = static_cast<double>(height) / std::max(1, side(area.min.y, area.max.y));
  for (Camera* camera : {&state.view.camera, &state.upright[0], &state.upright[1]})
    camera->zoom *= std::min(across, down);
}

}  // namespace

ui::ViewState filmed_view(const ui::ViewState& view) {
  ui::ViewState filmed;
  filmed.view = view.view;
  filmed.view.hovered.reset();
  filmed.slices = view.slices;
  filmed.upright = view.upright;
  filmed.orbit = view.orbit;
  filmed.solid = view.solid;
  filmed.dark = view.dark;
  filmed.panels = view.panels;
  filmed.tab = view.tab;
  filmed.legend = view.legend;
  filmed.live = false;
  return filmed;
}

Result<void> FilmMaker::begin(const ui::CaptureRequest& request, FilmSet set, Session& session) {
  request_ = request;
  set_ = std::move(set);
  next_ = 0;
  frames_.clear();
  if (request_.film.width == 0) request_.film.width = side(set_.area.min.x, set_.area.max.x);
  if (request_.film.height == 0) request_.film.height = side(set_.area.min.y, set_.area.max.y);
  lead_ = session.lead();
  cursor_ = session.run().timeline().cursor();
  log_ = session.run().log_id();
  if (!ui::is_complete(request_.film.part, session.run())) {
    if (Result<void> sent = session.apply(RunToEnd{}); !sent) return sent;
    // No step: the playhead does not go along with the run. A Seek to the end of what there is would let it.
    if (Result<void> stayed = session.apply(Step{StepUnit::expansion, 0}); !stayed) return stayed;
  }
  at_work_ = true;
  return {};
}

/// The part of the run is there: what is drawn with, and what is written into.
Result<void> FilmMaker::open(Session& session) {
  // Where the playhead stood says which replan was meant.
  Result<std::vector<FilmFrame>> frames = std::vector<FilmFrame>{};
  session.glance(lead_, cursor_, 1, [&] { frames = ui::film_frames(request_.film, session.run()); });
  if (!frames) return Error{frames.error()};
  frames_ = std::move(*frames);
  ui::ViewState state = std::move(set_.view);
  const auto [part, width, height, fps, speed] = request_.film;
  if (!request_.window) fit_camera(state, width, height, set_.area);
  const std::size_t panes = request_.window   ? set_.panes
                            : set_.panes == 0 ? session.runs().size()
                                              : set_.panes;
  auto studio =
      Studio::open({width, height, set_.scale, request_.window, panes, 1.0 / fps}, session, std::move(state));
  if (!studio) return Error{studio.error()};
  studio_ = std::move(*studio);
  const ui::PixelArea all{{0, 0}, {static_cast<float>(width), static_cast<float>(height)}};
  return recording_.start(request_, all);
}

Result<void> FilmMaker::shoot(Session& session) {
  const FilmFrame& frame = frames_[next_];
  ui::Image picture;
  session.glance(lead_, frame.position, frame.travel, [&] { picture = studio_->shoot(session); });
  const ui::PixelArea all{{0, 0}, {static_cast<float>(picture.width), static_cast<float>(picture.height)}};
  recording_.take(picture, all);
  if (!recording_.on()) return Error{""};  // the recording tells why
  ++next_;
  return {};
}

Result<void> FilmMaker::go_on(Session& session) {
  if (!at_work_) return {};
  const auto fail = [&](std::string sentence) -> Result<void> {
    cancel();
    return Error{std::move(sentence)};
  };
  if (lead_ >= session.runs().size() || session.runs()[lead_]->log_id() != log_)
    return fail("The film was not made: the run has changed meanwhile");
  if (!studio_) {
    const Run& run = *session.runs()[lead_];
    if (!ui::is_complete(request_.film.part, run)) {
      if (run.busy()) return {};
      if (std::exchange(next_, 1) > 0) return fail("The film was not made: the run does not come that far");
    }
    next_ = 0;
    if (Result<void> opened = open(session); !opened) return fail(opened.error());
    return {};
  }
  if (!recording_.ready()) return {};
  if (Result<void> shot = shoot(session); !shot) return fail(shot.error());
  if (next_ < frames_.size()) return {};
  recording_.stop();
  leave();
  return {};
}

void FilmMaker::cancel() {
  recording_.give_up();
  leave();
}

void FilmMaker::leave() {
  at_work_ = false;
  studio_.reset();
}

double FilmMaker::share() const {
  return frames_.empty() ? 0 : static_cast<double>(next_) / static_cast<double>(frames_.size());
}

}  // namespace replan::app
