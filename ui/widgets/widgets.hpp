// The widgets that all panels share, so that all panels look the same. Each draws itself from the Look; none
// keeps state of its own beyond what ImGui remembers by id.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "ui/colormap.hpp"
#include "ui/look.hpp"

namespace replan::ui {

// --- Text -----------------------------------------------------------------------------------------------

[[nodiscard]] float text_width(const ImFont* font, std::string_view text);
/// The text, or its beginning and "…" if it is wider than `width`.
[[nodiscard]] std::string elide(const ImFont* font, std::string_view text, float width);
/// Draws at a place; `pos` is the top left of the line.
void draw_text(ImDrawList& list, const ImFont* font, ImVec2 pos, ImU32 colour, std::string_view text);
/// Draws the text in that room; if it is shortened a tooltip has all of it.
void draw_line(const Look& look, ImDrawList& list, const ImFont* font, ImVec2 pos, ImU32 colour,
               std::string_view text, float room);
/// Draws centred in a rectangle by the line's height and the text's width.
void draw_text_centred(ImDrawList& list, const ImFont* font, ImVec2 min, ImVec2 max, ImU32 colour,
                       std::string_view text);
/// Draws one icon centred by its ink, not by its advance: icons differ in their bearings.
void draw_icon(ImDrawList& list, const ImFont* font, ImVec2 centre, ImU32 colour, const char* icon);

/// One line of text as an item.
void text(const ImFont* font, ImU32 colour, std::string_view text);
/// The same in that room, as draw_line().
void text_line(const Look& look, const ImFont* font, ImU32 colour, std::string_view text, float room);
/// Text over several lines, wrapped at the content's right edge.
void paragraph(const ImFont* font, ImU32 colour, std::string_view text);
/// The same of a text with the marks of core/base/markdown.hpp, at most `widest` wide; 0: as wide as there is room.
void marked_paragraph(const Look& look, ImU32 colour, std::string_view markdown, float widest = 0);
/// How high that is where there is room for `whole` pixels.
float marked_paragraph_height(const Look& look, std::string_view markdown, float whole, float widest = 0);

// --- Hints ----------------------------------------------------------------------------------------------

/// What a tooltip says: the action, its keys ("Ctrl+Z"), and a sentence or two that teach.
struct Hint {
  const char* title = "";
  const char* keys = "";
  const char* teach = "";
};
/// Shows the tooltip of the last item after a moment's hover; also over disabled items.
void hint(const Look& look, const Hint& what);
/// A key as a chip, as an item.
void key_chip(const Look& look, const char* keys);

// --- Keyboard -------------------------------------------------------------------------------------------

/// The last item can be come to by Tab and pressed by Space; while it has the keyboard there is a ring around it.
void tab_stop(const Look& look);
/// The last item, in a list that has just opened over the window, is where Up and Down begin.
void first_tab_stop(const Look& look);
/// For the last item, a control that Left and Right change: how often they were pressed to the right, below 0 to the left,
/// while it has the keyboard.
int arrow_steps(const Look& look);

// --- Buttons --------------------------------------------------------------------------------------------

struct IconButton {
  const char* icon;
  Hint hint;
  bool selected = false;
  bool enabled = true;
  ImU32 colour = 0;  ///< 0: the theme's own
  bool tab_stop = true;
};
/// 34 x 34 in the tool strip; selected: accent icon on a tinted ground.
bool tool_button(const Look& look, const char* id, const IconButton& button);
/// A short line between groups of tools.
void tool_separator(const Look& look);
/// 32 x 28 in the transport; selected: the primary one (play), filled with the accent.
bool transport_button(const Look& look, const char* id, const IconButton& button);
/// 24 x 24 without a ground until hovered: beside titles and in rows.
bool small_button(const Look& look, const char* id, const IconButton& button);

enum class ButtonKind { primary, plain, quiet, danger };
/// A labelled button; `icon` may be empty. The label is its id; "##" hides what follows it.
bool button(const Look& look, const char* label, ButtonKind kind = ButtonKind::plain, const char* icon = "");

struct MenuEntry {
  const char* icon = "";
  const char* keys = "";
  bool on = false;  ///< ticked
  bool enabled = true;
};
/// A line of a menu, which Tab, Up and Down come to; whether it was chosen.
bool menu_item(const Look& look, const char* label, const MenuEntry& entry = {});

/// A tab's name, and what its tooltip says.
struct Tab {
  const char* name;
  Hint hint = {};
};
/// Flat text tabs with an accent underline; returns whether `current` changed.
bool tabs(const Look& look, const char* id, std::span<const Tab> all, int& current);

/// One of a few choices, side by side in a box of the content's width; returns whether `current` changed.
bool segments(const Look& look, const char* id, std::span<const char* const> names, int& current);

// --- Structure ------------------------------------------------------------------------------------------

void section_title(const Look& look, std::string_view title);
/// While it lives, small buttons come at the right end of the section title that was drawn last, px.xs apart; what is drawn
/// after it stands below the title.
class BesideTitle {
 public:
  BesideTitle(const Look& look, int buttons);
  ~BesideTitle();
  BesideTitle(const BesideTitle&) = delete;
  BesideTitle& operator=(const BesideTitle&) = delete;

 private:
  ImVec2 below_;
};
/// A separator over the whole width of the window, with space around.
void section_rule(const Look& look);
/// A hairline along an edge of the current window, over its padding: between panels.
enum class Edge { left, right, top, bottom };
void edge(const Look& look, Edge side);
/// Icon, title and a sentence in the middle of the space that is left: what can I do here?
void empty_state(const Look& look, const char* icon, std::string_view title, std::string_view advice);
/// A bar from 0 to 1; below 0: unknown, drawn moving.
void progress(const Look& look, float fraction, std::string_view label);

// --- Values ---------------------------------------------------------------------------------------------

enum class Align { left, right };

struct KeyValue {
  std::string_view key;
  std::string_view value;
  ImU32 colour = 0;     ///< of the value; 0: text
  bool strong = false;  ///< semibold
};
/// Pairs in `columns` columns, filled row by row. Returns the number of the one under the mouse, -1 for none;
/// it is the last item, and lit if `live`.
int key_values(const Look& look, std::span<const KeyValue> pairs, int columns = 2, Align align = Align::left,
               bool live = false);

struct Column {
  const char* name;
  float weight = 1;  ///< share of the width
  Align align = Align::right;
};
struct TableCell {
  std::string_view text;
  ImU32 colour = 0;
  bool strong = false;
};
/// Returns the number of the column under the mouse, -1 for none; the header is the last item.
int table_header(const Look& look, std::span<const Column> columns);
/// One row of fixed height (fits ImGuiListClipper); returns whether it was clicked.
bool table_row(const Look& look, int id, std::span<const Column> columns, std::span<const TableCell> cells,
               bool selected = false);

/// Rows of equal height that scroll by their number: ImGui's scroll positions are floats, too coarse for a
/// million rows. `first` is the row at the top and may lie between two.
struct RowScroll {
  double first = 0;
};
/// The rows that are to be drawn, [first, last).
struct RowsInSight {
  std::size_t first = 0, last = 0;
};
/// Begins a list of `count` rows of Metrics::row, `height` pixels high; 0: the rest of the window. Draw the
/// rows in sight, with table_row() or as high, then end_rows().
RowsInSight begin_rows(const Look& look, const char* id, std::size_t count, float height, RowScroll& scroll);
void end_rows();
/// Scrolls as little as is needed for the row to be in sight; `height` as for begin_rows().
void reveal_row(const Look& look, std::size_t row, std::size_t count, float height, RowScroll& scroll);

struct CodeLine {
  int number = 0;
  std::string_view text;
  bool current = false;
  bool breakpoint = false;
};
/// A line of pseudo-code; returns whether it was clicked in its gutter (to set a breakpoint).
bool code_line(const Look& look, const CodeLine& line);

/// A dot and its text: a verdict in the status bar.
void status(const Look& look, ImU32 colour, std::string_view text);
/// "Zoom 14x": a dim word and its number.
void labelled(const Look& look, std::string_view label, std::string_view value);

// --- Inputs ---------------------------------------------------------------------------------------------

bool combo(const Look& look, const char* id, std::span<const char* const> items, int& current,
           float width = 0);
/// A switch with its label; returns whether it changed.
bool toggle(const Look& look, const char* label, bool& on);

/// One of several of which at most one is on: the same, with the mark of a choice.
bool choice(const Look& look, const char* label, bool& on);

struct SliderSpec {
  const char* label;
  double min = 0;
  double max = 1;
  double initial = 0;  ///< the default, to which the reset button leads
  const char* unit = "";
  int decimals = 2;
  bool logarithmic = false;
  double step = 0;  ///< 0: continuous
};
/// A field for a number of 8 bytes, in the face of numbers. However it is left, by Enter, Tab or a click elsewhere, it
/// keeps what was typed; Escape takes it back. Neither key is pressed for anybody else. Whether the number changed.
bool number_field(const Look& look, const char* id, ImGuiDataType type, void* value,
                  const char* format = nullptr);

/// A label, its value with unit, and a track; the value can be typed. Whether it changed.
bool slider(const Look& look, const SliderSpec& spec, double& value, const Hint& what = {});
/// Its track and knob alone, as wide as there is room.
bool slider_track(const Look& look, const SliderSpec& spec, double& value);

/// What is wrong with the text of a field: nothing, something that the typing may still mend, or what Enter was refused
/// for.
enum class Fault { none, unfinished, refused };
/// A field for an expression, in the face of numbers, its text red where it was refused. Whether Enter was pressed: the
/// field keeps the keyboard, with its text selected if there is a fault, else ready for the next one. Escape leaves the
/// field, with what was typed.
bool code_field(const Look& look, const char* id, const char* placeholder, std::string& text, float width,
                Fault fault);
/// Words that can be clicked, in the accent's colour.
bool link(const Look& look, const char* id, std::string_view words, const ImFont* font);

/// A one-line text field with an icon, a hint inside it and the key that leads to it.
bool search_box(const Look& look, const char* id, const char* placeholder, const char* keys,
                std::string& text, float width);

// --- Over the canvas ------------------------------------------------------------------------------------

/// A rectangle of the screen; an empty one holds nothing.
struct ScreenArea {
  ImVec2 min, max;
  [[nodiscard]] bool holds(ImVec2 at) const {
    return at.x >= min.x && at.x < max.x && at.y >= min.y && at.y < max.y;
  }
};

struct TextRun {
  std::string_view text;
  ImU32 colour;
  const ImFont* font;
};
enum class Corner { top_left, top_right, bottom_left, bottom_right };
/// A floating chip with a line of text; `pos` is its named corner. Returns its size.
ImVec2 chip(const Look& look, ImDrawList& list, ImVec2 pos, std::span<const TextRun> runs,
            Corner corner = Corner::top_left);
/// A chip with a sentence, its upper left corner at `pos`; on several lines if it is wider than `room`.
ImVec2 chip_message(const Look& look, ImDrawList& list, ImVec2 pos, const TextRun& run, float room);

/// A star with so many tips around a middle, filled and with a rim; its inner corners are `inner` times as far off as them.
/// With four tips it is a diamond.
void draw_star(ImDrawList& list, ImVec2 at, float radius, int tips, float inner, ImU32 fill, ImU32 rim,
               float width);

enum class LegendShape {
  dot,
  star,
  diamond,
  ring,
  square,
  tile,  ///< of a cell, with a rim
  outline,
  corners,
  two_values,  ///< what stands before a slash in its label is in the colour of text
  up,
  down,
  line,
  dashed,
  arrow,
  long_arrow,
  cross,
  bent  ///< a line with corners
};
struct LegendEntry {
  LegendShape shape;
  ImU32 colour;
  std::string_view label;
  const char* help = "";  ///< the sentence of its tooltip
};
/// A field's gradient with its range; no map: the chip shows the entries alone.
struct LegendField {
  std::string_view label;
  const Colormap* map = nullptr;
  std::string_view min;
  std::string_view max;
  float mark = -1;     ///< where a value is marked, 0 to 1; below 0: nowhere
  float length = 120;  ///< of the gradient, in pixels of the design
};
ImVec2 legend_size(const Look& look, const LegendField& field, std::span<const LegendEntry> entries);
/// `boxes` takes where the field, if it has a map, and the entries stand.
ImVec2 legend(const Look& look, ImDrawList& list, ImVec2 pos, const LegendField& field,
              std::span<const LegendEntry> entries, Corner corner = Corner::bottom_left,
              std::vector<ScreenArea>* boxes = nullptr);

}  // namespace replan::ui
