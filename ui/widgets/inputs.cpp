// Combo, toggle, slider and text fields (see widgets.hpp).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

float to_position(const SliderSpec& spec, double value) {
  if (spec.max <= spec.min) return 0;
  const double v = std::clamp(value, spec.min, spec.max);
  if (spec.logarithmic && spec.min > 0)
    return static_cast<float>(std::log(v / spec.min) / std::log(spec.max / spec.min));
  return static_cast<float>((v - spec.min) / (spec.max - spec.min));
}

/// A whole number of steps, and no more digits than are shown.
double rounded(const SliderSpec& spec, double value) {
  const double grain = spec.step > 0 ? spec.step : std::pow(10.0, -spec.decimals);
  return std::clamp(std::round(value / grain) * grain, spec.min, spec.max);
}

double to_value(const SliderSpec& spec, float position) {
  const double p = std::clamp(static_cast<double>(position), 0.0, 1.0);
  if (spec.logarithmic && spec.min > 0) return rounded(spec, spec.min * std::pow(spec.max / spec.min, p));
  return rounded(spec, spec.min + (spec.max - spec.min) * p);
}

std::string shown(const SliderSpec& spec, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", spec.decimals, value);
  return buffer.data();
}

bool is_initial(const SliderSpec& spec, double value) {
  return shown(spec, value) == shown(spec, spec.initial);
}

}  // namespace

bool slider_track(const Look& look, const SliderSpec& spec, double& value) {
  const float height = look.px.l;
  const float width = std::max(ImGui::GetContentRegionAvail().x, look.px(40));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("track", {width, height});
  const bool active = ImGui::IsItemActive();
  const float radius = look.px.s * 0.75f;
  const float left = origin.x + radius;
  const float span = width - radius * 2;
  const double before = value;
  if (active) value = to_value(spec, (ImGui::GetIO().MousePos.x - left) / span);
  const float y = origin.y + height * 0.5f;
  const float x = left + span * to_position(spec, value);
  const float half = look.px(4) * 0.5f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({origin.x, y - half}, {origin.x + width, y + half}, look.theme.line, half);
  list.AddRectFilled({origin.x, y - half}, {x, y + half}, look.theme.accent, half);
  list.AddCircleFilled({x, y}, radius, look.theme.accent);
  if (!active && !ImGui::IsItemHovered()) list.AddCircleFilled({x, y}, radius - look.px(2), look.theme.panel);
  return value != before;
}

namespace {

/// The value with its unit at the right of the label's line; a click or Tab begins typing.
bool slider_value(const Look& look, const SliderSpec& spec, double& value, float right) {
  const std::string number = shown(spec, value);
  const std::string_view many = spec.unit;
  const std::string unit = many.empty()                       ? ""
                           : many == "cells" && number == "1" ? " cell"
                                                              : " " + std::string(many);
  const bool typing = ImGui::GetActiveID() == ImGui::GetID("##typed");
  const float digits = text_width(look.fonts.mono, number);
  const float width = typing ? look.px(90) : digits + text_width(look.fonts.mono, unit);
  ImGui::SetCursorScreenPos({right - width, ImGui::GetCursorScreenPos().y});
  const ImVec2 pos = ImGui::GetCursorScreenPos();
  const bool hovered =
      ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(pos, {right, pos.y + look.fonts.mono->FontSize});
  ImGui::SetNextItemWidth(typing ? width : std::max(std::ceil(width), 1.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(typing ? look.px.xs : 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, typing ? ImGui::GetStyle().FrameBorderSize : 0.0f);
  if (!typing) ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
  ImGui::PushStyleColor(ImGuiCol_Text, hovered && !typing ? look.theme.accent : look.theme.text);
  double typed = value;
  const std::string format = "%." + std::to_string(spec.decimals) + "f";
  const bool changed = number_field(look, "##typed", ImGuiDataType_Double, &typed, format.c_str());
  ImGui::PopStyleColor(typing ? 1 : 2);
  ImGui::PopStyleVar(2);
  if (changed) value = rounded(spec, typed);
  if (!typing)
    draw_text(*ImGui::GetWindowDrawList(), look.fonts.mono, {pos.x + digits, pos.y}, look.theme.faint, unit);
  return changed;
}

/// Beside the label of a value that is not the default: leads back to it. Tab passes over it, so that it goes from number
/// to number.
bool reset_button(const Look& look, const SliderSpec& spec, double& value, float x, float y) {
  ImGui::SetCursorScreenPos({x + look.px.xs, y + (look.px(16) - look.px.small) * 0.5f});
  const std::string back = "Default: " + shown(spec, spec.initial) + " " + spec.unit;
  const IconButton button{.icon = icon::undo, .hint = {.title = back.c_str()}, .tab_stop = false};
  if (!small_button(look, "reset", button)) return false;
  value = spec.initial;
  return true;
}

/// A number while it is typed: ImGui's storage has room for halves of it.
struct Draft {
  ImGuiStorage& storage;
  ImGuiID id;

  void keep(std::uint64_t bits) {
    storage.SetInt(id, static_cast<int>(bits & 0xffffffffu));
    storage.SetInt(id + 1, static_cast<int>(bits >> 32));
  }
  [[nodiscard]] std::uint64_t bits() const {
    return std::uint64_t{static_cast<std::uint32_t>(storage.GetInt(id))} |
           std::uint64_t{static_cast<std::uint32_t>(storage.GetInt(id + 1))} << 32;
  }
};

bool is_enter_down(const ImGuiIO& io) {
  return io.KeysDown[key::kEnter] || io.KeysDown[key::kKeypadEnter];
}

}  // namespace

bool number_field(const Look& look, const char* id, ImGuiDataType type, void* value, const char* format) {
  const ImGuiID own = ImGui::GetID(id);
  Draft draft{*ImGui::GetStateStorage(), own};
  const bool typing = ImGui::GetActiveID() == own;
  std::uint64_t before = 0, typed = 0;
  std::memcpy(&before, value, sizeof before);
  // A field that another one has just taken the keyboard from is not active any more, and has yet to hand over.
  const bool begun = typing || ImGui::GetCurrentContext()->ActiveIdPreviousFrame == own;
  typed = begun ? draft.bits() : before;
  if (look.focus != nullptr) look.focus->offer_field(id);
  ImGui::PushFont(look.fonts.mono);
  ImGui::InputScalar(id, type, &typed, nullptr, nullptr, format, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopFont();
  if (ImGui::IsItemActive()) draft.keep(typed);
  if (typing)
    for (const int each : {key::kEnter, key::kKeypadEnter, key::kEscape}) key::take(ImGui::GetIO(), each);
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  std::memcpy(value, &typed, sizeof typed);
  return typed != before;
}

bool slider(const Look& look, const SliderSpec& spec, double& value, const Hint& what) {
  ImGui::PushID(spec.label);
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.s, look.px.xs));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  bool changed = false;
  text(look.fonts.ui, look.theme.dim, spec.label);
  hint(look, what);
  const float words_end = ImGui::GetItemRectMax().x;
  const bool initial = is_initial(spec, value);
  ImGui::SetCursorScreenPos(origin);
  changed |= slider_value(look, spec, value, right);
  if (!initial) changed |= reset_button(look, spec, value, words_end, origin.y);
  ImGui::SetCursorScreenPos({origin.x, origin.y + look.fonts.ui->FontSize + look.px.xs});
  changed |= slider_track(look, spec, value);
  ImGui::PopStyleVar();
  ImGui::EndGroup();
  ImGui::PopID();
  return changed;
}

bool toggle(const Look& look, const char* label, bool& on) {
  const ImVec2 track(look.px(28), look.px.l);
  const ImFont* font = look.fonts.ui;
  const std::string_view whole(label);
  const std::string_view words = whole.substr(0, whole.find("##"));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const bool clicked =
      ImGui::InvisibleButton(label, {track.x + look.px.s + text_width(font, words), look.px(20)});
  tab_stop(look);
  if (clicked) on = !on;
  const float y = origin.y + look.px(2);
  const float radius = track.y * 0.5f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({origin.x, y}, {origin.x + track.x, y + track.y},
                     on ? look.theme.accent : look.theme.line, radius);
  const float knob = on ? origin.x + track.x - radius : origin.x + radius;
  list.AddCircleFilled({knob, y + radius}, radius - look.px(2), on ? look.theme.on_accent : look.theme.dim);
  const ImU32 colour = on || ImGui::IsItemHovered() ? look.theme.text : look.theme.dim;
  draw_text(list, font, {origin.x + track.x + look.px.s, y}, colour, words);
  return clicked;
}

bool choice(const Look& look, const char* label, bool& on) {
  const std::string_view whole(label);
  const std::string_view words = whole.substr(0, whole.find("##"));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float mark = look.px.l, height = look.px(20);
  const bool clicked =
      ImGui::InvisibleButton(label, {mark + look.px.s + text_width(look.fonts.ui, words), height});
  tab_stop(look);
  if (clicked) on = !on;
  const float radius = mark * 0.5f;
  const ImVec2 centre(origin.x + radius, origin.y + height * 0.5f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircle(centre, radius - look.px(2), on ? look.theme.accent : look.theme.dim, 0, look.px(1.5f));
  if (on) list.AddCircleFilled(centre, radius - look.px(5), look.theme.accent);
  const ImU32 colour = on || ImGui::IsItemHovered() ? look.theme.text : look.theme.dim;
  draw_text(list, look.fonts.ui, {origin.x + mark + look.px.s, origin.y + look.px(2)}, colour, words);
  return clicked;
}

bool combo(const Look& look, const char* id, std::span<const char* const> items, int& current, float width) {
  const bool known = current >= 0 && current < static_cast<int>(items.size());
  const char* shown_item = known ? items[static_cast<std::size_t>(current)] : "";
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(look.px(10), (look.px.control - look.fonts.ui->FontSize) * 0.5f));
  if (width <= 0) width = text_width(look.fonts.ui, shown_item) + look.px(40);
  ImGui::SetNextItemWidth(width);
  const int before = current;
  const std::string preview = elide(look.fonts.ui, shown_item, width - look.px(34));
  const bool open =
      ImGui::BeginCombo(id, preview.c_str(), ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLarge);
  if (open) {
    for (int i = 0; i < static_cast<int>(items.size()); ++i) {
      if (ImGui::Selectable(items[static_cast<std::size_t>(i)], i == before)) current = i;
      tab_stop(look);
      if (i == before && ImGui::IsWindowAppearing()) first_tab_stop(look);
    }
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
  bool& was_open = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetItemID());
  if (std::exchange(was_open, open) && !open && look.focus != nullptr) look.focus->come_back_to_item();
  tab_stop(look);
  const ImVec2 max = ImGui::GetItemRectMax();
  const float y = (ImGui::GetItemRectMin().y + max.y) * 0.5f;
  if (!open) {
    draw_icon(*ImGui::GetWindowDrawList(), look.fonts.ui, {max.x - look.px(14), y}, look.theme.dim,
              icon::caret_down);
  }
  return current != before;
}

bool code_field(const Look& look, const char* id, const char* placeholder, std::string& text, float width,
                Fault fault) {
  const float vertical = (look.px.control - look.fonts.mono->FontSize) * 0.5f;
  ImGui::PushFont(look.fonts.mono);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px(10), vertical));
  if (fault == Fault::refused) ImGui::PushStyleColor(ImGuiCol_Text, look.theme.bad);
  ImGui::SetNextItemWidth(width);
  // Enter would take the keyboard away from the field, and the next keys would do what they do elsewhere.
  ImGuiIO& io = ImGui::GetIO();
  const bool typing = ImGui::GetActiveID() == ImGui::GetID(id);
  const bool entered =
      typing && (ImGui::IsKeyPressed(key::kEnter, false) || ImGui::IsKeyPressed(key::kKeypadEnter, false));
  if (typing && is_enter_down(io))
    for (const int each : {key::kEnter, key::kKeypadEnter}) key::take(io, each);
  // Escape leaves the field too, and ImGui's own would take back what was typed.
  if (typing && ImGui::IsKeyPressed(key::kEscape, false)) {
    ImGui::ClearActiveID();
    key::take(io, key::kEscape);
  }
  if (look.focus != nullptr) look.focus->offer_field(id);
  ImGui::InputTextWithHint(id, placeholder, &text);
  ImGuiInputTextState* state = ImGui::GetInputTextState(ImGui::GetID(id));
  if (entered && state != nullptr && fault != Fault::none) state->SelectAll();
  if (entered && state != nullptr && fault == Fault::none) state->ClearText();
  if (fault == Fault::refused) ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::PopFont();
  return entered;
}

bool search_box(const Look& look, const char* id, const char* placeholder, const char* keys,
                std::string& text, float width) {
  const float vertical = (look.px(26) - look.fonts.ui->FontSize) * 0.5f;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px(10), vertical));
  ImGui::SetNextItemWidth(width);
  if (look.focus != nullptr) look.focus->offer_field(id);
  const bool changed = ImGui::InputTextWithHint(id, placeholder, &text);
  ImGui::PopStyleVar();
  const ImVec2 max = ImGui::GetItemRectMax();
  if (text.empty() && keys[0] != '\0') {
    const float x = max.x - look.px(26) - text_width(look.fonts.ui, keys);
    draw_text(*ImGui::GetWindowDrawList(), look.fonts.ui, {x, ImGui::GetItemRectMin().y + vertical},
              look.theme.faint, keys);
  }
  return changed;
}

}  // namespace replan::ui
