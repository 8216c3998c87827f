#include "app/gui_program.hpp"

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
#include "app/gui_settings.hpp"
#include "app/platform/surroundings.hpp"
#include "app/platform/window.hpp"
#include "core/base/cpu_time.hpp"
#include "core/base/file.hpp"
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

/// What the window remembers of its shell as it is there, each with its place in the shell.
template <class Carry>
void each_remembered(Remembered& remembered, ui::Shell& shell, Carry carry) {
  ui::ViewState& looks = shell.view();
  carry(remembered.dark, looks.dark);
  carry(remembered.size_step, looks.size_step);
  carry(remembered.large_targets, looks.large_targets);
  carry(remembered.panels, looks.panels);
  carry(remembered.legend, looks.legend);
  carry(remembered.metres, looks.metres);
  carry(remembered.minimap, looks.minimap);
  carry(remembered.colours, looks.colours);
  carry(remembered.brush, looks.brush);
  carry(remembered.round_brush, looks.editing.round);
  carry(remembered.tab, looks.tab);
  ui::PanelState& panels = shell.panels();
  carry(remembered.side_width, panels.side_width);
  carry(remembered.side_share, panels.side_share);
  carry(remembered.unit, panels.unit);
  carry(remembered.caption, panels.caption);
}

}  // namespace

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
  capture_.emplace(*window_, *shell_, session_);
  each_remembered(remembered_, *shell_, [](const auto& remembered, auto& shown) { shown = remembered; });
  shell_->view().view.range = remembered_.colours_so_far ? FieldSpan::so_far : FieldSpan::whole_run;
  window_->stage().set_size(shell_->view().size());
  if (!remembered_.link_address.empty()) shell_->panels().link_address = remembered_.link_address;
  shell_->panels().notices = window_->stage().notices();
  shell_->panels().about = about_lines();
  shell_->show(session_.scenario());
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
  const double seconds = capture_->seconds(passed);
  last_ = now;
  const double begin_ms = thread_cpu_ms();
  session_.set_share(shell_->work_share(session_, drawing_ms_));
  session_.update(seconds);
  const Clock::time_point updated = Clock::now();
  const double updated_ms = thread_cpu_ms();
  capture_->report();
  shell_->draw(window_->stage().look(), session_, seconds);
  const double spent = milliseconds(Clock::now() - now);
  const auto lately = [](double before, double ms) { return before == 0 ? ms : before * 0.9 + ms * 0.1; };
  draw_ms_ = lately(draw_ms_, spent);
  drawing_ms_ = lately(drawing_ms_, milliseconds(Clock::now() - updated));
  shell_->panels().frame_ms = draw_ms_;
  if (timing_) report_slow_frame(updated_ms - begin_ms, thread_cpu_ms() - updated_ms);
  follow();
  if (!timed_) report_first_frame();
  capture_->follow();
  return shell_->wants_frames(session_) || capture_->wants_frames();
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
      {"dark", shell_->view().dark},
      {"opengl_es", window_->stage().renderer().gl().es},
      {"mission", decision == nullptr ? "planning" : mission_state_name(decision->state)}};
  return json.dump(2) + "\n";
}

void GuiProgram::remember() {
  remembered_.window = window_->state();
  each_remembered(remembered_, *shell_, [](auto& remembered, const auto& shown) { remembered = shown; });
  remembered_.colours_so_far = shell_->view().view.range == FieldSpan::so_far;
  remembered_.link_address = shell_->panels().link_address;
  remembered_.speed = session_.playback().expansions_per_second;
  if (const Result<void> written = write_settings(remembered_, settings_path()); !written)
    std::fprintf(stderr, "replan: %s\n", written.error().c_str());
}

Result<void> GuiProgram::close() {
  capture_->end();
  shell_->documents().leave();
  remember();
  const char* dump = std::getenv("REPLAN_STATE_DUMP");
  if (dump == nullptr || dump[0] == '\0') return {};
  return write_file_atomically(dump, facts());
}

}  // namespace replan::app
