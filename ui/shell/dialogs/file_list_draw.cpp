// How the file dialog's list looks.
#include <string>
#include <utility>

#include <imgui.h>

#include "ui/icons.hpp"
#include "ui/shell/dialogs/file_dialog.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr float kSizeColumn = 84, kDateColumn = 104;

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

}  // namespace

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

}  // namespace replan::ui
