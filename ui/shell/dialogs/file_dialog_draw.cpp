// How the file dialog looks.
#include <algorithm>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/base/file.hpp"
#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/shell/dialogs/file_dialog.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr float kPlaces = 160, kPreview = 268;
/// The most bytes of names that fonts are asked to hold.
constexpr std::size_t kMostWords = 20000;

/// In a narrow dialog the kind of file stands in a row of its own.
constexpr float kKind = 250;
bool foot_has_two_rows(const Look& look, float width, const std::string& action) {
  const float buttons = button_width(look, "Cancel") + look.px.s + button_width(look, action.c_str());
  return width < look.px(kKind) + look.px.m + buttons;
}

/// A part of the dialog with its own scroll bar.
template <class Draw>
void pane(const Look& look, const char* id, ImVec2 size, ImU32 ground, ImVec2 padding, Draw draw) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, look.px.radius);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ground);
  ImGui::BeginChild(id, size, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  draw();
  ImGui::EndChild();
}

}  // namespace

FileChoice FileDialog::draw(const Look& look, float height) {
  choice_ = {};
  if (std::optional<Result<std::vector<FileEntry>>> found = reader_.take()) {
    unreadable_ = *found ? "" : as_sentence(found->error());
    names_.clear();
    if (*found)
      for (const FileEntry& entry : **found)
        if (names_.size() < kMostWords) names_ += entry.name;
    list_.take(*found ? std::move(found->value()) : std::vector<FileEntry>());
    scroll_ = list_.select(std::exchange(came_from_, {}));
  }
  if (mode_ == Mode::browse && open_lists() == 0) take_keys();
  // Before anything is drawn: a picture that is on show must not be given back.
  preview_.show(spec_.fixed ? spec_.fixed->files : shown_, list_.selected());
  const float top = ImGui::GetCursorPosY();
  draw_head(look);
  draw_crumbs(look);
  draw_field(look);
  ImGui::Dummy({0, look.px(2)});
  const float rows = foot_has_two_rows(look, ImGui::GetContentRegionAvail().x, spec_.action) ? 1 : 0;
  const float foot = look.px.control + rows * (look.px.control + look.px.s) + look.px(44) +
                     (spec_.options ? look.px(spec_.options_height) : 0);
  const float body = std::max(height - (ImGui::GetCursorPosY() - top) - foot, look.px(120));
  const float whole = ImGui::GetContentRegionAvail().x;
  const bool told = !spec_.saving || spec_.losses || spec_.aside;
  const bool roomy = told && whole > look.px(760);
  const float preview = roomy ? look.px(kPreview) : 0, places = whole > look.px(520) ? look.px(kPlaces) : 0;
  const float gap = look.px.m;
  if (places > 0) {
    pane(look, "places", {places, body}, 0, {0, 0}, [&] { draw_places(look); });
    ImGui::SameLine(0, gap);
  }
  const float middle = whole - (places > 0 ? places + gap : 0) - (preview > 0 ? preview + gap : 0);
  pane(look, "files", {middle, body}, look.theme.background, {look.px(6), look.px(4)},
       [&] { draw_list(look); });
  if (roomy) {
    ImGui::SameLine(0, gap);
    pane(look, "preview", {preview, body}, look.theme.raised, {look.px.m, look.px.m}, [&] {
      if (spec_.aside)
        spec_.aside(look, spec_.folders ? chosen_folder() : text_);
      else if (spec_.saving)
        draw_losses(look);
      else
        preview_.draw(look);
    });
  }
  draw_foot(look);
  return choice_;
}

void FileDialog::draw_head(const Look& look) {
  const float buttons = look.px.small * 3 + look.px.xs * 2;
  text_line(look, look.fonts.heading, look.theme.text, spec_.title,
            ImGui::GetContentRegionAvail().x - buttons - look.px.s);
  ImGui::SameLine();
  align_right(buttons);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (look.px(20) - look.px.small) * 0.5f);
  const bool hidden = list_.hidden();
  if (small_button(look, "hidden",
                   {.icon = hidden ? icon::eye : icon::eye_slash,
                    .hint = {hidden ? "Hide hidden files" : "Show hidden files", "Ctrl+H",
                             "Files whose name begins with a dot."},
                    .selected = hidden}))
    list_.set_hidden(!hidden);
  ImGui::SameLine(0, look.px.xs);
  if (small_button(look, "folder", {.icon = icon::folder_add, .hint = {"New folder"}}) &&
      mode_ == Mode::browse) {
    mode_ = Mode::new_folder;
    pending_ = spec_.saving ? text_ : "";
    error_.clear();
    set_text("");
  }
  ImGui::SameLine(0, look.px.xs);
  if (small_button(look, "refresh", {.icon = icon::refresh, .hint = {"Read the folder again"}})) read();
}

void FileDialog::draw_crumbs(const Look& look) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  if (small_button(look, "up", {.icon = icon::arrow_up, .hint = {"To the folder above", "Backspace"}}))
    go_up();
  const std::vector<Crumb> all = crumbs(shown_);
  // A deep folder shows its end: that is where one is.
  float room = right - origin.x - look.px(48);
  std::size_t first = all.size();
  const auto width = [&](std::size_t i) { return text_width(look.fonts.ui, all[i].name) + look.px(22); };
  while (first > 0 && (room -= width(first - 1)) > 0) --first;
  std::string target;
  for (std::size_t i = std::min(first, all.size() - 1); i < all.size(); ++i) {
    ImGui::SameLine(0, 0);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float most = std::max(right - at.x - look.px(24), look.px(40));
    const float long_ = std::min(text_width(look.fonts.ui, all[i].name), most);
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("crumb", {long_ + look.px(22), look.px.small})) target = all[i].path;
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool last = i + 1 == all.size();
    const ImU32 colour = last || ImGui::IsItemHovered() ? look.theme.text : look.theme.dim;
    const float y = at.y + (look.px.small - look.fonts.ui->FontSize) * 0.5f;
    draw_line(look, list, look.fonts.ui, {at.x + look.px(4), y}, colour, all[i].name, most);
    if (!last)
      draw_icon(list, look.fonts.ui, {at.x + long_ + look.px(13), at.y + look.px.small * 0.5f},
                look.theme.faint, icon::angle_right);
  }
  if (!target.empty() && target != shown_) {
    came_from_.clear();
    go(target);
  }
}

void FileDialog::draw_field(const Look& look) {
  const char* placeholder = mode_ == Mode::new_folder ? "Name of the new folder"
                            : spec_.saving            ? "Name of the file"
                            : spec_.folders           ? "Type to filter, or a folder's path; Tab completes"
                                                      : "Type to filter, or a path or a link; Tab completes";
  const std::string before = text_;
  ImGui::PushID(generation_);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(look.px(10), (look.px.control - look.fonts.ui->FontSize) * 0.5f));
  ImGui::SetNextItemWidth(-1);
  // The field has the keyboard whatever is clicked, so that typing always means it. To take it would close a list.
  if (!ImGui::IsAnyItemActive() && mode_ != Mode::replace && open_lists() == 0) ImGui::SetKeyboardFocusHere();
  const bool proposed = spec_.saving && replaces_;
  ImGui::InputTextWithHint("##path", placeholder, &text_, proposed ? ImGuiInputTextFlags_AutoSelectAll : 0);
  if (look.focus != nullptr) look.focus->leave_tab_to_it();
  const bool typing = ImGui::IsItemActive();
  ImGui::PopStyleVar();
  ImGui::PopID();
  if (escape_pressed()) text_ = before;  // ImGui takes typing back; Escape is answered in the foot
  if (mode_ != Mode::browse) return;
  if (before.empty() && ImGui::IsKeyPressed(key::kBackspace, false)) go_up();
  if (text_ != before) replaces_ = false;
  if (typing && ImGui::IsKeyPressed(key::kTab)) set_text(completed(folder_, text_));
  if (text_ == before) return;
  error_.clear();
  follow_text();
}

void FileDialog::draw_places(const Look& look) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, look.px(2)));
  std::string target;
  for (std::size_t i = 0; i < spec_.places.size(); ++i) {
    const Place& place = spec_.places[i];
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px.control);
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("place", size)) target = place.path;
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool here = place.path == shown_, hovered = ImGui::IsItemHovered();
    if (here || hovered)
      list.AddRectFilled(min, {min.x + size.x, min.y + size.y}, here ? look.theme.selected : look.theme.hover,
                         look.px.radius);
    draw_icon(list, look.fonts.ui, {min.x + look.px(16), min.y + size.y * 0.5f},
              here ? look.theme.accent : look.theme.dim, place.icon);
    draw_line(look, list, look.fonts.ui,
              {min.x + look.px(32), min.y + (size.y - look.fonts.ui->FontSize) * 0.5f}, look.theme.text,
              place.label, size.x - look.px(38));
    hint(look, {"", "", place.path.c_str()});
  }
  ImGui::PopStyleVar();
  if (!target.empty()) go(target);
}

void FileDialog::draw_losses(const Look& look) {
  const FileFilter& kind = spec_.filters[static_cast<std::size_t>(filter_)];
  text(look.fonts.title, look.theme.text, kind.label);
  if (lost_.empty()) {
    text(look.fonts.ui, look.theme.good, icon::check);
    ImGui::SameLine(0, look.px.s);
    paragraph(look.fonts.ui, look.theme.dim, "Holds all of this document.");
    return;
  }
  paragraph(look.fonts.ui, look.theme.dim, "What is not kept in such a file:");
  for (const std::string& each : lost_) {
    text(look.fonts.ui, look.theme.warning, icon::warning);
    ImGui::SameLine(0, look.px.s);
    paragraph(look.fonts.ui, look.theme.text, as_sentence(each));
  }
}

void FileDialog::draw_question(const Look& look) {
  const bool replacing = mode_ == Mode::replace;
  const std::string words = replacing ? "'" + file_name(pending_) + "' is there already. Replace it?"
                                      : "The folder is made in '" + file_name(shown_) + "'.";
  const float y = ImGui::GetCursorPosY();
  const ImU32 colour = replacing ? look.theme.warning : look.theme.dim;
  if (foot_has_two_rows(look, ImGui::GetContentRegionAvail().x, spec_.action)) {
    paragraph(look.fonts.ui, colour, words);
  } else {
    ImGui::SetCursorPosY(y + (look.px.control - look.fonts.ui->FontSize) * 0.5f);
    text(look.fonts.ui, colour, words);
    ImGui::SameLine();
    ImGui::SetCursorPosY(y);
  }
  const char* yes = replacing ? "Replace" : "Make folder";
  align_right(button_width(look, "Back") + look.px.s + button_width(look, yes));
  const bool back = button(look, "Back", ButtonKind::quiet) || escape_pressed();
  ImGui::SameLine(0, look.px.s);
  const bool go_on =
      button(look, yes, replacing ? ButtonKind::danger : ButtonKind::primary) || enter_pressed();
  if (back) {
    if (!replacing) set_text(pending_);
    mode_ = Mode::browse;
    error_.clear();
  } else if (go_on && replacing) {
    mode_ = Mode::browse;
    choice_ = {Answer::yes, pending_, preview_.reading()};
  } else if (go_on) {
    make_folder();
  }
}

void FileDialog::draw_foot(const Look& look) {
  ImGui::Dummy({0, look.px(2)});
  if (error_.empty())
    ImGui::Dummy({0, look.fonts.ui->FontSize});
  else
    text_line(look, look.fonts.ui, look.theme.bad, error_, ImGui::GetContentRegionAvail().x);
  if (mode_ != Mode::browse) {
    draw_question(look);
    return;
  }
  if (spec_.options) spec_.options(look, text_);
  std::vector<const char*> labels;
  for (const FileFilter& filter : spec_.filters) labels.push_back(filter.label.c_str());
  const float room = ImGui::GetContentRegionAvail().x;
  const bool two = foot_has_two_rows(look, room, spec_.action);
  if (combo(look, "##kind", labels, filter_, two ? room : look.px(kKind))) {
    set_kind(filter_);
    if (spec_.saving && !text_.empty()) set_text(with_chosen_extension());
  }
  if (!two) ImGui::SameLine();
  align_right(button_width(look, "Cancel") + look.px.s + button_width(look, spec_.action.c_str()));
  const bool left = button(look, "Cancel", ButtonKind::quiet);
  ImGui::SameLine(0, look.px.s);
  const bool pressed = button(look, spec_.action.c_str(), ButtonKind::primary), entered = enter_pressed();
  if (spec_.folders && (pressed || entered)) accept_folder(!pressed);
  if (!spec_.folders && (pressed || entered)) accept();
  if (!left && !escape_pressed()) return;
  // The first Escape takes back the filter, the next one leaves.
  if (!left && !spec_.saving && !text_.empty())
    set_text("");
  else
    choice_.answer = Answer::no;
}

}  // namespace replan::ui
