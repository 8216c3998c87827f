#include "ui/canvas/legend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "core/plan/glossary.hpp"
#include "ui/canvas/chips.hpp"
#include "ui/colormap.hpp"

namespace replan::ui {
namespace {

struct SignEntry {
  Sign sign;
  LegendShape shape;
  ImU32 Theme::*colour;
  const char* label;
  const char* help;
};
constexpr std::array<SignEntry, static_cast<std::size_t>(Sign::count)> kSigns = {{
#define REPLAN_SIGN(ID, SHAPE, COLOUR, LABEL, HELP) \
  {Sign::ID, LegendShape::SHAPE, &Theme::COLOUR, LABEL, HELP},
#include "core/scene/signs.def"
#undef REPLAN_SIGN
}};

/// Keys whose word in the glossary is another one.
struct KeyTerm {
  std::string_view label;
  std::string_view term;
};
constexpr KeyTerm kKeyTerms[] = {
    {"last repair", "repair"},        {"moving", "moving-obstacle"}, {"g > rhs", "overconsistent"},
    {"g < rhs", "underconsistent"},   {"no sight", "sight"},         {"path", "plan"},
    {"nearest to it", "nearest-goal"}};

const OverlayInfo* overlay_called(std::string_view label) {
  for (const OverlayInfo& info : overlays())
    if (info.label == label) return &info;
  return nullptr;
}

std::string value_text(double value) {
  char text[32];
  if (value == std::floor(value)) return grouped(static_cast<std::int64_t>(value));
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

LegendEntry entry_of(const Look& look, const SignEntry& sign) {
  return {sign.shape, look.theme.*sign.colour, sign.label, sign.help};
}
constexpr const char* kStartHelp = "Where the robot sets out. Drag it to another cell.";
constexpr const char* kGoalHelp = "Where the robot has to go. Drag it to another cell, also while it drives.";

LegendEntry start_entry(const Look& look, bool outside) {
  return {outside ? LegendShape::star : LegendShape::dot, look.theme.start, "start", kStartHelp};
}
LegendEntry goal_entry(const Look& look, bool outside) {
  return {outside ? LegendShape::diamond : LegendShape::dot, look.theme.goal, "goal", kGoalHelp};
}

/// The field in the colours that it has on the map, with the value at the mouse marked.
LegendField field_in_sight(const Scene& scene, const Colormap& colours, std::string_view low,
                           std::string_view high) {
  LegendField field{scene.field_words, &colours, low, high};
  const double span = scene.range->high - scene.range->low;
  if (scene.pointed)
    field.mark = span > 0 ? static_cast<float>((*scene.pointed - scene.range->low) / span) : 0;
  return field;
}

/// All that is in sight, what is rarest and needs telling most first.
/// `every_edge`: the label of the entry that says how many edges of a tree are drawn; empty if all are.
std::vector<LegendEntry> entries_in_sight(const Look& look, const SignSet& signs, std::string_view every_edge,
                                          bool outside) {
  Scene all;
  all.signs = signs;
  std::vector<LegendEntry> entries;
  if (!every_edge.empty())
    entries.push_back({LegendShape::line, look.theme.dim, every_edge,
                       "The tree has more edges than are drawn at once. Zoom in to see more of them."});
  for (const SignEntry& entry : kSigns)
    if (all.shows(entry.sign)) entries.push_back(entry_of(look, entry));
  entries.push_back(start_entry(look, outside));
  entries.push_back(goal_entry(look, outside));
  return entries;
}

/// How many edges of a tree are drawn; empty if all are.
std::string every_edge_text(int every) {
  if (every <= 1) return {};
  char text[32];
  std::snprintf(text, sizeof text, "1 edge in %d", every);
  return text;
}

/// Breaks entries into rows no wider than `room`; the first has the field too.
std::vector<std::vector<LegendEntry>> in_rows(const Look& look, const LegendField& field,
                                              const std::vector<LegendEntry>& entries, float room) {
  std::vector<std::vector<LegendEntry>> rows(1);
  for (const LegendEntry& entry : entries) {
    rows.back().push_back(entry);
    const LegendField with = rows.size() == 1 ? field : LegendField{};
    const bool alone = rows.back().size() == 1 && with.map == nullptr;
    if (alone || legend_size(look, with, rows.back()).x <= room) continue;
    rows.back().pop_back();
    rows.push_back({entry});
  }
  return rows;
}

}  // namespace

std::vector<LegendEntry> all_signs(const Look& look) {
  std::vector<LegendEntry> entries = {start_entry(look, false), goal_entry(look, false)};
  for (auto sign = kSigns.rbegin(); sign != kSigns.rend(); ++sign) entries.push_back(entry_of(look, *sign));
  return entries;
}

LegendWords legend_words(std::string_view label) {
  const auto* named = std::find_if(std::begin(kKeyTerms), std::end(kKeyTerms),
                                   [label](const KeyTerm& each) { return each.label == label; });
  const std::string_view id = named == std::end(kKeyTerms) ? label : named->term;
  if (const GlossaryTerm* term = find_term(id)) return {std::string(term->title), std::string(term->text)};
  if (const OverlayInfo* overlay = overlay_called(label))
    return {std::string(label), std::string(overlay->help)};
  for (const SignEntry& sign : kSigns)
    if (sign.label == label) return {std::string(label), sign.help};
  if (label == "start") return {std::string(label), kStartHelp};
  if (label == "goal") return {std::string(label), kGoalHelp};
  return {};
}

float Legend::height(const Look& look) {
  return legend_size(look, {}, {}).y + 2 * look.px.s;
}

void Legend::draw(const Look& look, const Scene& scene, std::string_view of, FieldColours map,
                  const LegendSigns& signs, bool outside, ImVec2 min, ImVec2 max) {
  const float margin = look.px.m, room = max.x - min.x - 2 * margin;
  LegendField field;
  std::string words = scene.field_words, low, high;
  if (!of.empty()) words = std::string(of) + "'s " + words;
  const Colormap colours = field_colours_over_free(look.theme, map);
  if (scene.range) {
    low = value_text(scene.range->low);
    high = value_text(scene.range->high);
    field = field_in_sight(scene, colours, low, high);
    field.label = words;
    field_ = overlays()[static_cast<std::size_t>(*scene.field)].label;
  }
  // In a narrow pane the field's short name has to do.
  const bool wide = legend_size(look, field, {}).x > room - look.px(46);
  if (const std::size_t colon = field.label.find(':'); wide && colon != std::string_view::npos)
    field.label = field.label.substr(0, colon);
  if (legend_size(look, field, {}).x > room - look.px(46)) field.length /= 2;
  const std::string every_edge = every_edge_text(signs.every_edge);
  const std::vector<LegendEntry> entries = entries_in_sight(look, signs.signs, every_edge, outside);
  auto rows = in_rows(look, field, entries, room);
  if (rows.size() > 1) rows = in_rows(look, field, entries, room - look.px(46));
  const std::string more = rows.size() == 1 ? "" : "+" + std::to_string(entries.size() - rows.front().size());
  const float more_width = more.empty() ? 0 : look.px.xs + text_width(look.fonts.ui, more) + look.px(20);
  const float height = legend_size(look, {}, {}).y, step = height + look.px.xs;
  ImVec2 size(legend_size(look, field, rows.front()).x + more_width, height);
  if (unfolded_)
    for (std::size_t i = 1; i < rows.size(); ++i) {
      size.x = std::max(size.x, legend_size(look, {}, rows[i]).x);
      size.y += step;
    }
  ImGui::SetNextWindowPos({min.x + margin, max.y - look.px.s}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin("legend", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  const float bottom = ImGui::GetWindowPos().y + size.y;
  row(look, field, rows.front(), {ImGui::GetWindowPos().x, bottom});
  if (!more.empty()) {
    const std::array<TextRun, 1> runs = {{{more, look.theme.dim, look.fonts.ui}}};
    const float left = ImGui::GetWindowPos().x + legend_size(look, field, rows.front()).x + look.px.xs;
    chip(look, *ImGui::GetWindowDrawList(), {left, bottom}, runs, Corner::bottom_left);
  }
  for (std::size_t i = 1; i < rows.size() && unfolded_; ++i)
    row(look, {}, rows[i],
        {ImGui::GetWindowPos().x + size.x - legend_size(look, {}, rows[i]).x,
         bottom - step * static_cast<float>(i)});
  unfolded_ = ImGui::IsWindowHovered() || ImGui::IsPopupOpen("word");
  explain(look);
  ImGui::End();
}

/// `corner`: its lower left one.
void Legend::row(const Look& look, const LegendField& field, const std::vector<LegendEntry>& entries,
                 ImVec2 corner) {
  std::vector<ScreenArea> boxes;
  legend(look, *ImGui::GetWindowDrawList(), corner, field, entries, Corner::bottom_left, &boxes);
  const std::size_t fields = boxes.size() - entries.size();
  if (fields > 0) key(look, field_, legend_words(field_), boxes.front());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    LegendWords words = legend_words(entries[i].label);
    if (words.text.empty()) words = {std::string(entries[i].label), entries[i].help};
    key(look, entries[i].label, words, boxes[fields + i]);
  }
}

void Legend::key(const Look& look, std::string_view label, const LegendWords& words, const ScreenArea& box) {
  const std::string id(label);
  ImGui::SetCursorScreenPos(box.min);
  const bool clicked = ImGui::InvisibleButton(id.c_str(), {box.max.x - box.min.x, box.max.y - box.min.y});
  tab_stop(look);
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  hint(look, {words.title.c_str(), "", words.text.c_str()});
  if (!clicked) return;
  asked_ = words;
  ImGui::OpenPopup("word");
}

/// The words of the key that was clicked, until something else is.
void Legend::explain(const Look& look) {
  ImGui::SetNextWindowSize({look.px(360), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.l, look.px.m));
  if (ImGui::BeginPopup("word", ImGuiWindowFlags_NoMove)) {
    text(look.fonts.title, look.theme.text, asked_.title);
    paragraph(look.fonts.ui, look.theme.dim, asked_.text);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace replan::ui
