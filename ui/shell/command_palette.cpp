#include "ui/shell/command_palette.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/base/file.hpp"
#include "core/base/markdown.hpp"
#include "core/plan/glossary.hpp"
#include "core/world/choices.hpp"
#include "ui/documents/world_library.hpp"
#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/shell/lesson_card.hpp"
#include "ui/shell/menus.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/words.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kMostUsed = 12;  // remembered
constexpr std::size_t kMostRows = 200;
/// What it counts to have been used last, against letters that match; the one before counts a little less.
constexpr int kUsedBonus = 26, kUsedStep = 2;

/// The menu of the bar where it is found; overlays have a list of their own as well.
const char* place_of(Menu menu) {
  return menu_kind(menu == Menu::overlays ? menu : menu_kind(menu).of).name;
}

void add_actions(Frame& frame, std::vector<PaletteEntry>& entries) {
  const ActionContext context = context_of(frame);
  for (const Action& each : actions()) {
    if (each.rules.unlisted) continue;
    const bool overlay = each.menu == Menu::overlays, tab = each.menu == Menu::tabs;
    const bool enabled = each.available(context);
    entries.push_back({.id = each.name,
                       .label = (overlay ? "Overlay: "
                                 : tab   ? "Tab: "
                                         : "") +
                                each.words(context),
                       .place = place_of(each.menu),
                       .keys = each.keys,
                       .teach = each.lesson(context),
                       .icon = each.checked(context) ? icon::check
                               : overlay             ? icon::eye
                                                     : each.icon,
                       .enabled = enabled,
                       .reason = enabled ? "" : each.rules.why_not,
                       .effect = [id = each.id](Frame& f) { perform(f, id); }});
  }
}

void add_planners(Frame& frame, std::vector<PaletteEntry>& entries) {
  for (const PlannerInfo& info : choices()) {
    const bool chosen = frame.run().choice().id == info.id;
    entries.push_back({.id = "planner " + std::string(info.id),
                       .label = "Planner: " + std::string(info.name),
                       .place = "Planner",
                       .keys = {},
                       .teach = std::string(info.summary),
                       .icon = chosen ? icon::check : icon::sitemap,
                       .reason = {},
                       .effect = [id = std::string(info.id)](Frame& f) {
                         f.commands.emplace_back(ChoosePlanner{f.session.lead(), id});
                       }});
  }
}

PaletteEntry opens(const char* kind, Wish wish, const std::string& title, const std::string& path,
                   const char* icon) {
  return {.id = "open " + path,
          .label = std::string(kind) + title,
          .place = "File",
          .keys = {},
          .teach = path,
          .icon = icon,
          .reason = {},
          .effect = [wish, path](Frame& f) {
            f.wish = wish;
            f.panels.wished = path;
          }};
}

void add_terms(std::vector<PaletteEntry>& entries) {
  for (const GlossaryTerm& term : glossary())
    entries.push_back({.id = "term " + std::string(term.id),
                       .label = "Meaning of " + std::string(term.title),
                       .place = "Words",
                       .keys = {},
                       .teach = std::string(term.text),
                       .icon = icon::question,
                       .reason = {},
                       .effect = [id = term.id](Frame& f) { show_word(f.view, f.panels, id); }});
}

void add_lessons(Frame& frame, std::vector<PaletteEntry>& entries) {
  for (const Lesson& lesson : lessons_of(frame.panels))
    entries.push_back({.id = "lesson " + lesson.id,
                       .label = "Lesson: " + lesson.title,
                       .place = "Help",
                       .keys = {},
                       .teach = without_markdown(lesson.summary),
                       .icon = icon::graduation,
                       .reason = {},
                       .effect = [id = lesson.id](Frame& f) { wish_for_lesson(f.wish, f.panels, id); }});
}

/// The label with its matched letters in the accent's colour and heavier.
void draw_label(const Look& look, ImVec2 at, std::string_view label, std::span<const std::size_t> letters,
                ImU32 colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < label.size();) {
    const auto matched = [&](std::size_t p) { return std::binary_search(letters.begin(), letters.end(), p); };
    std::size_t end = i + 1;
    while (end < label.size() && matched(end) == matched(i)) ++end;
    const ImFont* font = matched(i) ? look.fonts.title : look.fonts.ui;
    draw_text(list, font, at, matched(i) ? look.theme.accent : colour, label.substr(i, end - i));
    at.x += text_width(font, label.substr(i, end - i));
    i = end;
  }
}

/// Few letters are found almost everywhere if each may stand anywhere: of a short text each has to begin a word or to
/// stand beside another.
bool is_scattered(std::string_view label, std::span<const std::size_t> letters) {
  constexpr std::size_t kShort = 5;
  if (letters.size() >= kShort) return false;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const std::size_t at = letters[i];
    const bool begins = at == 0 || std::isalnum(static_cast<unsigned char>(label[at - 1])) == 0;
    const bool beside =
        (i > 0 && letters[i - 1] + 1 == at) || (i + 1 < letters.size() && letters[i + 1] == at + 1);
    if (!begins && !beside && letters.size() > 1) return true;
  }
  return false;
}

}  // namespace

std::vector<PaletteEntry> palette_entries(Frame& frame, const WorldLibrary* library) {
  std::vector<PaletteEntry> entries;
  add_actions(frame, entries);
  add_planners(frame, entries);
  for (const std::string& path : frame.panels.recent)
    entries.push_back(opens("Open recent: ", Wish::recent, file_name(path), path, icon::file));
  if (library != nullptr)
    for (const LibraryWorld& world : library->worlds())
      entries.push_back(opens("Open world: ", Wish::open_world, world.title(), world.path, icon::map));
  add_lessons(frame, entries);
  add_terms(entries);
  return entries;
}

std::vector<PaletteHit> palette_hits(std::span<const PaletteEntry> entries, std::string_view typed,
                                     std::span<const std::string> used) {
  std::vector<PaletteHit> hits;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto match = fuzzy_match(typed, entries[i].label);
    if (!match || is_scattered(entries[i].label, match->letters)) continue;
    const auto last = std::find(used.begin(), used.end(), entries[i].id);
    if (last != used.end()) match->score += kUsedBonus - kUsedStep * static_cast<int>(last - used.begin());
    hits.push_back({i, std::move(*match)});
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const PaletteHit& a, const PaletteHit& b) { return a.match.score > b.match.score; });
  return hits;
}

void CommandPalette::show() {
  open_ = fresh_ = focus_ = true;
  typed_.clear();
  chosen_ = 0;
}

void CommandPalette::draw(Frame& frame, WorldLibrary* library) {
  if (!open_) return;
  const Look& look = frame.look;
  if (fresh_) ImGui::OpenPopup("palette");
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(look.px(640), screen.x - look.px(32));
  ImGui::SetNextWindowPos({screen.x * 0.5f, look.px.menu + look.px(28)}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.m, look.px.m));
  open_ = ImGui::BeginPopup("palette", ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  if (!open_) return;
  if (library != nullptr) library->update();
  const std::vector<PaletteEntry> entries = palette_entries(frame, library);
  if (std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
  if (search_box(look, "##typed", "A command, a planner, a world, a word", "", typed_,
                 ImGui::GetContentRegionAvail().x))
    chosen_ = 0;
  const std::vector<PaletteHit> hits = palette_hits(entries, typed_, used_);
  choose_by_keys(std::min(hits.size(), kMostRows));
  draw_hits(frame, entries, hits);
  const bool entered =
      !fresh_ && (ImGui::IsKeyPressed(key::kEnter, false) || ImGui::IsKeyPressed(key::kKeypadEnter, false));
  if (entered && chosen_ < hits.size()) carry_out(frame, entries[hits[chosen_].entry]);
  focus_ = entered && open_;  // Enter has left the field
  if (ImGui::IsKeyPressed(key::kEscape, false)) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  fresh_ = false;
  ImGui::EndPopup();
}

void CommandPalette::choose_by_keys(std::size_t count) {
  const std::size_t before = chosen_;
  if (count == 0) return;
  if (ImGui::IsKeyPressed(key::kDown)) chosen_ = (chosen_ + 1) % count;
  if (ImGui::IsKeyPressed(key::kUp)) chosen_ = (chosen_ + count - 1) % count;
  if (ImGui::IsKeyPressed(key::kPageDown)) chosen_ = std::min(chosen_ + 8, count - 1);
  if (ImGui::IsKeyPressed(key::kPageUp)) chosen_ -= std::min<std::size_t>(chosen_, 8);
  chosen_ = std::min(chosen_, count - 1);
  reveal_ = chosen_ != before;
}

void CommandPalette::draw_hits(Frame& frame, std::span<const PaletteEntry> entries,
                               std::span<const PaletteHit> hits) {
  const Look& look = frame.look;
  const float row = look.px(30);
  const std::size_t count = std::min(hits.size(), kMostRows);
  const float room = ImGui::GetIO().DisplaySize.y - look.px.menu - look.px(180);
  const float height = std::min(row * 11, std::max(room, row * 3));
  const PaletteEntry* told = nullptr;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("hits", {0, height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (count == 0) text(look.fonts.ui, look.theme.dim, "Nothing has that name. Fewer letters find more.");
  for (std::size_t i = 0; i < count; ++i) {
    const PaletteEntry& entry = entries[hits[i].entry];
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max(min.x + ImGui::GetContentRegionAvail().x, min.y + row);
    if (ImGui::InvisibleButton(entry.id.c_str(), {max.x - min.x, row})) carry_out(frame, entry);
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemHovered() && (moved.x != 0 || moved.y != 0)) chosen_ = i;
    if (i == chosen_) list.AddRectFilled(min, max, look.theme.selected, look.px.radius);
    if (i == chosen_) told = &entry;
    if (i == chosen_ && reveal_) ImGui::SetScrollHereY(0.5f);
    const float y = min.y + (row - look.fonts.ui->FontSize) * 0.5f;
    const ImU32 colour = entry.enabled ? look.theme.text : look.theme.faint;
    if (entry.icon[0] != '\0')
      draw_icon(list, look.fonts.ui, {min.x + look.px(18), (min.y + max.y) * 0.5f}, look.theme.dim,
                entry.icon);
    draw_label(look, {min.x + look.px(38), y}, entry.label, hits[i].match.letters, colour);
    const std::string aside = entry.enabled ? entry.place : entry.reason.empty() ? "not now" : entry.reason;
    const float keys = entry.keys.empty() ? 0 : text_width(look.fonts.mono, entry.keys) + look.px.m;
    draw_text(list, look.fonts.mono, {max.x - keys, y}, look.theme.dim, entry.keys);
    const float aside_from = max.x - keys - look.px.m - text_width(look.fonts.ui, aside);
    const float label_to = min.x + look.px(38) + text_width(look.fonts.ui, entry.label);
    if (aside_from > label_to + look.px.s)
      draw_text(list, look.fonts.ui, {aside_from, y}, look.theme.faint, aside);
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  section_rule(look);
  const std::string words = told == nullptr ? "" : told->teach;
  // Always of the same height, so that the list does not jump; long explanations have more.
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  paragraph(look.fonts.ui, look.theme.dim, words);
  const float used = ImGui::GetCursorScreenPos().y - begin.y;
  if (used < look.px(40)) ImGui::Dummy({1, look.px(40) - used});
}

/// What is not enabled stays in sight, with its reason.
void CommandPalette::carry_out(Frame& frame, const PaletteEntry& entry) {
  if (!entry.enabled) return;
  std::erase(used_, entry.id);
  used_.insert(used_.begin(), entry.id);
  if (used_.size() > kMostUsed) used_.resize(kMostUsed);
  open_ = false;
  entry.effect(frame);
}

}  // namespace replan::ui
