// Values in grids, tables and lines (see widgets.hpp).
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

const ImFont* figures(const Look& look, bool strong) {
  return strong ? look.fonts.mono_bold : look.fonts.mono;
}

ImU32 colour_or(ImU32 colour, ImU32 otherwise) {
  return colour != 0 ? colour : otherwise;
}

/// Draws a text between two x, at the left or the right, shortened if it does not fit.
void draw_between(const Look& look, ImDrawList& list, const ImFont* font, float left, float right, float y,
                  Align align, ImU32 colour, std::string_view text) {
  const float width = text_width(font, text);
  if (width > right - left) {
    draw_line(look, list, font, {left, y}, colour, text, right - left);
  } else {
    draw_text(list, font, {align == Align::left ? left : right - width, y}, colour, text);
  }
}

float weight_sum(std::span<const Column> columns) {
  float sum = 0;
  for (const Column& column : columns) sum += column.weight;
  return std::max(sum, 1e-3f);
}

/// Calls `draw(i, left, right)` with the room of each column inside the row's padding.
template <class Draw>
void for_columns(const Look& look, std::span<const Column> columns, float left, float width, Draw draw) {
  const float unit = width / weight_sum(columns);
  const float padding = look.px(6);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const float right = left + columns[i].weight * unit;
    draw(i, left + padding, right - padding);
    left = right;
  }
}

}  // namespace

namespace {

/// Where the values of a column begin, from its left: behind its widest key, in the first half of the column.
float values_at(const Look& look, std::span<const KeyValue> pairs, int column, int columns, float width) {
  float widest = 0;
  for (auto i = static_cast<std::size_t>(column); i < pairs.size(); i += static_cast<std::size_t>(columns))
    widest = std::max(widest, text_width(look.fonts.mono, pairs[i].key));
  return std::min(std::ceil(widest) + look.px.m, width * 0.5f);
}

}  // namespace

int key_values(const Look& look, std::span<const KeyValue> pairs, int columns, Align align, bool live) {
  const float row = look.px(22);
  const float width = ImGui::GetContentRegionAvail().x / static_cast<float>(std::max(columns, 1));
  const int lines = (static_cast<int>(pairs.size()) + columns - 1) / std::max(columns, 1);
  const ImVec2 origin = ImGui::GetCursorScreenPos(), mouse = ImGui::GetIO().MousePos;
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, static_cast<float>(lines) * row});
  int hovered = -1;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto column = static_cast<float>(static_cast<int>(i) % columns);
    const auto line = static_cast<float>(static_cast<int>(i) / columns);
    const float left = origin.x + column * width, top = origin.y + line * row;
    const float middle = left + values_at(look, pairs, static_cast<int>(i) % columns, columns, width);
    const float right = left + width - look.px.xs;
    const float y = top + (row - look.fonts.mono->FontSize) * 0.5f;
    const bool inside = mouse.x >= left && mouse.x < left + width && mouse.y >= top && mouse.y < top + row;
    if (inside && ImGui::IsItemHovered()) hovered = static_cast<int>(i);
    if (live && hovered == static_cast<int>(i))
      list.AddRectFilled({left - look.px.xs, top}, {right, top + row}, look.theme.hover, look.px(4));
    draw_between(look, list, look.fonts.mono, left, middle - look.px.xs, y, Align::left, look.theme.dim,
                 pairs[i].key);
    draw_between(look, list, figures(look, pairs[i].strong), middle, right, y, align,
                 colour_or(pairs[i].colour, look.theme.text), pairs[i].value);
  }
  return hovered;
}

int table_header(const Look& look, std::span<const Column> columns) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = origin.y + (look.px.row - look.fonts.mono->FontSize) * 0.5f;
  int at = -1;
  for_columns(look, columns, origin.x, width, [&](std::size_t i, float left, float right) {
    draw_between(look, list, look.fonts.mono, left, right, y, columns[i].align, look.theme.faint,
                 columns[i].name);
    if (ImGui::GetIO().MousePos.x >= left && ImGui::GetIO().MousePos.x < right) at = static_cast<int>(i);
  });
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::Dummy({width, look.px.row});
  ImGui::PopStyleVar();
  return ImGui::IsItemHovered() ? at : -1;
}

bool table_row(const Look& look, int id, std::span<const Column> columns, std::span<const TableCell> cells,
               bool selected) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(id);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  const bool clicked = ImGui::InvisibleButton("row", {std::max(width, 1.0f), look.px.row});
  ImGui::PopStyleVar();
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hovered = ImGui::IsItemHovered();
  if (selected || hovered) {
    list.AddRectFilled(origin, {origin.x + width, origin.y + look.px.row},
                       selected ? look.theme.selected : look.theme.hover, look.px(2));
  }
  const float y = origin.y + (look.px.row - look.fonts.mono->FontSize) * 0.5f;
  for_columns(look, columns.first(std::min(columns.size(), cells.size())), origin.x, width,
              [&](std::size_t i, float left, float right) {
                draw_between(look, list, figures(look, cells[i].strong), left, right, y, columns[i].align,
                             colour_or(cells[i].colour, look.theme.text), cells[i].text);
              });
  return clicked;
}

bool code_line(const Look& look, const CodeLine& line) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = look.px(20);
  const float gutter = look.px(34);
  ImGui::PushID(line.number);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  const bool pressed = ImGui::InvisibleButton("line", {std::max(width, 1.0f), height});
  ImGui::PopStyleVar();
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float bottom = origin.y + height;
  const bool hovered = ImGui::IsItemHovered();
  const bool in_gutter = ImGui::GetIO().MousePos.x < origin.x + gutter;
  if (line.current || hovered) {
    list.AddRectFilled(origin, {origin.x + width, bottom},
                       line.current ? look.theme.selected : look.theme.hover);
  }
  if (line.current) list.AddRectFilled(origin, {origin.x + look.px(3), bottom}, look.theme.accent);
  const float y = origin.y + (height - look.fonts.mono->FontSize) * 0.5f;
  if (line.breakpoint || (hovered && in_gutter)) {
    const ImVec2 dot(origin.x + look.px(30), origin.y + height * 0.5f);
    list.AddCircleFilled(dot, look.px(line.breakpoint ? 4 : 3),
                         line.breakpoint ? look.theme.bad : with_alpha(look.theme.bad, 0.45f));
  }
  std::array<char, 16> digits{};
  const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), line.number).ptr;
  const std::string_view number(digits.data(), static_cast<std::size_t>(end - digits.data()));
  draw_between(look, list, look.fonts.mono, origin.x, origin.x + look.px(24), y, Align::right,
               look.theme.faint, number);
  draw_text(list, look.fonts.mono, {origin.x + look.px(38), y},
            line.current ? look.theme.text : look.theme.dim, line.text);
  return pressed && in_gutter;
}

void status(const Look& look, ImU32 colour, std::string_view words) {
  const float radius = look.px(4);
  const float height = look.fonts.ui->FontSize;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled({origin.x + radius, origin.y + std::round(height * 0.53f)}, radius, colour);
  draw_text(list, look.fonts.ui, {origin.x + radius * 2 + look.px(6), origin.y}, colour, words);
  ImGui::Dummy({radius * 2 + look.px(6) + text_width(look.fonts.ui, words), height});
}

void labelled(const Look& look, std::string_view label, std::string_view value) {
  text(look.fonts.ui, look.theme.dim, label);
  ImGui::SameLine(0, look.px.xs);
  text(look.fonts.mono, look.theme.text, value);
}

}  // namespace replan::ui
