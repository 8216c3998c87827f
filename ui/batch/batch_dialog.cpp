#include "ui/batch/batch_dialog.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <imgui.h>

#include "core/base/deadline.hpp"
#include "core/base/file.hpp"
#include "ui/icons.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Of one frame, for results that come to the table.
constexpr double kKeepMs = 4;
constexpr std::size_t kKeptAtOnce = 256;
constexpr const char* kBatchPopup = "batch dialog";
constexpr float kFormWidth = 760, kFormHeight = 300, kFormRest = 350, kResultsWidth = 1400,
                kResultsHeight = 760;

/// "40 s", "3 min", "2 h 5 min".
std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  const std::int64_t minutes = (whole + 30) / 60;
  if (minutes < 60) return std::to_string(minutes) + " min";
  return grouped(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

/// Of what there is to choose: in a low window it scrolls, and the buttons stay in sight.
float form_height(const Look& look) {
  return std::clamp(ImGui::GetIO().DisplaySize.y - look.px(kFormRest), look.px(80), look.px(kFormHeight));
}

BatchDialog::Wish wish_of(BatchFormWish asked) {
  switch (asked) {
    case BatchFormWish::open_experiment:
      return BatchDialog::Wish::open_experiment;
    case BatchFormWish::save_experiment:
      return BatchDialog::Wish::save_experiment;
    case BatchFormWish::choose_folder:
      return BatchDialog::Wish::choose_folder;
    case BatchFormWish::none:
      break;
  }
  return BatchDialog::Wish::none;
}

std::string runs_text(std::size_t count) {
  return count_text(static_cast<std::int64_t>(count), "run", "runs");
}

}  // namespace

void BatchDialog::show(const Session& session, std::string folder, const WorkPlace& place) {
  open_ = true;
  note_.clear();
  if (job_ == nullptr) {
    job_ = std::make_unique<BatchJob>(place);
    in_step_ = place.in_step;
    form_ = std::make_unique<BatchForm>(place);
    opening_ = std::make_unique<Background<Scenario>>(place);
  }
  form_->take_world(session, std::move(folder));
  if (page_ == Page::form) error_.clear();
  if (!job_->busy() && table().count() == 0) page_ = Page::form;
}

/// The batch that is at work, or its table, is not thrown away for another one: "New batch…" leads to the form.
void BatchDialog::take_experiment(const std::string& path) {
  error_.clear();
  form_->take_experiment(path);
  if (job_->busy())
    note_ = file_name(path) + " is taken for the next batch: New batch… shows it once this one is done.";
  else
    page_ = Page::form;
}

void BatchDialog::take_folder(const std::string& folder) {
  error_.clear();
  form_->take_folder(folder);
  if (!job_->busy()) page_ = Page::form;
}

void BatchDialog::save_experiment(const std::string& path) {
  error_.clear();
  const auto request = page_ == Page::form ? form_->request() : Result<BatchRequest>(request_);
  const auto put =
      request ? put_world(request->what, file_folder(path)) : Result<Experiment>(Error{request.error()});
  if (!put) {
    error_ = put.error();
    return;
  }
  // The file dialog has asked whether an older file may go.
  const auto written = write_file_atomically(path, experiment_text(*put));
  if (!written) error_ = written.error();
  if (written) note_ = "Saved the experiment as " + file_name(path) + ", and its world beside it.";
}

void BatchDialog::exhibit(BatchRequest request, const std::vector<RunResult>& results,
                          const BatchProgress& progress) {
  page_ = Page::results;
  request_ = std::move(request);
  view_.clear();
  view_.table().add(results);
  exhibited_ = progress;
}

void BatchDialog::start(BatchRequest request) {
  request_ = std::move(request);
  error_.clear();
  note_.clear();
  view_.clear();
  page_ = Page::results;
  job_->start(request_);
}

void BatchDialog::open_run(std::int64_t run) {
  const auto list = job_->list();
  if (list == nullptr) return;
  // Blocks that drop ahead of the robot are placed by a search.
  opening_->start([list, run](const StopToken&) { return list->scenario(list->parts(run)); });
}

std::optional<Scenario> BatchDialog::take_run() {
  auto run = opening_ ? opening_->take() : std::nullopt;
  if (run) open_ = false;
  return run;
}

/// A folder may hold a hundred thousand results: they come to the table over several frames.
void BatchDialog::keep() {
  if (job_ == nullptr) return;
  const Deadline deadline = in_step_ ? Deadline::never() : Deadline(kKeepMs);
  const auto take = [this] {
    const auto results = job_->take_results(kKeptAtOnce);
    view_.table().add(results);
    return results.size() == kKeptAtOnce;
  };
  behind_ = take();
  while (behind_ && !deadline.passed()) behind_ = take();
  if (behind_) return;
  const auto end = job_->take_end();
  if (!end) return;
  while (take()) {
  }  // what came between the two calls
  error_ = end->error;
  if (!error_.empty() && table().count() == 0) page_ = Page::form;
}

std::optional<BatchProgress> BatchDialog::at_work() const {
  return job_ && job_->busy() ? std::optional(progress()) : std::nullopt;
}

BatchProgress BatchDialog::progress() const {
  if (exhibited_) return *exhibited_;
  BatchProgress now = job_->progress();
  now.done = table().count();  // what is told is what is seen
  return now;
}

bool BatchDialog::complete() const {
  const BatchProgress now = progress();
  return now.all > 0 && now.done == now.all;
}

std::string BatchDialog::why_not() const {
  const auto request = form_ ? form_->request() : Result<BatchRequest>(Error{"nothing is chosen"});
  return request ? "" : request.error();
}

std::string BatchDialog::words() const {
  return request_.folder + request_.what.experiment.name + (form_ ? form_->words() : "");
}

std::string BatchDialog::progress_words() const {
  const BatchProgress now = progress();
  const std::string done = grouped(now.done) + " of " + runs_text(now.all);
  if (exhibited_ || job_->busy()) {
    if (now.all == 0) return "Reading the worlds…";
    if (job_ && !exhibited_ && now.done == now.all)
      return "All " + runs_text(now.all) + " are done: writing results.csv, results.json and times.csv.";
    if (job_ && job_->paused()) return "Paused: " + done + " are done.";
    if (!now.seconds_left) return done + " are done.";
    return done + " are done, and about " + duration_text(*now.seconds_left) + " are left.";
  }
  if (complete())
    return "All " + runs_text(now.all) + " are done. The folder has results.csv, results.json and times.csv.";
  return "Stopped: " + done + " are done and kept. The others are made when it goes on.";
}

std::string BatchDialog::command_line() const {
  const std::string folder = std::filesystem::absolute(request_.folder).lexically_normal().string();
  const std::string file = request_.what.world ? folder + "/" + kExperimentFile
                                               : std::filesystem::absolute(file_).lexically_normal().string();
  return batch_command_line(file, folder, request_.jobs);
}

BatchDialog::Wish BatchDialog::draw(const Look& look) {
  wish_ = Wish::none;
  if (!open_) return wish_;
  if (!ImGui::IsPopupOpen(kBatchPopup)) ImGui::OpenPopup(kBatchPopup);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float wanted = look.px(page_ == Page::form ? kFormWidth : kResultsWidth);
  const float width = std::min(wanted, screen.x - look.px(32));
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Always, {0.5f, 0.45f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - look.px(32)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(24), look.px(20)));
  const bool shown =
      ImGui::BeginPopupModal(kBatchPopup, nullptr,
                             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar();
  if (!shown) return wish_;
  if (page_ == Page::form)
    draw_form(look);
  else
    draw_results(look);
  if (!open_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return wish_;
}

/// What is wrong, what was done, or what there is to expect.
void BatchDialog::draw_prospect(const Look& look) const {
  if (!error_.empty()) return paragraph(look.fonts.ui, look.theme.bad, as_sentence(error_) + ".");
  if (const std::string why = why_not(); !why.empty())
    return paragraph(look.fonts.ui, look.theme.warning, as_sentence(why) + ".");
  if (!note_.empty()) return paragraph(look.fonts.ui, look.theme.good, note_);
  if (const HeldResults* held = form_->gone_on_with())
    return paragraph(
        look.fonts.ui, look.theme.dim,
        held->complete()
            ? "Nothing is made again: the table shows what is there."
            : "The other " + runs_text(static_cast<std::size_t>(held->runs - held->done)) + " are made.");
  if (const auto runs = form_->runs())
    paragraph(look.fonts.ui, look.theme.dim,
              "That makes " + runs_text(static_cast<std::size_t>(*runs)) + "." +
                  (form_->seeds_are_one() ? " Where nothing is drawn by chance, one seed says it all."
                   : *runs > 1            ? " How long that takes is told after the first of them."
                                          : ""));
}

void BatchDialog::draw_form(const Look& look) {
  heading(look, "Batch");
  const BatchFormWish asked = form_->draw(look, form_height(look));
  if (asked != BatchFormWish::none) {
    note_.clear();
    error_.clear();
    wish_ = wish_of(asked);
  }
  ImGui::Dummy({0, look.px.xs});
  draw_prospect(look);
  const HeldResults* held = form_->gone_on_with();
  const Answer answer = confirm(look, held == nullptr    ? "Start"
                                      : held->complete() ? "Show the results"
                                                         : "Go on");
  if (answer == Answer::no) open_ = false;
  if (answer != Answer::yes) return;
  auto request = form_->request();
  if (!request) return;  // why not is told already
  file_ = form_->file();
  start(std::move(request.value()));
}

/// Of a batch that is at work: wait, go on, stop.
void BatchDialog::draw_work_buttons(const Look& look) {
  const bool paused = job_ && job_->paused();
  if (paused && button(look, "Go on", ButtonKind::primary, icon::play)) job_->go_on();
  if (!paused && button(look, "Pause", ButtonKind::plain, icon::pause) && job_) job_->pause();
  if (!paused) hint(look, {"Pause", "", "Runs that are being made are finished, and no others begun."});
  flow(look, button_width(look, "Stop", icon::stop));
  if (button(look, "Stop", ButtonKind::plain, icon::stop) && job_) job_->stop();
  hint(look, {"Stop", "", "What is done is kept; the same batch goes on later, here or by its command."});
}

void BatchDialog::draw_buttons(const Look& look) {
  const bool busy = exhibited_ || job_->busy();
  const bool goes_on = !busy && !complete();
  if (busy) draw_work_buttons(look);
  if (goes_on && button(look, "Go on", ButtonKind::primary, icon::play)) start(request_);
  if (busy || goes_on) flow(look, button_width(look, "Copy the command", icon::copy));
  if (button(look, "Copy the command", ButtonKind::plain, icon::copy)) {
    ImGui::SetClipboardText(command_line().c_str());
    note_ = "Copied: " + command_line();
  }
  hint(look, {"Copy the command", "", "The command line that makes the same runs, here or on a cluster."});
  if (request_.what.world) {
    flow(look, button_width(look, "Save as an experiment…", icon::save));
    if (button(look, "Save as an experiment…", ButtonKind::quiet, icon::save)) wish_ = Wish::save_experiment;
    hint(look, {"Save as an experiment", "",
                "A file, and the world beside it, with which replan batch makes the same runs elsewhere."});
  }
  if (busy) return;
  flow(look, button_width(look, "New batch…", icon::plus));
  if (!button(look, "New batch…", ButtonKind::quiet, icon::plus)) return;
  page_ = Page::form;
  error_.clear();
  note_.clear();
}

void BatchDialog::draw_results(const Look& look) {
  const float top = ImGui::GetCursorPosY();
  const std::string& name = request_.what.experiment.name;
  heading(look, name.empty() ? "Batch" : "Batch: " + name);
  draw_buttons(look);
  ImGui::Dummy({0, look.px.xs});
  const BatchProgress now = progress();
  if (!error_.empty())
    paragraph(look.fonts.ui, look.theme.bad, as_sentence(error_) + ".");
  else
    ui::progress(look, now.all == 0 ? -1.0f : static_cast<float>(now.done) / static_cast<float>(now.all),
                 progress_words());
  text_line(look, look.fonts.small, look.theme.faint, note_.empty() ? request_.folder : note_,
            ImGui::GetContentRegionAvail().x);
  ImGui::Dummy({0, look.px.xs});
  const float whole = std::min(ImGui::GetIO().DisplaySize.y - look.px(72), look.px(kResultsHeight));
  const float foot = look.px.control + look.px(32);
  if (const auto run = view_.draw(look, whole - (ImGui::GetCursorPosY() - top) - foot)) open_run(*run);
  ImGui::Dummy({0, look.px.xs});
  align_right(button_width(look, "Close"));
  if (button(look, "Close", ButtonKind::plain) || escape_pressed()) open_ = false;
}

}  // namespace replan::ui
