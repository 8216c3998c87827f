#include "app/gui_program.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/about.hpp"
#include "app/film_maker.hpp"
#include "app/gui_settings.hpp"
#include "app/platform/surroundings.hpp"
#include "app/platform/window.hpp"
#include "app/recording.hpp"
#include "app/render.hpp"
#include "core/base/cpu_time.hpp"
#include "core/base/file.hpp"
#include "core/experiment/held_results.hpp"
#include "core/plan/pages.hpp"
#include "ui/documents/files.hpp"
#include "ui/shell/shell.hpp"

namespace replan::app {
namespace {

/// A repair in a world of usual size is there within a frame, and the step over it is seen at once.
constexpr std::chrono::milliseconds kPatience{8};

double milliseconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

/// From here on a frame is late for a display of 60 a second.
constexpr double kSlowFrameMs = 16;

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && value[0] != '\0' && value[0] != '0';
}

/// A small world in code, for a program that was copied without its files.
Scenario built_in_world() {
  Scenario scenario;
  scenario.name = "Two walls";
  scenario.map = GridMap(36, 24);
  for (int y = 0; y < 17; ++y) scenario.map.set({12, y}, true);
  for (int y = 7; y < 24; ++y) scenario.map.set({23, y}, true);
  scenario.start = {3, 12};
  scenario.goal = {32, 12};
  scenario.planners = {{.id = std::string(sound_planners().back().id), .settings = {}}};
  return scenario;
}

}  // namespace

Result<FirstDocument> first_document(const std::optional<std::string>& file) {
  if (file && is_link(*file)) {
    Result<Link> link = parse_link(*file);
    if (!link) return Error{link.error()};
    Scenario scenario = link->scenario;
    return FirstDocument{.scenario = std::move(scenario), .file = {}, .link = std::move(link.value())};
  }
  const bool batch = file && batch_paper(*file) != BatchPaper::none;
  if (file && !batch) {
    const Result<Scenario> opened = ui::open_document(*file, built_in_world());
    if (!opened) return Error{opened.error()};
    return FirstDocument{*opened, *file};
  }
  const std::filesystem::path demo = std::filesystem::path(assets_folder()) / "../maps/demo.json";
  // The demo is nobody's file: saving asks for a name.
  const Result<Scenario> opened = read_scenario(demo.lexically_normal().string());
  return FirstDocument{opened ? *opened : built_in_world(), {}, batch ? *file : "", false};
}

GuiProgram::GuiProgram(FirstDocument document, Remembered remembered, WorkPlace work)
    : remembered_(std::move(remembered)),
      batch_(std::move(document.batch)),
      asked_for_(document.asked_for),
      link_(std::move(document.link)),
      session_(std::move(document.scenario), std::move(document.file), {}, std::move(work)),
      timing_(is_set("REPLAN_TIMING")) {}

Result<void> GuiProgram::open() {
  Result<std::unique_ptr<Window>> window = Window::open(remembered_.window);
  if (!window) return Error{window.error()};
  window_ = std::move(*window);
  shell_ = std::make_unique<ui::Shell>(window_->stage().renderer());
  ui::ViewState& looks = shell_->view();
  looks.dark = remembered_.dark;
  looks.size_step = remembered_.size_step;
  window_->stage().set_size(looks.size());
  looks.large_targets = remembered_.large_targets;
  looks.panels = remembered_.panels;
  looks.legend = remembered_.legend;
  looks.view.range = remembered_.colours_so_far ? FieldSpan::so_far : FieldSpan::whole_run;
  looks.metres = remembered_.metres;
  looks.minimap = remembered_.minimap;
  looks.colours = remembered_.colours;
  looks.brush = remembered_.brush;
  looks.editing.round = remembered_.round_brush;
  looks.tab = remembered_.tab;
  shell_->panels().side_width = remembered_.side_width;
  shell_->panels().side_share = remembered_.side_share;
  shell_->panels().unit = remembered_.unit;
  shell_->panels().caption = remembered_.caption;
  if (!remembered_.link_address.empty()) shell_->panels().link_address = remembered_.link_address;
  shell_->panels().notices = window_->stage().notices();
  shell_->panels().about = about_lines();
  shell_->show(session_.scenario().view);
  static_cast<void>(session_.apply(SetSpeed{remembered_.speed}));
  session_.set_patience(kPatience);
  dark_ = shell_->view().dark;
  window_->stage().set_theme(dark_ ? ui::dark() : ui::light());
  window_->on_drop([this](const std::vector<std::filesystem::path>& paths) {
    std::vector<std::string> names;
    for (const std::filesystem::path& path : paths) names.push_back(path.string());
    drop(names);
  });
  window_->on_close([this] { return shell_->documents().may_close(session_); });
  shell_->documents().settle_in(session_, surroundings(session_.work()));
  if (link_)
    begin_with_link();
  else if (!batch_.empty())
    shell_->show_batch(session_, batch_);
  else if (remembered_.first_start && !asked_for_)
    shell_->welcome();
  return {};
}

/// The session has its world already.
void GuiProgram::begin_with_link() {
  shell_->follow_link(session_, link_->view);
  if (link_->notes.empty()) return;
  std::vector<std::string>& notices = shell_->panels().notices;
  notices.insert(notices.end(), link_->notes.begin(), link_->notes.end());
  shell_->tell(link_->notes.front(), false);
}

void GuiProgram::run() {
  window_->run([this] { return frame(); });
}

bool GuiProgram::frame() {
  const Clock::time_point now = Clock::now();
  const double passed = std::chrono::duration<double>(now - last_).count();
  const double seconds = recording_.on() && !maker_.on() ? recording_.step() : passed;
  last_ = now;
  const double begin_ms = thread_cpu_ms();
  session_.set_share(shell_->work_share(session_, drawing_ms_));
  session_.update(seconds);
  const Clock::time_point updated = Clock::now();
  const double updated_ms = thread_cpu_ms();
  shell_->panels().recording = recording_.state();
  if (maker_.on()) shell_->panels().recording.made = maker_.share();
  shell_->draw(window_->stage().look(), session_, seconds);
  const double spent = milliseconds(Clock::now() - now);
  const auto lately = [](double before, double ms) { return before == 0 ? ms : before * 0.9 + ms * 0.1; };
  draw_ms_ = lately(draw_ms_, spent);
  drawing_ms_ = lately(drawing_ms_, milliseconds(Clock::now() - updated));
  shell_->panels().frame_ms = draw_ms_;
  if (timing_) report_slow_frame(updated_ms - begin_ms, thread_cpu_ms() - updated_ms);
  follow();
  if (!timed_) report_first_frame();
  capture();
  return shell_->wants_frames(session_) || settling_ > 0 || maker_.on();
}

/// The pixels that a film or a picture is made of, as drawn last.
ui::PixelArea GuiProgram::area(bool window) const {
  return window ? ui::PixelArea{{0, 0}, window_->stage().io().DisplaySize} : shell_->panels().canvas;
}

/// Films and pictures: carries out what was asked for, and takes this frame's pixels for a film.
void GuiProgram::capture() {
  if (const auto request = shell_->take_capture()) {
    if (request->kind == ui::CaptureRequest::Kind::stop) {
      window_->pace(0);
      recording_.stop();
    } else if (request->kind == ui::CaptureRequest::Kind::give_up) {
      maker_.cancel();
      shell_->tell("The film was not made", false);
    } else {
      wanted_ = request;
      settling_ = 3;
    }
  }
  shell_->view().captured = (wanted_ && !wanted_->window) || (recording_.on() && !recording_.of_window());
  if (settling_ > 0 && --settling_ == 0) carry_out(*std::exchange(wanted_, std::nullopt));
  if (const auto outcome = recording_.outcome()) {
    window_->pace(0);
    shell_->tell(outcome->sentence, outcome->bad);
  }
  if (maker_.on()) {
    if (const Result<void> made = maker_.go_on(session_); !made && !made.error().empty())
      shell_->tell(made.error(), true);
  } else if (recording_.on())
    window_->capture(
        [this](const ui::Image& image) { recording_.take(image, area(recording_.of_window())); });
}

void GuiProgram::carry_out(const ui::CaptureRequest& request) {
  if (request.kind == ui::CaptureRequest::Kind::picture) {
    take_picture(request);
    return;
  }
  const bool live = request.film.part == ui::FilmPart::live;
  const Result<void> started = live ? recording_.start(request, area(request.window)) : make_film(request);
  if (!started) return shell_->tell(started.error(), true);
  if (live) window_->pace(recording_.step());
}

Result<void> GuiProgram::make_film(const ui::CaptureRequest& request) {
  const ui::PixelArea shown = area(request.window);
  // Words and lines are as large, beside the world, as they are on the screen.
  const double larger =
      request.film.width > 0 ? request.film.width / static_cast<double>(shown.max.x - shown.min.x) : 1;
  const double scale =
      std::max(0.5, static_cast<double>(window_->stage().look().px.scale) * std::min(larger, 1.0));
  return maker_.begin(request, {filmed_view(shell_->view()), shell_->panels().panes, shown, scale}, session_);
}

void GuiProgram::take_picture(const ui::CaptureRequest& request) {
  const auto tell = [this, path = request.path](const Result<void>& written, const std::string& note = "") {
    const std::string saved = "Saved " + file_name(path) + (note.empty() ? "" : ": " + note);
    shell_->tell(written ? saved : written.error(), !written);
  };
  const std::string extension = file_extension(request.path);
  const ui::PixelArea part = area(request.window);
  const Viewport size{static_cast<int>(part.max.x - part.min.x), static_cast<int>(part.max.y - part.min.y)};
  if (extension == ".png") {
    window_->capture([tell, part, size, path = request.path](const ui::Image& image) {
      tell(ui::write_png(path, cut_out(image, part, size.width, size.height)));
    });
  } else if (extension == ".svg" && !request.window) {
    const std::size_t pane = session_.lead();
    tell(write_drawing(request.path, session_.run(), shell_->view(), pane, size),
         drawing_note(session_.run(), shell_->view(), pane));
  } else {
    shell_->tell(request.path + (request.window ? ": a picture of the window is a .png"
                                                : ": a picture is a .png or an .svg"),
                 true);
  }
}

/// Takes theme and title from the shell to the window.
void GuiProgram::follow() {
  if (shell_->view().dark != dark_) {
    dark_ = shell_->view().dark;
    window_->stage().set_theme(dark_ ? ui::dark() : ui::light());
  }
  window_->stage().set_size(shell_->view().size());
  window_->stage().set_fingers(shell_->view().large_targets || window_->stage().touches().used());
  if (std::string words =
          ui::uncommon_words(session_, shell_->documents().names_on_show() + shell_->batch().words());
      words != words_) {
    words_ = std::move(words);
    window_->stage().set_language(words_, false);
  }
  std::string title = ui::document_title(session_) + " – Replan";
  if (title != title_) window_->set_title(title);
  title_ = std::move(title);
  if (shell_->documents().quitting()) window_->close();
}

void GuiProgram::report_first_frame() {
  timed_ = true;
  if (!timing_) return;
  window_->capture([this](const ui::Image&) {
    // On a busy machine the processor's time says more than the clock on the wall.
    const double cpu = 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    std::fprintf(stderr, "first frame after %.0f ms, %.0f ms of processor time\n",
                 milliseconds(Clock::now() - begun_), cpu);
  });
}

/// Says of a frame that the eye could miss what kept it.
void GuiProgram::report_slow_frame(double update_ms, double draw_ms) {
  if (update_ms + draw_ms < kSlowFrameMs) return;
  std::string actions;
  for (const char* name : shell_->panels().performed) actions += std::string(" ") + name;
  std::fprintf(
      stderr, "a frame took %.0f ms of processor time: %.0f for the session, %.0f for the window;%s\n",
      update_ms + draw_ms, update_ms, draw_ms, actions.empty() ? " nothing was asked for" : actions.c_str());
}

std::string GuiProgram::facts() const {
  const Timeline& log = session_.run().timeline();
  const SearchState& state = log.state();
  std::size_t obstacles = 0;
  for (NodeId n = 0; n < state.node_count(); ++n) obstacles += state.truly_blocked(n) ? 1 : 0;
  const Decision* decision = session_.run().decision_at(log.cursor());
  const nlohmann::json json = {
      {"file", session_.file()},
      {"modified", session_.modified()},
      {"unsaved", session_.unsaved_edits()},
      {"undo", session_.undo_text()},
      {"obstacles", obstacles},
      {"cursor", log.cursor()},
      {"events", log.size()},
      {"state", std::to_string(state.hash())},
      {"planner", session_.run().info().id},
      {"moves", state.scalar(Scalar::moves)},
      {"playing", session_.playback().direction},
      {"opengl_es", window_->stage().renderer().gl().es},
      {"mission", decision == nullptr ? "planning" : mission_state_name(decision->state)}};
  return json.dump(2) + "\n";
}

void GuiProgram::remember() {
  remembered_.window = window_->state();
  const ui::ViewState& looks = shell_->view();
  remembered_.dark = looks.dark;
  remembered_.size_step = looks.size_step;
  remembered_.large_targets = looks.large_targets;
  remembered_.panels = looks.panels;
  remembered_.legend = looks.legend;
  remembered_.colours_so_far = looks.view.range == FieldSpan::so_far;
  remembered_.metres = looks.metres;
  remembered_.minimap = looks.minimap;
  remembered_.colours = looks.colours;
  remembered_.brush = looks.brush;
  remembered_.round_brush = looks.editing.round;
  remembered_.tab = looks.tab;
  remembered_.side_width = shell_->panels().side_width;
  remembered_.side_share = shell_->panels().side_share;
  remembered_.unit = shell_->panels().unit;
  remembered_.caption = shell_->panels().caption;
  remembered_.link_address = shell_->panels().link_address;
  remembered_.speed = session_.playback().expansions_per_second;
  if (const Result<void> written = write_settings(remembered_, settings_path()); !written)
    std::fprintf(stderr, "replan: %s\n", written.error().c_str());
}

Result<void> GuiProgram::close() {
  if (maker_.on()) maker_.cancel();
  if (recording_.state().busy()) {
    window_->hide();
    if (const auto outcome = recording_.end(); outcome && outcome->bad)
      std::fprintf(stderr, "replan: %s\n", outcome->sentence.c_str());
  }
  shell_->documents().leave();
  remember();
  const char* dump = std::getenv("REPLAN_STATE_DUMP");
  if (dump == nullptr || dump[0] == '\0') return {};
  return write_file_atomically(dump, facts());
}

}  // namespace replan::app
