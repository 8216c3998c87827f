// Text and hints (see widgets.hpp).
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

#include <imgui_internal.h>

#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// ImGui 1.86 takes fonts as non-const, though measuring and drawing change nothing.
ImFont* mutable_font(const ImFont* font) {
  return const_cast<ImFont*>(font);
}

unsigned code_point(const char* text) {
  unsigned code = 0;
  ImTextCharFromUtf8(&code, text, nullptr);
  return code;
}

/// Where another tooltip stands already, at its end.
void tooltip_of_words(const Look& look, std::string_view words) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(10), look.px.s));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(look.px(300));
  text(look.fonts.ui, look.theme.text, words);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace

float text_width(const ImFont* font, std::string_view text) {
  if (text.empty()) return 0;  // its data may be null, which ImGui does not take
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
}

std::string elide(const ImFont* font, std::string_view text, float width) {
  if (text_width(font, text) <= width) return std::string(text);
  constexpr std::string_view kDots = "…";
  const float room = width - text_width(font, kDots);
  const char* rest = nullptr;
  // Where the text that fits ends, on a character's boundary.
  font->CalcTextSizeA(font->FontSize, std::max(room, 0.0f), 0, text.data(), text.data() + text.size(), &rest);
  const auto length = static_cast<std::size_t>(rest - text.data());
  return std::string(text.substr(0, room > 0 ? length : 0)) + std::string(kDots);
}

void draw_text(ImDrawList& list, const ImFont* font, ImVec2 pos, ImU32 colour, std::string_view text) {
  if (text.empty()) return;
  // On whole pixels: glyphs are baked for them.
  const ImVec2 snapped(std::floor(pos.x), std::floor(pos.y));
  list.AddText(font, font->FontSize, snapped, colour, text.data(), text.data() + text.size());
}

void draw_line(const Look& look, ImDrawList& list, const ImFont* font, ImVec2 pos, ImU32 colour,
               std::string_view text, float room) {
  const std::string shown = elide(font, text, room);
  draw_text(list, font, pos, colour, shown);
  if (shown.size() == text.size() && shown == text) return;
  const ImVec2 end(pos.x + std::max(room, 0.0f), pos.y + font->FontSize);
  if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(pos, end)) return;
  tooltip_of_words(look, text);
}

void draw_text_centred(ImDrawList& list, const ImFont* font, ImVec2 min, ImVec2 max, ImU32 colour,
                       std::string_view text) {
  const float x = (min.x + max.x - text_width(font, text)) * 0.5f;
  draw_text(list, font, {x, (min.y + max.y - font->FontSize) * 0.5f}, colour, text);
}

void draw_icon(ImDrawList& list, const ImFont* font, ImVec2 centre, ImU32 colour, const char* icon) {
  const ImFontGlyph* glyph = font->FindGlyph(static_cast<ImWchar>(code_point(icon)));
  if (glyph == nullptr) return;
  const ImVec2 pos(std::round(centre.x - (glyph->X0 + glyph->X1) * 0.5f),
                   std::round(centre.y - (glyph->Y0 + glyph->Y1) * 0.5f));
  list.AddText(font, font->FontSize, pos, colour, icon);
}

void text(const ImFont* font, ImU32 colour, std::string_view text) {
  ImGui::PushFont(mutable_font(font));
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  const char* begin = text.empty() ? "" : text.data();
  ImGui::TextUnformatted(begin, begin + text.size());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void text_line(const Look& look, const ImFont* font, ImU32 colour, std::string_view words, float room) {
  const ImVec2 pos = ImGui::GetCursorScreenPos();
  ImGui::Dummy({std::min(text_width(font, words), std::max(room, 1.0f)), font->FontSize});
  draw_line(look, *ImGui::GetWindowDrawList(), font, pos, colour, words, room);
}

void paragraph(const ImFont* font, ImU32 colour, std::string_view text_to_wrap) {
  ImGui::PushTextWrapPos(0.0f);
  text(font, colour, text_to_wrap);
  ImGui::PopTextWrapPos();
}

bool link(const Look& look, const char* id, std::string_view words, const ImFont* font) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = text_width(font, words);
  const bool clicked = ImGui::InvisibleButton(id, {std::max(width, 1.0f), font->FontSize});
  tab_stop(look);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, font, origin, look.theme.accent, words);
  if (ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    const float y = origin.y + font->FontSize;
    list.AddRectFilled({origin.x, y}, {origin.x + width, y + look.px.hair}, look.theme.accent);
  }
  return clicked;
}

void key_chip(const Look& look, const char* keys) {
  const ImFont* font = look.fonts.small;
  // As high as a line of text, drawn a pixel over it, so that it stands beside text without moving it.
  const ImVec2 size(text_width(font, keys) + look.px(10), look.fonts.ui->FontSize);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 min(origin.x, origin.y - look.px(1));
  const ImVec2 max(min.x + size.x, origin.y + size.y + look.px(1));
  ImGui::Dummy(size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max, look.theme.raised, look.px(4));
  list.AddRect(min, max, look.theme.line, look.px(4), 0, look.px.hair);
  draw_text_centred(list, font, min, max, look.theme.dim, keys);
}

void hint(const Look& look, const Hint& what) {
  if (what.title[0] == '\0' && what.teach[0] == '\0') return;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  // Whoever types has read it, and needs to see what is below.
  if (ImGui::IsItemActive() && ImGui::GetIO().WantTextInput) return;
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.HoveredId != 0 && context.HoveredIdTimer < kHintSeconds) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(10), look.px.s));
  ImGui::BeginTooltip();
  if (what.title[0] != '\0') text(look.fonts.ui, look.theme.text, what.title);
  if (what.keys[0] != '\0') {
    ImGui::SameLine(0, look.px.m);
    key_chip(look, what.keys);
  }
  if (what.teach[0] != '\0') {
    ImGui::PushTextWrapPos(look.px(300));
    text(look.fonts.ui, look.theme.dim, what.teach);
    ImGui::PopTextWrapPos();
  }
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace replan::ui
