#include "ui/shell/dialogs.hpp"

#include <algorithm>
#include <utility>

#include "ui/shell/dialogs/parts.hpp"

namespace replan::ui {
namespace {

constexpr const char* kPopup = "dialog";
/// What is read faster than this is not announced.
constexpr double kAMoment = 0.15;  // seconds

/// Of the design.
float width_of(DialogKind kind) {
  switch (kind) {
    case DialogKind::file:
      return 1040;
    case DialogKind::worlds:
      return 1080;
    case DialogKind::keys:
      return 1400;
    case DialogKind::recover:
      return 600;
    case DialogKind::link:
      return 640;
    default:
      return 460;
  }
}

/// Decisions that may yet fail: their dialog stays until its owner closes it.
bool may_fail(DialogDecision::Kind kind) {
  return kind == DialogDecision::Kind::open || kind == DialogDecision::Kind::open_world ||
         kind == DialogDecision::Kind::save || kind == DialogDecision::Kind::recover ||
         kind == DialogDecision::Kind::forget;
}

}  // namespace

void Dialogs::show(DialogKind kind) {
  close();
  begin(kind);
}

void Dialogs::begin(DialogKind kind) {
  kind_ = kind;
  fresh_ = true;
}

void Dialogs::ask(Question question) {
  question_ = std::move(question);
  show(DialogKind::question);
}

void Dialogs::choose_file(FileDialogSpec spec, const WorkPlace& place, DialogDecision::Kind decision) {
  close();
  if (system_.pick && !spec.saving) return system_.pick(spec.filters);
  file_decision_ = decision;
  file_ = std::make_unique<FileDialog>(renderer_, place, std::move(spec));
  begin(DialogKind::file);
}

void Dialogs::choose_world(WorldLibrary& library) {
  close();
  worlds_ = std::make_unique<WorldPicker>(renderer_, library);
  begin(DialogKind::worlds);
}

void Dialogs::offer(std::vector<AutosaveNote> notes) {
  notes_ = std::move(notes);
  show(DialogKind::recover);
}

void Dialogs::show_about(std::vector<AboutLine> lines) {
  about_ = std::move(lines);
  show(DialogKind::about);
}

void Dialogs::show_keys(const StepWords& step) {
  step_ = step;
  show(DialogKind::keys);
}

void Dialogs::wait_for(std::string name) {
  name_ = std::move(name);
  since_ = -1;
  begin(DialogKind::opening);  // the dialog that led here stays behind it
}

void Dialogs::close() {
  kind_ = DialogKind::none;
  if (file_) folder_ = file_->folder();
  if (file_) closed_file_ = std::move(file_);
  if (worlds_) closed_worlds_ = std::move(worlds_);
}

bool Dialogs::complain(const std::string& sentence) {
  if (file_) {
    file_->complain(sentence);
    kind_ = DialogKind::file;
  } else if (worlds_) {
    worlds_->complain(sentence);
    kind_ = DialogKind::worlds;
  }
  return file_ || worlds_;
}

std::string Dialogs::words() const {
  // Also while it only waits behind another one: new fonts cost more than a frame.
  if (file_) return file_->words();
  if (worlds_) return worlds_->words();
  std::string words = kind_ == DialogKind::question ? question_.words : "";
  if (kind_ == DialogKind::recover)
    for (const AutosaveNote& note : notes_) words += note.file + note.name;
  return words;
}

DialogDecision Dialogs::draw(const Look& look) {
  closed_file_.reset();
  closed_worlds_.reset();
  if (kind_ == DialogKind::none) return {};
  if (since_ < 0) since_ = ImGui::GetTime();
  // Before its moment has passed a dialog that only waits keeps the hands off the world, unseen.
  const bool unseen = kind_ == DialogKind::opening && ImGui::GetTime() - since_ < kAMoment;
  if (!ImGui::IsPopupOpen(kPopup)) ImGui::OpenPopup(kPopup);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(look.px(width_of(kind_)), screen.x - look.px(32));
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Always, {0.5f, 0.45f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - look.px(32)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(24), look.px(20)));
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, unseen ? 0.0f : 1.0f);
  if (unseen) ImGui::PushStyleColor(ImGuiCol_ModalWindowDimBg, IM_COL32_BLACK_TRANS);
  const bool shown =
      ImGui::BeginPopupModal(kPopup, nullptr,
                             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  if (unseen) ImGui::PopStyleColor();
  DialogDecision decision;
  if (shown) {
    decision = content(look);
    const int lists = open_lists();
    unsettled_ = std::exchange(lists_, lists) != lists ? 3 : std::max(unsettled_ - 1, 0);
    fresh_ = false;
    if (decision.kind != DialogDecision::Kind::none && !may_fail(decision.kind)) close();
    if (kind_ == DialogKind::none) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
  return decision;
}

DialogDecision Dialogs::content(const Look& look) {
  const float tallest = ImGui::GetIO().DisplaySize.y - look.px(32) - look.px(40);
  switch (kind_) {
    case DialogKind::file:
      return file_dialog(look, std::min(tallest, look.px(640)));
    case DialogKind::worlds:
      return world_dialog(look, std::min(tallest, look.px(680)));
    case DialogKind::opening:
      return opening_dialog(look);
    case DialogKind::new_world:
      return new_world_dialog(look);
    case DialogKind::question:
      return question_dialog(look);
    case DialogKind::recover:
      return recover_dialog(look);
    case DialogKind::keys:
      return keys_dialog(look);
    case DialogKind::link:
      return link_dialog(look);
    case DialogKind::about:
      return about_dialog(look);
    case DialogKind::none:
      break;
  }
  return {};
}

DialogDecision Dialogs::file_dialog(const Look& look, float height) {
  const FileChoice choice = file_->draw(look, height);
  DialogDecision decision;
  decision.path = choice.path;
  decision.reading = choice.reading;
  if (choice.answer == Answer::no) decision.kind = DialogDecision::Kind::cancel;
  if (choice.answer == Answer::yes)
    decision.kind = file_decision_ != DialogDecision::Kind::none ? file_decision_
                    : file_->saving()                            ? DialogDecision::Kind::save
                                                                 : DialogDecision::Kind::open;
  decision.film = film_.choice();
  decision.map = trace_map_;
  return decision;
}

DialogDecision Dialogs::world_dialog(const Look& look, float height) {
  const FileChoice choice = worlds_->draw(look, height);
  DialogDecision decision;
  decision.path = choice.path;
  if (choice.answer == Answer::no) decision.kind = DialogDecision::Kind::cancel;
  if (choice.answer == Answer::yes) decision.kind = DialogDecision::Kind::open_world;
  return decision;
}

}  // namespace replan::ui
