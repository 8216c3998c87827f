#include "ui/shell/dialogs.hpp"

#include <algorithm>
#include <array>

#include <imgui_stdlib.h>

#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/shell/actions.hpp"
#include "ui/widgets.hpp"

namespace replan::ui {
namespace {

constexpr const char* kPopup = "dialog";

bool escape_pressed() {
  return ImGui::IsKeyPressed(key::kEscape, false);
}
bool enter_pressed() {
  return ImGui::IsKeyPressed(key::kEnter, false) || ImGui::IsKeyPressed(key::kKeypadEnter, false);
}

void heading(const Look& look, std::string_view words) {
  text(look.fonts.heading, look.theme.text, words);
  ImGui::Dummy({0, look.px(2)});
}

/// Puts the cursor so that controls of this total width end at the right edge.
void align_right(float width) {
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
}

float button_width(const Look& look, const char* label) {
  return text_width(look.fonts.ui, label) + look.px(24);
}

/// "Cancel" and the primary button at the lower right.
Decision::Kind confirm(const Look& look, const char* yes, Decision::Kind decision) {
  ImGui::Dummy({0, look.px.xs});
  align_right(button_width(look, "Cancel") + look.px.s + button_width(look, yes));
  Decision::Kind made = Decision::Kind::none;
  if (button(look, "Cancel", ButtonKind::quiet) || escape_pressed()) made = Decision::Kind::cancel;
  ImGui::SameLine(0, look.px.s);
  if (button(look, yes, ButtonKind::primary) || enter_pressed()) made = decision;
  return made;
}

constexpr std::array<std::pair<Menu, const char*>, 8> kSections = {{{Menu::planner, "Play and step"},
                                                                    {Menu::file, "File"},
                                                                    {Menu::edit, "Edit and tools"},
                                                                    {Menu::world, "World"},
                                                                    {Menu::view, "View"},
                                                                    {Menu::overlays, "Overlays"},
                                                                    {Menu::record, "Record"},
                                                                    {Menu::help, "Help"}}};

float rows_height(const Look& look, Menu menu) {
  const auto rows = std::count_if(actions().begin(), actions().end(),
                                  [menu](const Action& a) { return a.menu == menu && !a.keys.empty(); });
  return look.px(23) * static_cast<float>(rows) + look.px(40);
}

void key_section(const Look& look, Menu menu, const char* title, float width) {
  section_title(look, title);
  for (const Action& each : actions()) {
    if (each.menu != menu || each.keys.empty()) continue;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    text(look.fonts.ui, look.theme.text, elide(look.fonts.ui, each.label, width - look.px(96)));
    ImGui::SetCursorScreenPos(
        {origin.x + width - text_width(look.fonts.small, each.keys) - look.px(10), origin.y});
    key_chip(look, each.keys.c_str());
  }
  ImGui::Dummy({width, look.px.s});
}

}  // namespace

void Dialogs::show(DialogKind kind, std::string text) {
  kind_ = kind;
  fresh_ = true;
  text_ = std::move(text);
  error_.clear();
}

Decision Dialogs::draw(const Look& look) {
  if (kind_ == DialogKind::none) return {};
  if (!ImGui::IsPopupOpen(kPopup)) ImGui::OpenPopup(kPopup);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width =
      std::min(kind_ == DialogKind::keys ? look.px(880) : look.px(460), screen.x - look.px(32));
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Always, {0.5f, 0.45f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - look.px(32)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(24), look.px(20)));
  const bool shown =
      ImGui::BeginPopupModal(kPopup, nullptr,
                             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar();
  if (!shown) return {};
  Decision decision = content(look);
  fresh_ = false;
  if (decision.kind != Decision::Kind::none && decision.kind != Decision::Kind::open &&
      decision.kind != Decision::Kind::save)
    close();
  if (kind_ == DialogKind::none) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return decision;
}

Decision Dialogs::content(const Look& look) {
  switch (kind_) {
    case DialogKind::open:
      return path_dialog(look, false);
    case DialogKind::save:
      return path_dialog(look, true);
    case DialogKind::new_world:
      return new_world_dialog(look);
    case DialogKind::unsaved:
      return unsaved_dialog(look);
    case DialogKind::keys:
      return keys_dialog(look);
    case DialogKind::film:
      return capture_dialog(look, true);
    case DialogKind::picture:
      return capture_dialog(look, false);
    case DialogKind::none:
      break;
  }
  return {};
}

Decision Dialogs::path_dialog(const Look& look, bool saving) {
  heading(look, saving ? "Save as" : "Open");
  paragraph(look.fonts.ui, look.theme.dim,
            saving ? "A scenario (.json) holds the world, the planners, the robot and the surprises; a map "
                     "(.map) the cells alone."
                   : "A scenario (.json), a MovingAI map (.map) or a picture (.png), dark pixels being "
                     "obstacles. You can also drop a file onto the window.");
  if (fresh_) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##path", saving ? "folder/name.json" : "path of a file", &text_))
    error_.clear();
  if (!error_.empty()) paragraph(look.fonts.ui, look.theme.bad, error_);
  return {confirm(look, saving ? "Save" : "Open", saving ? Decision::Kind::save : Decision::Kind::open),
          text_, 0, 0, 0};
}

Decision Dialogs::capture_dialog(const Look& look, bool film) {
  heading(look, film ? "Record a film" : "Save a picture");
  paragraph(look.fonts.ui, look.theme.dim,
            film ? "The ending chooses the kind: .gif, .webp or .mp4 (all made by FFmpeg), or a folder/ for "
                   "numbered pictures. While it records, time goes by frame by frame: none is dropped."
                 : "The ending chooses the kind: .png as it is on the screen, or .svg as a drawing of the "
                   "canvas.");
  if (fresh_) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##path", film ? "folder/name.gif" : "folder/name.png", &text_,
                           ImGuiInputTextFlags_AutoSelectAll);
  if (film)
    slider(look,
           {.label = "Frames per second", .min = 10, .max = 50, .initial = 30, .unit = "", .decimals = 0},
           fps_);
  return {confirm(look, film ? "Record" : "Save", Decision::Kind::capture), text_, 0, 0,
          static_cast<int>(fps_)};
}

Decision Dialogs::new_world_dialog(const Look& look) {
  heading(look, "New world");
  paragraph(look.fonts.ui, look.theme.dim, "All cells are free; paint the obstacles with the brush.");
  slider(look,
         {.label = "Width",
          .min = 4,
          .max = 2048,
          .initial = 48,
          .unit = "cells",
          .decimals = 0,
          .logarithmic = true},
         width_);
  slider(look,
         {.label = "Height",
          .min = 4,
          .max = 2048,
          .initial = 32,
          .unit = "cells",
          .decimals = 0,
          .logarithmic = true},
         height_);
  return {confirm(look, "Create", Decision::Kind::new_world),
          {},
          static_cast<int>(width_),
          static_cast<int>(height_),
          0};
}

Decision Dialogs::unsaved_dialog(const Look& look) {
  heading(look, "Save the changes?");
  paragraph(look.fonts.ui, look.theme.dim,
            text_ + " has edits that are not in a file yet. Without saving they are lost.");
  ImGui::Dummy({0, look.px.xs});
  if (button(look, "Discard", ButtonKind::danger)) return {Decision::Kind::discard, {}, 0, 0, 0};
  ImGui::SameLine(0, look.px.s);
  align_right(button_width(look, "Cancel") + look.px.s + button_width(look, "Save"));
  if (button(look, "Cancel", ButtonKind::quiet) || escape_pressed())
    return {Decision::Kind::cancel, {}, 0, 0, 0};
  ImGui::SameLine(0, look.px.s);
  if (button(look, "Save", ButtonKind::primary) || enter_pressed())
    return {Decision::Kind::save_first, {}, 0, 0, 0};
  return {};
}

Decision Dialogs::keys_dialog(const Look& look) {
  heading(look, "Keys");
  const float gap = look.px(32);
  const float whole = ImGui::GetContentRegionAvail().x;
  const int count = whole > look.px(700) ? 3 : whole > look.px(460) ? 2 : 1;
  const float width = (whole - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
  float total = 0;
  for (const auto& [menu, title] : kSections) total += rows_height(look, menu);
  float filled = 0;
  ImGui::BeginGroup();
  for (const auto& [menu, title] : kSections) {
    // Sections fill one column after the other, each to its share of the height.
    if (filled > 0 && filled + rows_height(look, menu) * 0.5f > total / static_cast<float>(count)) {
      ImGui::EndGroup();
      ImGui::SameLine(0, gap);
      ImGui::BeginGroup();
      filled = 0;
    }
    key_section(look, menu, title, width);
    filled += rows_height(look, menu);
  }
  ImGui::EndGroup();
  paragraph(look.fonts.ui, look.theme.dim,
            "On the canvas: the wheel zooms, the middle button pans, the right button erases, a grabbed "
            "start or goal moves.");
  align_right(button_width(look, "Close"));
  const bool closed = button(look, "Close", ButtonKind::plain) || escape_pressed() || enter_pressed() ||
                      (!fresh_ && ImGui::IsKeyPressed(key::kF1, false));
  return {closed ? Decision::Kind::cancel : Decision::Kind::none, {}, 0, 0, 0};
}

}  // namespace replan::ui
