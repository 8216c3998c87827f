// The style guide: every widget in one picture, drawn without a display.
//   gallery OUT.png [dark|light] [SCALE]
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/platform/offscreen.hpp"
#include "ui/icons.hpp"
#include "ui/widgets.hpp"

namespace {

using namespace replan::ui;
namespace app = replan::app;

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// What the widgets change.
struct State {
  int tab = 1;
  int step = 0;
  bool on = true;
  bool off = false;
  double speed = 240;
  double weight = 1.5;
  std::string search;
};

void area(const char* id, ImVec2 pos, ImVec2 size, ImU32 ground, ImVec2 padding,
          const std::function<void()>& draw) {
  ImGui::SetNextWindowPos(pos);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ground);
  ImGui::Begin(id, nullptr, kFixed);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
  draw();
  ImGui::End();
}

void menu(const Look& look, State& state, float width) {
  area("menu", {0, 0}, {width, look.px.menu}, look.theme.panel, {0, 0}, [&] {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float x = look.px(14);
    draw_text(list, look.fonts.title, {x, look.px(9)}, look.theme.text, "Replan");
    x += text_width(look.fonts.title, "Replan") + look.px(21);
    for (const char* name : {"File", "Edit", "World", "Planner", "View", "Record", "Help"}) {
      draw_text(list, look.fonts.ui, {x, look.px(9)}, look.theme.dim, name);
      x += text_width(look.fonts.ui, name) + look.px(21);
    }
    ImGui::SetCursorPos({width - look.px(244), look.px(4)});
    search_box(look, "##search", "Search commands", "Ctrl P", state.search, look.px(230));
    edge(look, Edge::bottom);
  });
}

void tools(const Look& look, float height) {
  area("tools", {0, look.px.menu}, {look.px.tools, height}, look.theme.panel, {look.px(7), look.px(8)}, [&] {
    const std::array<IconButton, 13> buttons = {{
        {.icon = icon::pointer, .hint = {"Inspect", "V"}},
        {.icon = icon::brush, .hint = {"Paint", "B"}, .selected = true},
        {.icon = icon::eraser, .hint = {}},
        {.icon = icon::square, .hint = {}},
        {.icon = icon::pencil, .hint = {}},
        {.icon = icon::fill, .hint = {}},
        {.icon = icon::start, .hint = {}, .colour = look.theme.start},
        {.icon = icon::goal_race, .hint = {}, .colour = look.theme.goal},
        {.icon = icon::bolt, .hint = {}, .colour = look.theme.surprise},
        {.icon = icon::move, .hint = {}},
        {.icon = icon::arrows_h, .hint = {}},
        {.icon = icon::list, .hint = {}, .enabled = false},
        {.icon = icon::camera, .hint = {}},
    }};
    edge(look, Edge::right);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, look.px.xs));
    for (std::size_t i = 0; i < buttons.size(); ++i) {
      if (i == 1 || i == 6 || i == 8) tool_separator(look);
      tool_button(look, std::to_string(i).c_str(), buttons[i]);
    }
    ImGui::PopStyleVar();
  });
}

void cell_panel(const Look& look) {
  const ImU32 under = look.theme.warning;
  section_title(look, "Cell (31, 18) — pinned");
  const std::array<KeyValue, 8> values = {{{"g", "41.213"},
                                           {"rhs", "43.799"},
                                           {"dist", "1.586"},
                                           {"state", "under", under, true},
                                           {"key", "62.4 ; 41.2"},
                                           {"in U", "yes, #3"},
                                           {"lp", "(32, 19)"},
                                           {"rp", "(38, 27)"}}};
  key_values(look, values);
  section_rule(look);
  section_title(look, "Why is rhs 43.799?");
  const std::array<Column, 5> columns = {
      {{"neighbour", 1.6f, Align::left}, {"c"}, {"g", 1.15f}, {"dist"}, {"sum", 1.15f}}};
  table_header(look, columns);
  const std::array<TableCell, 5> first = {{{"(32, 19)"}, {"1.414"}, {"40.799"}, {"1.586"}, {"43.799"}}};
  const std::array<TableCell, 5> second = {{{"(32, 18)"}, {"1.000"}, {"42.213"}, {"2.000"}, {"45.213"}}};
  const std::array<TableCell, 5> more = {{{"4 more", look.theme.faint}, {}, {}, {}, {"∞", look.theme.faint}}};
  table_row(look, 0, columns, first, true);
  table_row(look, 1, columns, second);
  table_row(look, 2, columns, more);
  section_rule(look);
  section_title(look, "ComputeShortestPath");
  code_line(look, {42, "while U.TopKey() < CalculateKey(s_start)"});
  code_line(look, {43, "  k_old ← U.TopKey()"});
  code_line(look, {.number = 58, .text = "else", .breakpoint = true});
  code_line(look, {59, "  g(u) ← ∞", true});
  code_line(look, {60, "  UpdateVertex(Pred(u) ∪ u)"});
}

void inputs_panel(const Look& look, State& state) {
  section_rule(look);
  section_title(look, "Settings");
  slider(look, {.label = "Weight ε", .min = 1, .max = 5, .initial = 1}, state.weight);
  slider(look,
         {.label = "Speed",
          .min = 1,
          .max = 1e6,
          .initial = 240,
          .unit = "/s",
          .decimals = 0,
          .logarithmic = true},
         state.speed);
  toggle(look, "Corner cutting", state.on);
  ImGui::SameLine(0, look.px(24));
  toggle(look, "Lazy sight", state.off);
  button(look, "Run study", ButtonKind::primary, icon::play);
  ImGui::SameLine();
  button(look, "Export…");
  ImGui::SameLine();
  button(look, "Reset", ButtonKind::quiet);
  button(look, "Delete all", ButtonKind::danger, icon::trash);
  ImGui::SameLine();
  key_chip(look, "Ctrl+P");
  progress(look, 0.37f, "Planning, 12 s left");
  paragraph(look.fonts.small, look.theme.dim,
            "← → ↔ ∞ √ ≤ ≥ ≠ ∈ ∪ − × · … – — ° µ ρ Σ ✓ ✗ ε λ θ² 重新规划路径");
  text(look.fonts.mono, look.theme.text, "← → ↔ ∞ √ ≤ ≥ ≠ ∈ ∪ − × · … – — ° µ ρ Σ ✓ 规划");
}

void side(const Look& look, State& state, ImVec2 pos, float height) {
  area("side", pos, {look.px.side, height}, look.theme.panel, {0, 0}, [&] {
    constexpr std::array<Tab, 6> all = {
        {{"Planner"}, {"Cell"}, {"Open list"}, {"Code"}, {"Figures"}, {"Log"}}};
    tabs(look, "tabs", all, state.tab);
    edge(look, Edge::left);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.l, look.px.m));
    ImGui::BeginChild("content", {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleVar();
    cell_panel(look);
    inputs_panel(look, state);
    ImGui::EndChild();
  });
}

void canvas(const Look& look, ImTextureID raster, ImVec2 min, ImVec2 max) {
  area("canvas", min, {max.x - min.x, max.y - min.y}, look.theme.background, {0, 0}, [&] {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float size = look.px(560);
    list.AddImage(raster, {min.x + look.px(14), min.y + look.px(14)},
                  {min.x + look.px(14) + size, min.y + look.px(14) + size});
    const std::array<TextRun, 2> title = {
        {{"D* Lite", look.theme.text, look.fonts.title},
         {"1 284 expansions · 61 nodes", look.theme.dim, look.fonts.small}}};
    chip(look, list, {min.x + look.px(13), min.y + look.px(11)}, title);
    const std::array<TextRun, 1> repair = {
        {{"replan 3 · 212 of 1 391 touched", look.theme.warning, look.fonts.ui}}};
    chip(look, list, {max.x - look.px(13), min.y + look.px(11)}, repair, Corner::top_right);
    const std::array<LegendEntry, 7> entries = {{{Mark::outline, look.theme.warning, "last repair"},
                                                 {Mark::arrow, look.theme.dim, "lp"},
                                                 {Mark::long_arrow, look.theme.accent, "rp"},
                                                 {Mark::dot, look.theme.start, "start"},
                                                 {Mark::square, look.theme.surprise, "surprise"},
                                                 {Mark::line, look.theme.path, "path"},
                                                 {Mark::dashed, look.theme.robot, "sensor"}}};
    const std::array<LegendEntry, 0> none = {};
    legend(look, list, {min.x + look.px(13), max.y - look.px(60)}, {"g", &viridis(), "0", "74.6"}, none);
    legend(look, list, {min.x + look.px(13), max.y - look.px(13)}, {"g + dist", &viridis(), "0", "74.6"},
           entries);
    static const Colormap signed_map = diverging(look.theme);
    legend(look, list, {max.x - look.px(13), max.y - look.px(60)}, {"g − rhs", &signed_map, "−8", "8"}, none,
           Corner::bottom_right);
    ImGui::SetCursorScreenPos({min.x + look.px(590), min.y + look.px(120)});
    ImGui::BeginChild("empty", {look.px(380), look.px(300)});
    empty_state(look, icon::map, "No world is open",
                "Paint one with the brush, open a .map file, or drop a file onto the window.");
    ImGui::EndChild();
  });
}

void transport(const Look& look, State& state, ImVec2 pos, float width) {
  area("transport", pos, {width, look.px.transport}, look.theme.panel, {look.px.l, look.px(14)}, [&] {
    edge(look, Edge::top);
    const std::array<const char*, 7> icons = {icon::fast_backward, icon::backward,     icon::step_backward,
                                              icon::play,          icon::step_forward, icon::forward,
                                              icon::fast_forward};
    for (std::size_t i = 0; i < icons.size(); ++i) {
      transport_button(look, std::to_string(i).c_str(), {.icon = icons[i], .hint = {}, .selected = i == 3});
      ImGui::SameLine(0, look.px(6));
    }
    ImGui::SameLine(0, look.px(20));
    ImGui::AlignTextToFramePadding();
    text(look.fonts.ui, look.theme.dim, "Step");
    ImGui::SameLine(0, look.px(6));
    constexpr std::array<const char*, 3> steps = {"expansion", "replan", "robot move"};
    combo(look, "##step", steps, state.step);
    ImGui::SameLine(0, look.px(20));
    labelled(look, "Speed", "240 /s");
  });
}

void status_bar(const Look& look, float y, float width) {
  area("status", {0, y}, {width, look.px.status}, look.theme.raised, {look.px(14), look.px(5)}, [&] {
    edge(look, Edge::top);
    labelled(look, "Cell", "31, 18");
    ImGui::SameLine(0, look.px(22));
    text(look.fonts.ui, look.theme.dim, "free · known");
    ImGui::SameLine(0, look.px(22));
    labelled(look, "Zoom", "14×");
    ImGui::SameLine(0, look.px(22));
    labelled(look, "km", "21.07");
    ImGui::SameLine(0, look.px(22));
    status(look, look.theme.good, "oracle agrees");
    ImGui::SameLine(0, look.px(22));
    status(look, look.theme.good, "invariants hold");
  });
}

/// A round field with rings of obstacles, through the same texture path as the canvas.
std::vector<std::uint32_t> field(const Theme& theme, int side) {
  std::vector<std::uint32_t> cells;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float d = std::hypot(static_cast<float>(x - side / 2), static_cast<float>(y - side / 2)) /
                      static_cast<float>(side) * 1.4f;
      const bool wall = (x / 5 + y / 7) % 4 == 0 && x % 5 < 3;
      cells.push_back(wall ? theme.obstacle : over_free(theme, sample(viridis(), d)));
    }
  }
  return cells;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string out = argc > 1 ? argv[1] : "gallery.png";
  const float scale = argc > 3 ? std::strtof(argv[3], nullptr) : 1.0f;
  const auto pixels = [scale](int n) { return static_cast<int>(static_cast<float>(n) * scale); };
  auto offscreen = app::Offscreen::create({pixels(1440), pixels(900), scale});
  if (!offscreen) return std::fprintf(stderr, "%s\n", offscreen.error().c_str()), 1;
  Stage& stage = (*offscreen)->stage();
  stage.set_theme(theme_named(argc > 2 ? argv[2] : "dark"));
  stage.set_language("重新规划路径", false);
  State state;
  ImTextureID raster = nullptr;
  const auto draw = [&] {
    const Look& look = stage.look();
    if (raster == nullptr)
      raster = stage.renderer().create_texture(40, 40, field(look.theme, 40), Filter::cells);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float bottom = size.y - look.px.status;
    const float split = size.x - look.px.side;
    menu(look, state, size.x);
    tools(look, bottom - look.px.menu - look.px.transport);
    canvas(look, raster, {look.px.tools, look.px.menu}, {split, bottom - look.px.transport});
    transport(look, state, {0, bottom - look.px.transport}, split);
    side(look, state, {split, look.px.menu}, bottom - look.px.menu);
    status_bar(look, bottom, size.x);
  };
  if (argc > 5) stage.input().mouse_move(std::strtof(argv[4], nullptr), std::strtof(argv[5], nullptr));
  for (int i = 0; i < 40; ++i) (*offscreen)->frame(draw);
  for (const std::string& notice : stage.notices()) std::fprintf(stderr, "%s\n", notice.c_str());
  const replan::Result<void> saved = write_png(out, (*offscreen)->picture());
  if (!saved) return std::fprintf(stderr, "%s\n", saved.error().c_str()), 1;
  return 0;
}
