// How the file dialog looks.
#include <algorithm>
#include <array>
#include <ctime>

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

constexpr float kPlaces = 160, kPreview = 268, kSizeColumn = 84, kDateColumn = 104;
/// The most bytes of names that fonts are asked to hold.
constexpr std::size_t kMostWords = 20000;

const char* icon_of(FileKind kind) {
  switch (kind) {
    case FileKind::folder:
      return icon::folder;
    case FileKind::scenario:
      return icon::map;
    case FileKind::map:
      return icon::grid_fine;
    case FileKind::picture:
      return icon::picture;
    case FileKind::problems:
      return icon::list;
    case FileKind::experiment:
    case FileKind::results:
      return icon::table;
    case FileKind::other:
      break;
  }
  return icon::file;
}

/// The right ends of the columns of figures, in a list of that width; those of which a narrow one leaves out have none.
struct FileColumns {
  FileColumns(const Look& look, float left, float width) {
    const float right = left + width - look.px(8);
    has_date = width >= look.px(420), has_size = width >= look.px(280);
    date = right - (has_date ? look.px(kDateColumn) : 0);
    size = date - (has_size ? look.px(kSizeColumn) : 0);
  }
  bool has_date, has_size;
  float date, size;  ///< where they begin
};

float row_height(const Look& look) {
  return look.px.fingers ? look.px.row : look.px(26);
}

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
  text(look.fonts.heading, look.theme.text, spec_.title);
  ImGui::SameLine();
  align_right(look.px.small * 3 + look.px.xs * 2);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - look.px(2));
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
    if (ImGui::InvisibleButton("crumb", {long_ + look.px(22), look.px(24)})) target = all[i].path;
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool last = i + 1 == all.size();
    const ImU32 colour = last || ImGui::IsItemHovered() ? look.theme.text : look.theme.dim;
    const float y = at.y + (look.px(24) - look.fonts.ui->FontSize) * 0.5f;
    draw_line(look, list, look.fonts.ui, {at.x + look.px(4), y}, colour, all[i].name, most);
    if (!last)
      draw_icon(list, look.fonts.ui, {at.x + long_ + look.px(13), at.y + look.px(12)}, look.theme.faint,
                icon::angle_right);
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

void FileDialog::draw_header(const Look& look) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const FileColumns columns(look, origin.x, ImGui::GetContentRegionAvail().x);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto head = [&](const char* name, FileOrder order, float x, float width, bool from_right) {
    ImGui::SetCursorScreenPos({x, origin.y});
    if (ImGui::InvisibleButton(name, {width, look.px(24)})) list_.sort_by(order);
    const bool chosen = list_.order() == order;
    const ImU32 colour = chosen || ImGui::IsItemHovered() ? look.theme.dim : look.theme.faint;
    const std::string shown = std::string(name) + (!chosen              ? ""
                                                   : list_.descending() ? std::string(" ") + icon::caret_down
                                                                        : std::string(" ") + icon::caret_up);
    const float at = from_right ? x + width - text_width(look.fonts.small, shown) : x;
    draw_text(list, look.fonts.small, {at, origin.y + look.px(6)}, colour, shown);
  };
  head("Name", FileOrder::name, origin.x + look.px(30), columns.size - origin.x - look.px(30), false);
  if (columns.has_size) head("Size", FileOrder::size, columns.size, look.px(kSizeColumn), true);
  if (columns.has_date) head("Changed", FileOrder::date, columns.date, look.px(kDateColumn), true);
  ImGui::SetCursorScreenPos({origin.x, origin.y + look.px(26)});
}

void FileDialog::draw_list(const Look& look) {
  if (!unreadable_.empty()) {
    empty_state(look, icon::lock, "This folder cannot be shown", unreadable_);
    return;
  }
  draw_header(look);
  if (list_.entries().empty()) {
    const bool waits = reader_.busy();
    if (spec_.folders && !waits) {
      empty_state(look, icon::folder_open, "No folders in it", "Choose takes this folder itself.");
      return;
    }
    const std::string out = list_.left_out() == 0 ? "Nothing is in this folder."
                                                  : count_text(static_cast<std::int64_t>(list_.left_out()),
                                                               "file is", "files are") +
                                                        " left out by the kind, the filter or as hidden.";
    empty_state(look, icon::folder_open, waits ? "Reading the folder…" : "No files to show",
                waits ? "" : out);
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("rows");
  const float row = row_height(look);
  if (std::exchange(scroll_, false) && list_.selected() != nullptr) {
    const float y = row * static_cast<float>(list_.selected_index()), seen = ImGui::GetWindowHeight();
    if (y < ImGui::GetScrollY()) ImGui::SetScrollY(y);
    if (y + row > ImGui::GetScrollY() + seen) ImGui::SetScrollY(y + row - seen);
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(list_.entries().size()), row);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      if (static_cast<std::size_t>(i) >= list_.entries().size()) break;  // a double click has left the folder
      draw_row(look, static_cast<std::size_t>(i));
    }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void FileDialog::draw_row(const Look& look, std::size_t index) {
  const FileEntry entry = list_.entries()[index];
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, row_height(look));
  ImGui::PushID(static_cast<int>(index));
  const bool clicked = ImGui::InvisibleButton("row", size);
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered(), chosen = list_.selected_index() == index;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (chosen || hovered)
    list.AddRectFilled(min, {min.x + size.x, min.y + size.y}, chosen ? look.theme.selected : look.theme.hover,
                       look.px.xs);
  const float middle = min.y + size.y * 0.5f, line = middle - look.fonts.ui->FontSize * 0.5f;
  const bool folder = entry.kind == FileKind::folder;
  const FileColumns columns(look, min.x, size.x);
  draw_icon(list, look.fonts.ui, {min.x + look.px(16), middle}, folder ? look.theme.accent : look.theme.dim,
            icon_of(entry.kind));
  draw_line(look, list, look.fonts.ui, {min.x + look.px(30), line}, look.theme.text, entry.name,
            columns.size - min.x - look.px(34));
  const auto figure = [&](float to, const std::string& words) {
    draw_text(list, look.fonts.mono, {to - text_width(look.fonts.mono, words), line}, look.theme.dim, words);
  };
  if (!folder && columns.has_size) figure(columns.date, bytes_text(entry.size));
  if (columns.has_date) figure(min.x + size.x - look.px(8), date_text(entry.modified));
  if (clicked) {
    list_.select(index);
    replaces_ = true;
    if (spec_.saving && !folder) set_text(entry.name);
  }
  if (hovered && ImGui::IsMouseDoubleClicked(0) && mode_ == Mode::browse) open_entry(entry);
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
