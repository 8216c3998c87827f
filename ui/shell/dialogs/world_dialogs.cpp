#include "ui/shell/dialogs/world_dialogs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui_stdlib.h>

#include "core/base/random.hpp"
#include "core/world/generators/list.hpp"
#include "ui/icons.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr const char* kPopup = "world dialog";
constexpr double kLongestSide = 4096;
/// A preview of more cells than this waits until the mouse lets go of a slider.
constexpr std::int64_t kQuickCells = 300'000;
constexpr std::uint32_t kSeeds = 100'000;  // of the dice: short enough to be told to somebody

bool size_slider(const Look& look, const char* label, int initial, int& value) {
  double shown = value;
  const bool changed = slider(look,
                              {.label = label,
                               .min = 1,
                               .max = kLongestSide,
                               .initial = static_cast<double>(initial),
                               .unit = "cells",
                               .decimals = 0,
                               .logarithmic = true},
                              shown, {label, "", "Of the world, in cells."});
  value = static_cast<int>(shown);
  return changed;
}

/// Where a picture of these proportions lies in the middle of a box.
std::pair<ImVec2, ImVec2> fitted(ImVec2 origin, ImVec2 box, double width, double height) {
  const float scale = std::min(box.x / static_cast<float>(width), box.y / static_cast<float>(height));
  const float w = static_cast<float>(width) * scale, h = static_cast<float>(height) * scale;
  const ImVec2 min(std::floor(origin.x + (box.x - w) * 0.5f), std::floor(origin.y + (box.y - h) * 0.5f));
  return {min, {min.x + std::max(1.0f, w), min.y + std::max(1.0f, h)}};
}

/// One declared parameter as the control that fits it.
bool parameter_control(const Look& look, const Parameter& parameter, double longest, Settings& settings) {
  const std::string label(parameter.label), unit(parameter.unit), help(parameter.help);
  const Hint what{label.c_str(), "", help.c_str()};
  double value = settings.get(parameter);
  bool changed = false;
  if (parameter.type == ParameterType::toggle) {
    bool on = value != 0;
    changed = toggle(look, label.c_str(), on);
    hint(look, what);
    value = on ? 1 : 0;
  } else {
    const bool is_whole = parameter.type != ParameterType::real;
    const double high = is_whole && parameter.high > longest ? longest : parameter.high;
    changed = slider(look,
                     {.label = label.c_str(),
                      .min = parameter.low,
                      .max = std::max(high, parameter.low + 1e-9),
                      .initial = parameter.initial,
                      .unit = unit.c_str(),
                      .decimals = is_whole ? 0 : 2,
                      .logarithmic = is_whole && parameter.low > 0 && high > 100},
                     value, what);
  }
  if (changed) settings.set(parameter.key, value);
  return changed;
}

/// Of the settings: as high as they are, but so that the buttons below are in the window.
float fitting_height(const Look& look, float wanted) {
  return std::min(look.px(wanted), std::max(ImGui::GetIO().DisplaySize.y - look.px(210), look.px(80)));
}

int moved(Side side, int before, int after) {
  return side == Side::low ? 0 : side == Side::high ? after - before : (after - before) / 2;
}

}  // namespace

void WorldDialogs::show_resize(const Session& session) {
  const GridMap map = session.world();
  kind_ = Kind::resize;
  fresh_ = true;
  size_ = {map.width, map.height, Side::low, Side::low, false};
  sketch_ = MapSketch(map);
}

void WorldDialogs::show_generate(const Session& session, const WorkPlace& place) {
  kind_ = Kind::generate;
  preview_ = std::make_unique<Background<Preview>>(place);
  fresh_ = stale_ = true;
  wanted_.width = session.scenario().map.width;
  wanted_.height = session.scenario().map.height;
}

void WorldDialogs::draw(const Look& look, const Session& session, std::vector<Command>& commands) {
  if (kind_ == Kind::none) return;
  if (!ImGui::IsPopupOpen(kPopup)) ImGui::OpenPopup(kPopup);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(look.px(680), screen.x - look.px(32));
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Always, {0.5f, 0.45f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - look.px(32)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(24), look.px(20)));
  const bool shown =
      ImGui::BeginPopupModal(kPopup, nullptr,
                             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar();
  if (!shown) return;
  if (kind_ == Kind::resize)
    resize(look, session, commands);
  else
    generate(look, commands);
  fresh_ = false;
  if (kind_ == Kind::none) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

/// Nine places for the old world in the new one.
void WorldDialogs::anchors(const Look& look) {
  text(look.fonts.ui, look.theme.dim, "Where the old world stays");
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float step = look.px(28);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < 9; ++i) {
    const auto across = static_cast<Side>(i % 3), down = static_cast<Side>(i / 3);
    const ImVec2 min(origin.x + static_cast<float>(i % 3) * step,
                     origin.y + static_cast<float>(i / 3) * step);
    const ImVec2 max(min.x + step - look.px.xs, min.y + step - look.px.xs);
    ImGui::SetCursorScreenPos(min);
    ImGui::PushID(i);
    if (ImGui::InvisibleButton("anchor", {max.x - min.x, max.y - min.y}))
      size_.across = across, size_.down = down;
    tab_stop(look);
    ImGui::PopID();
    hint(look,
         {"Where the old world stays", "", "The cells that are added or cut off lie on the other sides."});
    const bool chosen = size_.across == across && size_.down == down;
    list.AddRectFilled(min, max,
                       chosen                   ? look.theme.accent
                       : ImGui::IsItemHovered() ? look.theme.hover
                                                : look.theme.raised,
                       look.px(4));
    list.AddRect(min, max, look.theme.faint, look.px(4), 0, look.px.hair);
  }
  ImGui::SetCursorScreenPos({origin.x, origin.y + step * 3 + look.px.s});
}

void WorldDialogs::resize_preview(const Look& look, const Session& session, ImVec2 size) const {
  const Scenario& scenario = session.scenario();
  const GridMap& map = scenario.map;
  const int dx = moved(size_.across, map.width, size_.width),
            dy = moved(size_.down, map.height, size_.height);
  // Both worlds are in the picture, with what is lost outside the new one.
  const int left = std::min(0, dx), top = std::min(0, dy);
  const int right = std::max(size_.width, dx + map.width), bottom = std::max(size_.height, dy + map.height);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const auto [min, max] = fitted(origin, size, right - left, bottom - top);
  const float scale = (max.x - min.x) / static_cast<float>(right - left);
  const auto at = [&, corner = min](int x, int y) {
    return ImVec2(corner.x + static_cast<float>(x - left) * scale,
                  corner.y + static_cast<float>(y - top) * scale);
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 a = at(0, 0), b = at(size_.width, size_.height);
  list.AddRectFilled(a, b, size_.blocked ? look.theme.obstacle : look.theme.free);
  sketch_.draw(look, list, at(dx, dy), at(dx + map.width, dy + map.height));
  // What falls off is veiled.
  const ImU32 veil = with_alpha(look.theme.panel, 0.75f);
  list.AddRectFilled(min, {max.x, a.y}, veil);
  list.AddRectFilled({min.x, b.y}, max, veil);
  list.AddRectFilled({min.x, a.y}, {a.x, b.y}, veil);
  list.AddRectFilled({b.x, a.y}, {max.x, b.y}, veil);
  const auto dot = [&](Cell cell, ImU32 colour) {
    list.AddCircleFilled(at(cell.x + dx, cell.y + dy), look.px(4), colour);
  };
  dot(scenario.start, look.theme.start);
  dot(scenario.goal, look.theme.goal);
  list.AddRect(a, b, look.theme.accent, 0, 0, look.px(1.5f));
  ImGui::Dummy(size);
}

void WorldDialogs::resize(const Look& look, const Session& session, std::vector<Command>& commands) {
  const Scenario& scenario = session.scenario();
  heading(look, "Resize the world");
  const float whole = ImGui::GetContentRegionAvail().x, left = whole * 0.45f,
              height = fitting_height(look, 270);
  ImGui::BeginChild("settings", {left, height});
  size_slider(look, "Width", scenario.map.width, size_.width);
  size_slider(look, "Height", scenario.map.height, size_.height);
  anchors(look);
  toggle(look, "New cells are obstacles", size_.blocked);
  hint(look, {"New cells", "", "On: what is added is solid. Off: it is free."});
  ImGui::EndChild();
  ImGui::SameLine(0, look.px(24));
  resize_preview(look, session, {whole - left - look.px(24), height});
  const int dx = moved(size_.across, scenario.map.width, size_.width),
            dy = moved(size_.down, scenario.map.height, size_.height);
  const auto lost = [&](Cell cell) {
    return cell.x + dx < 0 || cell.y + dy < 0 || cell.x + dx >= size_.width || cell.y + dy >= size_.height;
  };
  const bool ends = lost(scenario.start) || lost(scenario.goal);
  text(look.fonts.ui, ends ? look.theme.warning : look.theme.dim,
       std::to_string(scenario.map.width) + " × " + std::to_string(scenario.map.height) + " → " +
           std::to_string(size_.width) + " × " + std::to_string(size_.height) + " cells" +
           (ends ? "; start or goal move to the nearest cell inside" : ""));
  const Answer answer = confirm(look, "Resize");
  if (answer == Answer::yes) commands.emplace_back(ResizeWorld{size_});
  if (answer != Answer::none) kind_ = Kind::none;
}

bool WorldDialogs::generator_settings(const Look& look) {
  bool changed = false;
  std::vector<const char*> names;
  int current = 0;
  for (const GeneratorInfo& info : generators()) {
    if (info.id == wanted_.generator) current = static_cast<int>(names.size());
    names.push_back(info.name.data());  // literals, so they end with a zero
  }
  if (combo(look, "##generator", names, current, ImGui::GetContentRegionAvail().x)) {
    wanted_.generator = generators()[static_cast<std::size_t>(current)].id;
    wanted_.settings = {};
    changed = true;
  }
  hint(look, {"Generator", "", "What kind of world. Each has settings of its own below."});
  const GeneratorInfo& info = generators()[static_cast<std::size_t>(current)];
  paragraph(look.fonts.ui, look.theme.dim, info.summary);
  changed |= size_slider(look, "Width", 61, wanted_.width);
  changed |= size_slider(look, "Height", 41, wanted_.height);
  const double longest = std::max({wanted_.width, wanted_.height, 2});
  for (const Parameter& parameter : info.parameters)
    changed |= parameter_control(look, parameter, longest, wanted_.settings);
  return changed;
}

/// Begins one where the wishes have changed, and takes over what has come of it. A large one is not begun anew for
/// every pixel that a slider is dragged.
void WorldDialogs::make_preview() {
  const std::int64_t cells = std::int64_t{wanted_.width} * wanted_.height;
  if (stale_ && (cells <= kQuickCells || !ImGui::IsMouseDown(0))) {
    stale_ = false;
    preview_->start([wanted = wanted_](const std::stop_token&) {
      const Result<GridMap> map =
          replan::generate(wanted.generator, wanted.settings, wanted.width, wanted.height, wanted.seed);
      return Preview{map ? MapSketch(*map) : MapSketch(), map ? "" : map.error(), wanted.width,
                     wanted.height};
    });
  }
  auto made = preview_->take();
  if (!made) return;
  sketch_ = std::move(made->sketch);
  error_ = std::move(made->error);
  drawn_width_ = made->width;
  drawn_height_ = made->height;
}

void WorldDialogs::generate_preview(const Look& look, ImVec2 size) const {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const auto [min, max] = fitted(origin, size, wanted_.width, wanted_.height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // One of other sides would be drawn out of shape.
  if (drawn_width_ == wanted_.width && drawn_height_ == wanted_.height) {
    sketch_.draw(look, list, min, max);
  } else if (preview_->busy()) {
    const char* words = "Drawing…";
    draw_text(list, look.fonts.ui,
              {(min.x + max.x - text_width(look.fonts.ui, words)) * 0.5f,
               (min.y + max.y - look.fonts.ui->FontSize) * 0.5f},
              look.theme.dim, words);
  }
  list.AddRect(min, max, look.theme.line, 0, 0, look.px.hair);
  ImGui::Dummy(size);
}

void WorldDialogs::generate(const Look& look, std::vector<Command>& commands) {
  heading(look, "Generate a world");
  const float whole = ImGui::GetContentRegionAvail().x, left = whole * 0.45f,
              height = fitting_height(look, 360);
  ImGui::BeginChild("settings", {left, height});
  stale_ |= generator_settings(look);
  ImGui::EndChild();
  ImGui::SameLine(0, look.px(24));
  ImGui::BeginGroup();
  make_preview();
  generate_preview(look, {whole - left - look.px(24), height - look.px(44)});
  ImGui::Dummy({0, look.px.xs});
  ImGui::AlignTextToFramePadding();
  text(look.fonts.ui, look.theme.dim, "Seed");
  ImGui::SameLine(0, look.px.s);
  ImGui::SetNextItemWidth(look.px(110));
  auto seed = static_cast<std::uint64_t>(wanted_.seed);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px.s, look.px.xs));
  const bool typed = number_field(look, "##seed", ImGuiDataType_U64, &seed);
  ImGui::PopStyleVar();
  hint(look, term_hint("seed"));
  ImGui::SameLine(0, look.px.xs);
  const bool rolled = small_button(
      look, "dice",
      {.icon = icon::random, .hint = {"Another seed", "", "The same seed gives the same world."}});
  if (rolled) seed = 1 + Random(wanted_.seed).below(kSeeds);
  if (typed || rolled) wanted_.seed = seed, stale_ = true;
  ImGui::EndGroup();
  if (!error_.empty()) paragraph(look.fonts.ui, look.theme.bad, error_);
  const Answer answer = confirm(look, "Create");
  if (answer == Answer::yes && !error_.empty()) return;
  if (answer == Answer::yes) commands.emplace_back(wanted_);
  if (answer != Answer::none) kind_ = Kind::none;
}

}  // namespace replan::ui
