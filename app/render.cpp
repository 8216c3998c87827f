#include "app/render.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "app/platform/offscreen.hpp"
#include "core/base/file.hpp"
#include "core/scene/svg.hpp"
#include "ui/canvas_draw.hpp"
#include "ui/shell/shell.hpp"

namespace replan::app {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide = 16384;

/// What a run could not do is no picture.
Result<void> check(const Session& session) {
  if (std::string failure = session.failure(); !failure.empty()) return Error{std::move(failure)};
  return {};
}

/// Goes to the moment of a still.
Result<void> go_to(Session& session, const RenderRequest& request) {
  const auto* position = std::get_if<std::size_t>(&request.at);
  if (position == nullptr && std::get<Moment>(request.at) == Moment::plan) {
    session.settle();
    return check(session);
  }
  if (const auto done = session.apply(RunToEnd{}); !done) return done;
  for (const auto& run : session.runs()) run->finish(Target::end());
  session.update(0);
  if (auto sound = check(session); !sound || position == nullptr) return sound;
  if (const std::size_t size = session.run().timeline().size(); *position > size)
    return Error{"event " + std::to_string(*position) + " lies beyond the run's end; it has " +
                 std::to_string(size) + " events"};
  return session.apply(Seek{*position});
}

/// A window, or a canvas alone, in memory.
class Studio {
 public:
  static Result<std::unique_ptr<Studio>> open(const RenderRequest& request, const Session& session,
                                              ui::ViewState state) {
    auto studio = std::unique_ptr<Studio>(new Studio(request, std::move(state)));
    auto offscreen = Offscreen::create({request.width, request.height, static_cast<float>(request.scale)});
    if (!offscreen) return Error{offscreen.error()};
    studio->offscreen_ = std::move(*offscreen);
    studio->offscreen_->stage().set_theme(studio->state_.dark ? ui::dark() : ui::light());
    if (std::string words = ui::Shell::words(session); !words.empty())
      studio->offscreen_->stage().set_language(std::move(words), false);
    return studio;
  }
  ~Studio() {
    if (!offscreen_) return;
    // Their textures can only be given back while the context is current.
    offscreen_->frame([this] {
      canvas_.reset();
      shell_.reset();
    });
  }
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  ui::Image shoot(Session& session) {
    // Two frames: windows that are sized by their content settle in the second.
    const int frames = request_.window && !settled_ ? 2 : 1;
    for (int i = 0; i < frames; ++i)
      offscreen_->frame([&] { request_.window ? draw_window(session) : draw_canvas(session); },
                        1.0f / kFramesPerSecond);
    settled_ = true;
    return offscreen_->picture();
  }

 private:
  Studio(const RenderRequest& request, ui::ViewState state) : request_(request), state_(std::move(state)) {}

  void draw_window(Session& session) {
    ui::Stage& stage = offscreen_->stage();
    if (!shell_) {
      shell_ = std::make_unique<ui::Shell>(stage.renderer());
      shell_->view() = state_;
    }
    shell_->draw(stage.look(), session, 1.0 / kFramesPerSecond);
  }

  void draw_canvas(const Session& session) {
    ui::Stage& stage = offscreen_->stage();
    if (!canvas_) canvas_ = std::make_unique<ui::Canvas>(stage.renderer());
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::Begin("canvas", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    std::vector<Command> none;
    canvas_->draw(stage.look(), session, 0, state_, {0, 0}, ImGui::GetIO().DisplaySize, false, none);
    ImGui::End();
    ImGui::PopStyleVar(3);
  }

  const RenderRequest& request_;
  ui::ViewState state_;
  std::unique_ptr<Offscreen> offscreen_;
  std::unique_ptr<ui::Canvas> canvas_;
  std::unique_ptr<ui::Shell> shell_;
  bool settled_ = false;
};

Result<void> render_svg(const RenderRequest& request, Session& session, const ui::ViewState& state) {
  View view = state.view;
  view.scale = request.scale;
  const Palette palette = ui::scene_palette(state.dark ? ui::dark() : ui::light());
  const Scene scene = build_scene(session.run(), view, {request.width, request.height}, palette);
  return write_file_atomically(request.output, scene_svg(scene, palette));
}

Result<void> render_frames(const RenderRequest& request, Session& session, const ui::ViewState& state) {
  std::error_code failed;
  fs::create_directories(request.output, failed);
  if (failed) return Error{"cannot make the folder " + request.output + ": " + failed.message()};
  for (const auto& run : session.runs()) run->finish(Target::end());
  session.update(0);
  auto studio = Studio::open(request, session, state);
  if (!studio) return Error{studio.error()};
  const std::vector<std::size_t> positions = film_positions(session.run());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (const auto sought = session.apply(Seek{positions[i]}); !sought) return sought;
    char name[32];
    std::snprintf(name, sizeof name, "%06zu.png", i);
    if (const auto written = ui::write_png(fs::path(request.output) / name, (*studio)->shoot(session));
        !written)
      return written;
    if (request.progress) request.progress(i + 1, positions.size());
  }
  return {};
}

/// Every stop between two positions, thinned to about `frames`.
void add_thinned(const Run& run, std::size_t from, std::size_t to, std::size_t frames,
                 std::vector<std::size_t>& positions) {
  std::vector<std::size_t> stops;
  for (std::size_t p = from; p < to; ++p)
    if (run.timeline().event(p).kind == EventKind::pop) stops.push_back(p);
  const std::size_t every = std::max<std::size_t>(1, (stops.size() + frames - 1) / frames);
  for (std::size_t i = 0; i < stops.size(); i += every) positions.push_back(stops[i]);
}

}  // namespace

std::vector<std::size_t> film_positions(const Run& run) {
  constexpr std::size_t kPlanFrames = 2 * kFramesPerSecond, kHold = kFramesPerSecond / 3;
  std::vector<std::size_t> positions = {0};
  std::size_t begun = 0;
  for (const Marker& marker : run.markers()) {
    if (marker.kind == EventKind::plan_begin) begun = marker.event;
    if (marker.kind == EventKind::plan_end) add_thinned(run, begun, marker.event, kPlanFrames, positions);
    if (marker.kind == EventKind::plan_begin) continue;
    // What a viewer has to read stands still for a moment.
    const std::size_t shown = marker.kind == EventKind::move || marker.kind == EventKind::waiting ? 1 : kHold;
    const bool moves = marker.kind == EventKind::move;
    // A move is told by an event and carried out by those that follow it.
    const Mark* mark = run.mark_at(marker.event + 4);
    const std::size_t after =
        moves && mark != nullptr ? std::max(marker.event + 1, mark->event) : marker.event + 1;
    positions.insert(positions.end(), shown, after);
  }
  positions.insert(positions.end(), kFramesPerSecond, run.timeline().size());
  return positions;
}

Result<ui::ViewState> requested_view(const RenderRequest& request) {
  ui::ViewState state;
  const ViewSetup& setup = request.scenario.view;
  if (request.overlays) {
    state.view.overlays = *request.overlays;
  } else if (!setup.overlays.empty()) {
    const auto parsed = parse_overlays(setup.overlays);
    if (!parsed) return Error{parsed.error()};
    state.view.overlays = *parsed;
  }
  if (setup.camera)
    state.view.camera = {setup.camera->x, setup.camera->y, setup.camera->zoom * request.scale};
  const std::string theme = request.theme ? *request.theme : setup.theme.value_or("dark");
  if (theme != "dark" && theme != "light")
    return Error{"there is no theme '" + theme + "'; take 'dark' or 'light'"};
  state.dark = theme == "dark";
  state.view.pinned = request.pinned;
  state.view.scale = request.scale;
  state.legend = request.legend;
  state.live = false;
  return state;
}

Result<void> render(const RenderRequest& request) {
  if (request.width < 16 || request.height < 16 || request.width > kMaxSide || request.height > kMaxSide)
    return Error{"a picture's sides must lie between 16 and " + std::to_string(kMaxSide) + " pixels"};
  if (!(request.scale >= 0.5 && request.scale <= 4)) return Error{"the scale must lie between 0.5 and 4"};
  const Result<ui::ViewState> state = requested_view(request);
  if (!state) return Error{state.error()};
  const std::string extension = file_extension(request.output);
  Session session(request.scenario);
  if (request.output.ends_with('/') || fs::is_directory(request.output))
    return render_frames(request, session, *state);
  if (extension != ".png" && extension != ".svg")
    return Error{request.output + ": a picture's name ends in .png or .svg, a folder for frames in /"};
  if (const auto there = go_to(session, request); !there) return there;
  if (extension == ".svg") return render_svg(request, session, *state);
  auto studio = Studio::open(request, session, *state);
  if (!studio) return Error{studio.error()};
  return ui::write_png(request.output, (*studio)->shoot(session));
}

}  // namespace replan::app
