// Design tokens: every colour, distance and size of the window has its name here. Panels use names, never
// literal colours, so that a theme is one table.
#pragma once

#include <string_view>

#include <imgui.h>

namespace replan::ui {

/// Named colours (IM_COL32 layout). Words are written in text, dim, faint, accent, warning, bad and good, on background,
/// panel, raised, hover and selected; each of these stands out from each of those by kTextContrast or more. The others
/// are for marks.
struct Theme {
  std::string_view name;
  ImU32 background;  ///< behind everything
  ImU32 panel;       ///< side, tools, transport
  ImU32 raised;      ///< buttons, status bar
  ImU32 line;        ///< 1 px separators
  ImU32 text;        ///< values
  ImU32 dim;         ///< labels
  ImU32 faint;       ///< column heads, disabled
  ImU32 accent;      ///< what is chosen, rp, the playhead
  ImU32 on_accent;   ///< text and icons on the accent
  ImU32 start;
  ImU32 goal;
  ImU32 robot;
  ImU32 surprise;  ///< dropped obstacles
  ImU32 mover;     ///< ways of moving obstacles
  ImU32 warning;   ///< last repair, underconsistent
  ImU32 bad;
  ImU32 good;
  ImU32 obstacle;
  ImU32 free;
  ImU32 surround;  ///< around the world
  ImU32 unseen;    ///< what a map calls unknown and counts as blocked
  ImU32 rhs;       ///< the number rhs, beside g in the colour of text
  ImU32 path;
  ImU32 grid;           ///< grid lines, already translucent
  ImU32 arrow;          ///< lp arrows, already translucent
  ImU32 outline;        ///< the ring around start, goal and robot, against any field colour
  ImU32 selected;       ///< behind the chosen tool, the winning row, the current line
  ImU32 hover;          ///< behind what the mouse is over
  ImU32 series;         ///< filled curves, as of expansions over the timeline
  ImU32 shade;          ///< over the window behind a dialog, translucent
  float field_opacity;  ///< of colour maps over free cells
  bool is_dark;
};

const Theme& dark();
const Theme& light();
/// "light" or "dark"; anything else is dark.
const Theme& theme_named(std::string_view name);

/// a at t = 0, b at t = 1; alpha too.
ImU32 mix(ImU32 a, ImU32 b, float t);
ImU32 with_alpha(ImU32 colour, float alpha);
/// A field colour as it stands over a free cell: blended at the theme's opacity, opaque.
ImU32 over_free(const Theme& theme, ImU32 field);
/// The ratio of luminances after WCAG 2 (1 to 21), for tests of readability.
float contrast(ImU32 a, ImU32 b);
/// What text needs to be read by everybody, after WCAG 2 (AA).
inline constexpr float kTextContrast = 4.5f;
/// The ground of a button that loses something, while the mouse is over it.
ImU32 danger_ground(const Theme& theme);

/// The chips' share of panel colour over the canvas.
inline constexpr float kChipOpacity = 0.88f;

/// Distances in pixels of the display: the design's, times its scale, rounded to whole pixels.
struct Metrics {
  /// `fingers`: all that is pressed is large enough for them.
  explicit Metrics(float display_scale = 1.0f, bool fingers = false);
  /// Any other length of the design, in whole pixels; never 0 for a length above 0.
  [[nodiscard]] float operator()(float design_pixels) const;

  float scale;
  bool fingers;
  float hair;              ///< separators
  float xs, s, m, l;       ///< 4 inside controls, 8 between them, 12 and 16 around sections
  float radius, radius_l;  ///< 6 for controls, 8 for chips
  float menu, tools, side, transport, status;
  float control;   ///< height of buttons, combos and inputs
  float tool;      ///< side of a tool button
  float row;       ///< height of a table row
  float small;     ///< side of a small button
  float menu_gap;  ///< between the entries of a menu
};

/// Sets every colour and metric of ImGui's style, so that nothing of its default look remains.
void apply(ImGuiStyle& style, const Theme& theme, const Metrics& metrics);

}  // namespace replan::ui
