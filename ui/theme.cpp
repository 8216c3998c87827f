#include "ui/theme.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/palette.hpp"

namespace replan::ui {
namespace {

/// 0xRRGGBB, as designers write it.
constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
  return IM_COL32((hex >> 16) & 255u, (hex >> 8) & 255u, hex & 255u, alpha);
}

// clang-format off
constexpr Theme kDark = {
    .name = "dark",
    .background = rgb(0x14171c), .panel = rgb(0x1b1f26), .raised = rgb(0x222832), .line = rgb(0x2d3440),
    .text = rgb(0xe6e9ee), .dim = rgb(0xa3adbb), .faint = rgb(0x939eae),
    .accent = rgb(0x4cc2ff), .on_accent = rgb(0x10131a),
    .start = rgb(0x3ddc97), .goal = rgb(0xff5c8a), .robot = rgb(0xffc94d),
    .surprise = rgb(0xff8a3d), .mover = rgb(0xb79cff), .warning = rgb(0xffb454), .bad = rgb(0xff7676), .good = rgb(0x3ddc97),
    .obstacle = rgb(0x465468), .free = rgb(0x10131a),
    .surround = rgb(0x1f252e), .unseen = rgb(0x85755c), .rhs = rgb(0xc5f06b), .path = rgb(0xffffff),
    .grid = rgb(0xffffff, 13), .arrow = rgb(0xffffff, 115), .outline = rgb(0x10131a),
    .selected = rgb(0x243746), .hover = rgb(0x2a313d), .series = rgb(0x253f51), .shade = rgb(0x0b0d10, 150),
    .field_opacity = 0.55f, .is_dark = true,
};

constexpr Theme kLight = {
    .name = "light",
    .background = rgb(0xeceff3), .panel = rgb(0xffffff), .raised = rgb(0xf4f6f9), .line = rgb(0xd9dee6),
    .text = rgb(0x1b2430), .dim = rgb(0x4d5a6b), .faint = rgb(0x5a6677),
    .accent = rgb(0x006bb0), .on_accent = rgb(0xffffff),
    .start = rgb(0x12855a), .goal = rgb(0xd6336c), .robot = rgb(0xa36300),
    .surprise = rgb(0xe8590c), .mover = rgb(0x6f42c1), .warning = rgb(0x8f5600), .bad = rgb(0xbf2626), .good = rgb(0x0f7049),
    .obstacle = rgb(0x3f4a59), .free = rgb(0xffffff),
    .surround = rgb(0xdbe1e9), .unseen = rgb(0xb5aa9a), .rhs = rgb(0x4d7c0f), .path = rgb(0x111827),
    .grid = rgb(0x111827, 26), .arrow = rgb(0x111827, 115), .outline = rgb(0xffffff),
    .selected = rgb(0xd6e9f6), .hover = rgb(0xe9edf2), .series = rgb(0xcce4f3), .shade = rgb(0x1b2430, 90),
    .field_opacity = 0.62f, .is_dark = false,
};
// clang-format on

void apply_metrics(ImGuiStyle& style, const Metrics& px) {
  style = ImGuiStyle();
  style.WindowPadding = {px.l, px.m};
  style.WindowRounding = style.PopupRounding = px.radius_l;
  style.ChildRounding = 0;
  style.FrameRounding = style.GrabRounding = style.TabRounding = px.radius;
  style.ScrollbarRounding = px(4);
  style.WindowBorderSize = style.PopupBorderSize = style.FrameBorderSize = px.hair;
  style.ChildBorderSize = style.TabBorderSize = 0;
  style.FramePadding = {px(10), px(5)};
  style.ItemSpacing = {px.s, px.s};
  style.ItemInnerSpacing = {px.s, px.xs};
  style.CellPadding = {px(6), px(3)};
  style.IndentSpacing = px.l;
  style.ScrollbarSize = px(10);
  style.GrabMinSize = px(12);
  style.WindowMinSize = {px(32), px(32)};
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.WindowTitleAlign = {0.0f, 0.5f};
  style.DisabledAlpha = 0.45f;
  style.CircleTessellationMaxError = 0.2f;
}

/// Colours of controls: fields, buttons, rows.
void apply_controls(ImVec4* colours, const Theme& t) {
  const auto set = [colours](int slot, ImU32 colour) {
    colours[slot] = ImGui::ColorConvertU32ToFloat4(colour);
  };
  set(ImGuiCol_Text, t.text);
  set(ImGuiCol_TextDisabled, t.faint);
  set(ImGuiCol_TextSelectedBg, with_alpha(t.accent, 0.35f));
  set(ImGuiCol_FrameBg, t.panel);
  set(ImGuiCol_FrameBgHovered, t.raised);
  set(ImGuiCol_FrameBgActive, t.raised);
  set(ImGuiCol_CheckMark, t.accent);
  set(ImGuiCol_SliderGrab, t.accent);
  set(ImGuiCol_SliderGrabActive, t.accent);
  set(ImGuiCol_Button, t.raised);
  set(ImGuiCol_ButtonHovered, t.hover);
  set(ImGuiCol_ButtonActive, t.selected);
  set(ImGuiCol_Header, t.selected);
  set(ImGuiCol_HeaderHovered, t.hover);
  set(ImGuiCol_HeaderActive, t.selected);
  set(ImGuiCol_PlotLines, t.accent);
  set(ImGuiCol_PlotLinesHovered, t.text);
  set(ImGuiCol_PlotHistogram, t.accent);
  set(ImGuiCol_PlotHistogramHovered, t.text);
  set(ImGuiCol_DragDropTarget, t.accent);
}

/// Colours of surfaces: windows, tabs, tables, scroll bars.
void apply_surfaces(ImVec4* colours, const Theme& t) {
  const auto set = [colours](int slot, ImU32 colour) {
    colours[slot] = ImGui::ColorConvertU32ToFloat4(colour);
  };
  set(ImGuiCol_WindowBg, t.panel);
  set(ImGuiCol_ChildBg, IM_COL32_BLACK_TRANS);
  set(ImGuiCol_PopupBg, t.panel);
  set(ImGuiCol_Border, t.line);
  set(ImGuiCol_BorderShadow, IM_COL32_BLACK_TRANS);
  set(ImGuiCol_TitleBg, t.panel);
  set(ImGuiCol_TitleBgActive, t.panel);
  set(ImGuiCol_TitleBgCollapsed, t.panel);
  set(ImGuiCol_MenuBarBg, t.panel);
  set(ImGuiCol_ScrollbarBg, IM_COL32_BLACK_TRANS);
  set(ImGuiCol_ScrollbarGrab, t.line);
  set(ImGuiCol_ScrollbarGrabHovered, t.faint);
  set(ImGuiCol_ScrollbarGrabActive, t.dim);
  set(ImGuiCol_Separator, t.line);
  set(ImGuiCol_SeparatorHovered, t.accent);
  set(ImGuiCol_SeparatorActive, t.accent);
  set(ImGuiCol_ResizeGrip, IM_COL32_BLACK_TRANS);
  set(ImGuiCol_ResizeGripHovered, t.faint);
  set(ImGuiCol_ResizeGripActive, t.accent);
  set(ImGuiCol_Tab, t.panel);
  set(ImGuiCol_TabHovered, t.hover);
  set(ImGuiCol_TabActive, t.selected);
  set(ImGuiCol_TabUnfocused, t.panel);
  set(ImGuiCol_TabUnfocusedActive, t.selected);
  set(ImGuiCol_TableHeaderBg, t.panel);
  set(ImGuiCol_TableBorderStrong, t.line);
  set(ImGuiCol_TableBorderLight, t.line);
  set(ImGuiCol_TableRowBg, IM_COL32_BLACK_TRANS);
  set(ImGuiCol_TableRowBgAlt, with_alpha(t.raised, 0.6f));
  set(ImGuiCol_NavHighlight, t.accent);
  set(ImGuiCol_NavWindowingHighlight, t.accent);
  set(ImGuiCol_NavWindowingDimBg, t.shade);
  set(ImGuiCol_ModalWindowDimBg, t.shade);
}

}  // namespace

const Theme& dark() {
  return kDark;
}
const Theme& light() {
  return kLight;
}
const Theme& theme_named(std::string_view name) {
  return name == kLight.name ? kLight : kDark;
}

ImU32 mix(ImU32 a, ImU32 b, float t) {
  ImU32 result = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto from = static_cast<float>((a >> shift) & 255u);
    const auto to = static_cast<float>((b >> shift) & 255u);
    result |= static_cast<ImU32>(std::lround(from + (to - from) * std::clamp(t, 0.0f, 1.0f))) << shift;
  }
  return result;
}

ImU32 with_alpha(ImU32 colour, float alpha) {
  const auto byte = static_cast<ImU32>(std::lround(std::clamp(alpha, 0.0f, 1.0f) * 255.0f));
  return (colour & ~IM_COL32_A_MASK) | (byte << IM_COL32_A_SHIFT);
}

ImU32 over_free(const Theme& theme, ImU32 field) {
  return mix(theme.free, field, theme.field_opacity);
}

ImU32 danger_ground(const Theme& theme) {
  return mix(theme.panel, theme.bad, 0.12f);
}

float contrast(ImU32 a, ImU32 b) {
  return static_cast<float>(replan::contrast(a, b));
}

Metrics::Metrics(float display_scale, bool its_fingers) : scale(display_scale), fingers(its_fingers) {
  const Metrics& px = *this;
  hair = std::max(1.0f, std::floor(scale));
  xs = px(4), s = px(8), m = px(12), l = px(16);
  radius = px(6), radius_l = px(8);
  menu = px(34), tools = px(48), side = px(372), transport = px(132), status = px(26);
  control = px(28), tool = px(34), row = px(23), small = px(24), menu_gap = px(7);
  if (!fingers) return;
  menu = px(44), tools = px(54), status = px(36);
  control = px(36), tool = px(40), row = px(36), small = px(36), menu_gap = px(22);
}

float Metrics::operator()(float design_pixels) const {
  return design_pixels > 0 ? std::max(1.0f, std::round(design_pixels * scale))
                           : std::round(design_pixels * scale);
}

void apply(ImGuiStyle& style, const Theme& theme, const Metrics& metrics) {
  apply_metrics(style, metrics);
  apply_controls(style.Colors, theme);
  apply_surfaces(style.Colors, theme);
}

}  // namespace replan::ui
