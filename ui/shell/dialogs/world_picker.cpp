#include "ui/shell/dialogs/world_picker.hpp"

#include <algorithm>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/base/file.hpp"
#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr float kCardWidth = 300, kPicture = 140, kCardHeight = 284;
constexpr int kCaptionLines = 5;

/// At most so many lines, the last one with "…" if there is more.
void draw_wrapped(const Look& look, ImDrawList& list, ImVec2 pos, float width, std::string_view words) {
  const ImFont* font = look.fonts.ui;
  for (int line = 0; line < kCaptionLines && !words.empty(); ++line, pos.y += look.px(17)) {
    const char* end = words.data() + words.size();
    const char* cut = font->CalcWordWrapPositionA(1.0f, words.data(), end, width);
    const auto length = std::max<std::size_t>(static_cast<std::size_t>(cut - words.data()), 1);
    const bool last = line + 1 == kCaptionLines && length < words.size();
    draw_text(list, font, pos, look.theme.dim,
              last ? elide(font, words, width) : std::string(words.substr(0, length)));
    words.remove_prefix(std::min(words.find_first_not_of(' ', length), words.size()));
  }
}

std::string facts_of(const Preview& preview) {
  std::string facts = std::to_string(preview.width) + " × " + std::to_string(preview.height) +
                      (preview.depth > 1 ? " × " + std::to_string(preview.depth) : "");
  for (const std::string& planner : preview.planners) facts += " · " + planner;
  return facts;
}

}  // namespace

WorldPicker::WorldPicker(ImGuiRenderer& renderer, WorldLibrary& library)
    : renderer_(renderer), library_(library) {
  library_.refresh();
}

ThumbnailView* WorldPicker::picture_of(const LibraryWorld& world) {
  if (!world.looked_at) return nullptr;
  for (const Card& card : cards_)
    if (card.path == world.path && card.stamp == world.stamp) return card.picture.get();
  Card& card = cards_.emplace_back(Card{world.path, world.stamp, std::make_unique<ThumbnailView>(renderer_)});
  card.picture->show(world.preview.thumbnail);
  return card.picture.get();
}

void WorldPicker::take_keys(std::size_t count, std::size_t columns) {
  const auto by = [](int key) { return ImGui::IsKeyPressed(key, true); };
  const std::size_t before = selected_;
  // The text field takes Left and Right for its own while there is text to go through.
  if (text_.empty() && by(key::kLeft) && selected_ > 0) --selected_;
  if (text_.empty() && by(key::kRight)) ++selected_;
  if (by(key::kUp) && selected_ >= columns) selected_ -= columns;
  if (by(key::kDown) && selected_ + columns < count + columns - 1) selected_ += columns;
  selected_ = count == 0 ? 0 : std::min(selected_, count - 1);
  scroll_ = scroll_ || selected_ != before;
}

FileChoice WorldPicker::draw(const Look& look, float height) {
  choice_ = {};
  library_.update();
  const float top = ImGui::GetCursorPosY();
  heading(look, "Example worlds");
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(look.px(10), (look.px.control - look.fonts.ui->FontSize) * 0.5f));
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  const std::string before = text_;
  ImGui::InputTextWithHint("##search", "Type what the world is about", &text_);
  if (look.focus != nullptr) look.focus->leave_tab_to_it();  // arrows choose, and Enter opens
  if (escape_pressed()) text_ = before;
  if (text_ != before) selected_ = 0;
  ImGui::PopStyleVar();
  ImGui::Dummy({0, look.px.xs});
  const float foot = look.px.control + look.px(20);
  const float body = std::max(height - (ImGui::GetCursorPosY() - top) - foot, look.px(160));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::BeginChild("cards", {0, body});
  ImGui::PopStyleVar();
  draw_cards(look);
  ImGui::EndChild();
  if (!error_.empty()) {
    text_line(look, look.fonts.ui, look.theme.bad, error_, ImGui::GetContentRegionAvail().x * 0.7f);
    ImGui::SameLine();
  }
  const std::vector<std::size_t> found = library_.found(text_);
  align_right(button_width(look, "Cancel") + look.px.s + button_width(look, "Open"));
  const bool left = button(look, "Cancel", ButtonKind::quiet);
  ImGui::SameLine(0, look.px.s);
  const bool open = button(look, "Open", ButtonKind::primary) || enter_pressed();
  if (open && selected_ < found.size()) choice_ = {Answer::yes, library_.worlds()[found[selected_]].path, {}};
  if (left || (escape_pressed() && text_.empty())) choice_.answer = Answer::no;
  if (escape_pressed()) text_.clear();
  return choice_;
}

void WorldPicker::draw_cards(const Look& look) {
  const std::vector<std::size_t> found = library_.found(text_);
  if (found.empty()) {
    const bool none = text_.empty();
    empty_state(look, icon::map,
                library_.busy() ? "Reading the worlds…"
                : none          ? "No worlds"
                                : "No world like that",
                none ? "They are looked for in " + library_.folder() + "."
                     : "Names, captions and file names are searched. Esc clears the search.");
    return;
  }
  const float gap = look.px.m, whole = ImGui::GetContentRegionAvail().x;
  const auto columns = static_cast<std::size_t>(std::max(1.0f, (whole + gap) / (look.px(kCardWidth) + gap)));
  take_keys(found.size(), columns);
  const float width =
      std::floor((whole - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i % columns != 0) ImGui::SameLine(0, gap);
    const LibraryWorld& world = library_.worlds()[found[i]];
    ImGui::PushID(world.path.c_str());
    if (ImGui::InvisibleButton("card", {width, look.px(kCardHeight)})) selected_ = i;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) choice_ = {Answer::yes, world.path, {}};
    if (i == selected_ && scroll_) {
      ImGui::SetScrollHereY(0.5f);
      scroll_ = false;
    }
    if (ImGui::IsItemVisible()) draw_card(look, world, {width, look.px(kCardHeight)}, i == selected_);
    hint(look, {world.preview.caption.empty() ? "" : world.preview.name.c_str(), "",
                world.preview.caption.c_str()});
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
}

void WorldPicker::draw_card(const Look& look, const LibraryWorld& world, ImVec2 size, bool chosen) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 min = ImGui::GetItemRectMin(), max(min.x + size.x, min.y + size.y);
  const bool hovered = ImGui::IsItemHovered();
  list.AddRectFilled(min, max,
                     chosen    ? look.theme.selected
                     : hovered ? look.theme.hover
                               : look.theme.raised,
                     look.px.radius_l);
  if (chosen)
    list.AddRect(min, max, look.theme.accent, look.px.radius_l, 0, std::max(look.px.hair, look.px(1.5f)));
  const float inset = look.px(8), picture = look.px(kPicture);
  const ImVec2 upper(min.x + inset, min.y + inset), lower(max.x - inset, min.y + inset + picture);
  list.AddRectFilled(upper, lower, look.theme.background, look.px.xs);
  if (ThumbnailView* view = picture_of(world); view != nullptr)
    view->draw(look, list, {upper.x + look.px(4), upper.y + look.px(4)},
               {lower.x - look.px(4), lower.y - look.px(4)});
  else
    draw_text_centred(list, look.fonts.ui, upper, lower, look.theme.faint, "Reading…");
  const float left = min.x + look.px(12), room = size.x - look.px(24);
  float y = lower.y + look.px(8);
  draw_line(look, list, look.fonts.title, {left, y}, look.theme.text, world.title(), room);
  y += look.px(18);
  if (world.looked_at)
    draw_line(look, list, look.fonts.small, {left, y}, look.theme.faint, facts_of(world.preview), room);
  draw_wrapped(look, list, {left, y + look.px(16)}, room, world.preview.caption);
}

std::string WorldPicker::words() const {
  std::string words;
  for (const LibraryWorld& world : library_.worlds()) words += world.title() + world.preview.caption;
  return words;
}

}  // namespace replan::ui
