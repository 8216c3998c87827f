// How the form of a batch looks.
#include <algorithm>
#include <array>
#include <string>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/base/file.hpp"
#include "core/world/choices.hpp"
#include "ui/batch/batch_form.hpp"
#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Where planners and settings have no room beside each other.
bool is_narrow(const Look& look, float width) {
  return width < look.px(480);
}

constexpr const char* kSaveExperiment = "Save as an experiment…";
constexpr std::uint64_t kMostJobs = 256;

/// A whole number with its label; what is typed beyond the bounds becomes the nearest of them.
void whole_number(const Look& look, const char* label, std::uint64_t& value, std::uint64_t low,
                  std::uint64_t high, const char* teach) {
  ImGui::AlignTextToFramePadding();
  text(look.fonts.ui, look.theme.dim, label);
  ImGui::SameLine(look.px(132));
  ImGui::SetNextItemWidth(look.px(110));
  ImGui::PushID(label);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px.s, look.px.xs));
  if (number_field(look, "##number", ImGuiDataType_U64, &value)) value = std::clamp(value, low, high);
  ImGui::PopStyleVar();
  ImGui::PopID();
  hint(look, {label, "", teach});
}

void whole_number(const Look& look, const char* label, int& value, int low, int high, const char* teach) {
  auto number = static_cast<std::uint64_t>(value);
  whole_number(look, label, number, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high), teach);
  value = static_cast<int>(number);
}

constexpr const char* kTakeHeld = "Take its settings";

/// "This folder holds 12 of the 60 runs of Sixty.", and what to do where that cannot be gone on with here.
std::string held_words(const HeldResults& held) {
  const std::string name = held.name.empty() ? "an experiment" : held.name;
  const std::string runs = count_text(held.runs, "run", "runs");
  const std::string words = "This folder holds " +
                            (held.complete() ? "all " + runs : grouped(held.done) + " of " + runs) + " of " +
                            name + ".";
  if (!held.file.empty()) return words;
  return words + " The experiment's file is not beside it: open it above to go on with these results.";
}

}  // namespace

BatchFormWish BatchForm::draw(const Look& look, float height) {
  if (auto loaded = loader_.take()) loaded_ = std::move(*loaded);
  look_into_folder();
  BatchFormWish wish = BatchFormWish::none;
  if (button(look, "Open an experiment…", ButtonKind::plain, icon::folder_open))
    wish = BatchFormWish::open_experiment;
  hint(look, {"Open an experiment", "",
              "Its file says which planners, worlds, robots, seeds and surprises: docs/batches.md."});
  if (file_.empty()) {
    flow(look, button_width(look, kSaveExperiment, icon::save));
    if (button(look, kSaveExperiment, ButtonKind::quiet, icon::save)) wish = BatchFormWish::save_experiment;
    hint(look, {"Save as an experiment", "",
                "A file, and the world beside it, with which replan batch makes the same runs elsewhere."});
  }
  ImGui::Dummy({0, look.px.xs});
  if (!file_.empty()) {
    draw_file(look);
  } else {
    draw_choices(look, height);
  }
  ImGui::Dummy({0, look.px.xs});
  if (draw_folder(look)) wish = BatchFormWish::choose_folder;
  draw_held(look);
  return wish;
}

/// Side by side, or one below the other where that is too narrow.
void BatchForm::draw_choices(const Look& look, float height) {
  const float whole = ImGui::GetContentRegionAvail().x;
  if (is_narrow(look, whole)) {
    ImGui::BeginChild("choices", {0, height});
    draw_planners(look);
    ImGui::Dummy({0, look.px.s});
    draw_settings(look);
    ImGui::EndChild();
    return;
  }
  ImGui::BeginChild("planners", {whole * 0.5f - look.px.l, height});
  draw_planners(look);
  ImGui::EndChild();
  ImGui::SameLine(0, look.px(32));
  ImGui::BeginChild("settings", {0, height});
  draw_settings(look);
  ImGui::EndChild();
}

void BatchForm::draw_planners(const Look& look) {
  section_title(look, "Planners");
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    Candidate& each = candidates_[i];
    const std::string label =
        elide(look.fonts.ui, each.label, ImGui::GetContentRegionAvail().x - look.px(44)) + "##" +
        std::to_string(i);
    if (!each.why_not.empty()) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.45f);
    bool on = each.on;
    toggle(look, label.c_str(), on);
    if (each.why_not.empty())
      each.on = on;
    else
      ImGui::PopStyleVar();
    const std::string summary(find_choice(each.choice.id)->summary);
    hint(look, {each.label.c_str(), "", each.why_not.empty() ? summary.c_str() : each.why_not.c_str()});
  }
}

void BatchForm::draw_settings(const Look& look) {
  section_title(look, "Runs");
  whole_number(look, "First seed", first_seed_, 0, UINT64_MAX - kMostPlanned,
               "Planners that draw by chance and random surprises take it from here.");
  whole_number(look, "Seeds", seeds_, 1, kMostPlanned,
               "How many, one after the other. Where nothing is drawn by chance, one run says it all.");
  whole_number(look, "Times each", repeat_, 1, kMostPlanned,
               "How often each run is timed. All else is the same every time.");
  ImGui::Dummy({0, look.px.xs});
  toggle(look, "The robot drives", drive_);
  hint(look, {"The robot drives", "",
              "It senses, replans and drives to the goal. Off: it is planned once, on the map as it is."});
  ImGui::Dummy({0, look.px.xs});
  if (drive_) draw_surprises(look);
}

void BatchForm::draw_surprises(const Look& look) {
  static constexpr std::array<const char*, 3> kNames = {"None", "The world's", "Random"};
  section_title(look, "Surprises");
  segments(look, "surprises", kNames, surprises_);
  ImGui::Dummy({0, look.px.xs});
  if (static_cast<ExperimentSurprises::Kind>(surprises_) != ExperimentSurprises::Kind::blocks) return;
  whole_number(
      look, "Blocks", blocks_.count, 1, kMostBlocks,
      "Nobody has mapped them. Each drops ahead of the robot, on a shortest way; a way past all is left.");
  whole_number(look, "Side", blocks_.side, 1, kLongestBlock, "Cells that a block is wide and high.");
  blocks_.ahead = std::max(blocks_.ahead, static_cast<double>(blocks_.side + kBlockMargin));
}

void BatchForm::draw_file(const Look& look) {
  text_line(look, look.fonts.title, look.theme.text, file_name(file_), ImGui::GetContentRegionAvail().x);
  if (!from_file_) return;
  const Experiment& read = *from_file_;
  if (!read.name.empty()) paragraph(look.fonts.ui, look.theme.dim, read.name);
  const auto count = [](std::size_t number) { return grouped(static_cast<std::int64_t>(number)); };
  fact(look, "Planners", count(read.planners.size()));
  fact(look, "Worlds", count(read.worlds.size()));
  fact(look, "Robots", count(read.robots.size()));
  fact(look, "Seeds", count(read.seeds.size()));
  fact(look, "Drives", read.drive ? "yes" : "no");
  if (loader_.busy()) paragraph(look.fonts.ui, look.theme.dim, "Reading its worlds…");
}

/// True if the user wants to choose one.
bool BatchForm::draw_folder(const Look& look) {
  const auto field_height = (look.px.control - look.fonts.mono->FontSize) * 0.5f;
  ImGui::AlignTextToFramePadding();
  text(look.fonts.ui, look.theme.dim, "Results go to");
  if (!is_narrow(look, ImGui::GetContentRegionAvail().x)) ImGui::SameLine(look.px(132));
  const float jobs = look.px(116), choose = look.px.small + look.px.s;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - jobs - choose);
  if (look.focus != nullptr) look.focus->offer_field("##folder");
  ImGui::PushFont(look.fonts.mono);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px(10), field_height));
  ImGui::InputTextWithHint("##folder", "a folder", &folder_);
  // Escape takes the typing back, and is not for the dialog then.
  if (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) key::take(ImGui::GetIO(), key::kEscape);
  ImGui::PopStyleVar();
  ImGui::PopFont();
  hint(
      look,
      {"Folder of the results", "",
       "Each run is kept there as soon as it is done. A batch that was stopped goes on with what is there."});
  ImGui::SameLine(0, look.px.s);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (look.px.control - look.px.small) * 0.5f);
  const bool chooses =
      small_button(look, "choose folder",
                   {.icon = icon::folder_open,
                    .hint = {"Choose the folder", "",
                             "One that holds results gives its experiment, which goes on with them."}});
  ImGui::SameLine(0, look.px.m);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - (look.px.control - look.px.small) * 0.5f);
  draw_jobs(look);
  return chooses;
}

void BatchForm::draw_jobs(const Look& look) {
  text(look.fonts.ui, look.theme.dim, "Jobs");
  ImGui::SameLine(0, look.px.s);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(look.px.s, (look.px.control - look.fonts.mono->FontSize) * 0.5f));
  if (number_field(look, "##jobs", ImGuiDataType_U64, &jobs_))
    jobs_ = std::clamp<std::uint64_t>(jobs_, 1, kMostJobs);
  ImGui::PopStyleVar();
  hint(look, {"Jobs", "", "Runs at a time. More than one are done sooner, but disturb each other's times."});
}

/// What the folder holds already, and how to go on with it.
void BatchForm::draw_held(const Look& look) {
  if (!held_.error.empty())
    return paragraph(look.fonts.ui, look.theme.warning, as_sentence(held_.error) + ".");
  if (!held_.results || !held_.results->whole()) return;  // of a part request() tells
  const HeldResults& held = *held_.results;
  const std::string words = held_words(held);
  const bool other = gone_on_with() == nullptr && !held.file.empty();
  if (!other) return paragraph(look.fonts.ui, look.theme.text, words);
  ImGui::AlignTextToFramePadding();
  const float room = ImGui::GetContentRegionAvail().x - button_width(look, kTakeHeld) - look.px.m;
  text_line(look, look.fonts.ui, look.theme.text, words, room);
  ImGui::SameLine();
  align_right(button_width(look, kTakeHeld));
  if (button(look, kTakeHeld, ButtonKind::plain)) take_held();
  hint(look, {kTakeHeld, "", "Takes the experiment of these results, so that it goes on where it was."});
}

}  // namespace replan::ui
