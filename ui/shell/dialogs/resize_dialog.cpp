// Another size of the world: how large, where the old one stays, and what comes of it.
#include <algorithm>
#include <string>
#include <utility>

#include "core/world/grid_map.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/dialogs/world_dialogs.hpp"
#include "ui/shell/dialogs/world_views.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// "40 × 30", and of a world of layers "40 × 30 × 8".
std::string sides_shown(const Box& box) {
  return std::to_string(box.width()) + " × " + std::to_string(box.height()) +
         (box.solid() ? " × " + std::to_string(box.depth()) : "");
}

/// A square of a choice of places; whether it was clicked.
bool place_button(const Look& look, const char* id, ImVec2 min, float side, bool chosen, const Hint& what) {
  const ImVec2 max(min.x + side, min.y + side);
  ImGui::SetCursorScreenPos(min);
  const bool clicked = ImGui::InvisibleButton(id, {side, side});
  tab_stop(look);
  hint(look, what);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max,
                     chosen                   ? look.theme.accent
                     : ImGui::IsItemHovered() ? look.theme.hover
                                              : look.theme.raised,
                     look.px(4));
  list.AddRect(min, max, look.theme.faint, look.px(4), 0, look.px.hair);
  return clicked;
}

}  // namespace

/// Nine places for the old world in the new one, and beside them three for its layers.
void WorldDialogs::anchors(const Look& look) {
  text(look.fonts.ui, look.theme.dim, "Where the old world stays");
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float step = look.px(28), side = step - look.px.xs;
  const Hint what{"Where the old world stays", "",
                  "The cells that are added or cut off lie on the other sides."};
  for (int i = 0; i < 9; ++i) {
    const auto across = static_cast<Side>(i % 3), down = static_cast<Side>(i / 3);
    ImGui::PushID(i);
    if (place_button(
            look, "anchor",
            {origin.x + static_cast<float>(i % 3) * step, origin.y + static_cast<float>(i / 3) * step}, side,
            size_.across == across && size_.down == down, what))
      size_.across = across, size_.down = down;
    ImGui::PopID();
  }
  constexpr const char* kWords[] = {"top", "middle", "bottom"};
  for (int i = 0; i < 3 && size_.depth != sketched_depth_; ++i) {
    const auto up = static_cast<Side>(2 - i);
    const ImVec2 min(origin.x + 4 * step, origin.y + static_cast<float>(i) * step);
    ImGui::PushID(9 + i);
    if (place_button(look, "layer", min, side, size_.up == up,
                     {"Where the old layers stay", "", "Layers are added or cut off at the other end."}))
      size_.up = up;
    ImGui::PopID();
    draw_text(*ImGui::GetWindowDrawList(), look.fonts.ui,
              {min.x + step + look.px.xs, min.y + (side - look.fonts.ui->FontSize) * 0.5f}, look.theme.dim,
              kWords[i]);
  }
  ImGui::SetCursorScreenPos({origin.x, origin.y + step * 3 + look.px.s});
}

/// Both worlds in one picture, with what is lost outside the new one.
void WorldDialogs::resize_view(const Look& look, const MapSketch& sketch, const ResizeView& view,
                               ImVec2 size) const {
  const int left = std::min(0, view.across), top = std::min(0, view.down);
  const int right = std::max(view.new_width, view.across + view.width),
            bottom = std::max(view.new_height, view.down + view.height);
  const auto [min, max] = fitted(ImGui::GetCursorScreenPos(), size, right - left, bottom - top);
  const float scale = (max.x - min.x) / static_cast<float>(right - left);
  const auto at = [&, corner = min](int x, int y) {
    return ImVec2(corner.x + static_cast<float>(x - left) * scale,
                  corner.y + static_cast<float>(y - top) * scale);
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 a = at(0, 0), b = at(view.new_width, view.new_height);
  list.AddRectFilled(a, b, size_.blocked ? look.theme.obstacle : look.theme.free);
  sketch.draw(look, list, at(view.across, view.down), at(view.across + view.width, view.down + view.height));
  // What falls off is veiled.
  const ImU32 veil = with_alpha(look.theme.panel, 0.75f);
  list.AddRectFilled(min, {max.x, a.y}, veil);
  list.AddRectFilled({min.x, b.y}, max, veil);
  list.AddRectFilled({min.x, a.y}, {a.x, b.y}, veil);
  list.AddRectFilled({b.x, a.y}, {max.x, b.y}, veil);
  const auto dot = [&](Cell cell, ImU32 colour) {
    list.AddCircleFilled(at(cell.x + view.across, cell.y + view.down), look.px(4), colour);
  };
  dot(view.start, look.theme.start);
  dot(view.goal, look.theme.goal);
  list.AddRect(a, b, look.theme.accent, 0, 0, look.px(1.5f));
  ImGui::Dummy(size);
}

/// The world from above, and one that has or gets several layers from the front too.
void WorldDialogs::resize_preview(const Look& look, const Session& session, ImVec2 size) const {
  const Scenario& scenario = session.scenario();
  const GridMap& map = scenario.map;
  const Cell by = shift_of(map.box(), size_);
  const ResizeView above{map.width, map.height, size_.width,    size_.height,
                         by.x,      by.y,       scenario.start, scenario.goal};
  if (std::max(map.depth, size_.depth) == 1) return resize_view(look, sketch_, above, size);
  // Seen from the front, layers count from the top.
  const auto in_front = [&](Cell cell) { return Cell{cell.x, map.depth - 1 - cell.z}; };
  const ResizeView front{map.width,
                         map.depth,
                         size_.width,
                         size_.depth,
                         by.x,
                         size_.depth - map.depth - by.z,
                         in_front(scenario.start),
                         in_front(scenario.goal)};
  ImGui::BeginGroup();
  two_views(
      look, size, [&](ImVec2 part) { resize_view(look, sketch_, above, part); },
      [&](ImVec2 part) { resize_view(look, front_, front, part); });
  ImGui::EndGroup();
}

void WorldDialogs::resize(const Look& look, const Session& session, std::vector<Command>& commands) {
  const Scenario& scenario = session.scenario();
  const GridMap& map = scenario.map;
  take_preview();
  heading(look, "Resize the world");
  settings_and_picture(
      look, 320,
      [&] {
        size_slider(look, "Width", map.width, size_.width);
        size_slider(look, "Height", map.height, size_.height);
        layers_slider(look, map.depth, size_.depth);
        anchors(look);
        toggle(look, "New cells are obstacles", size_.blocked);
        hint(look, {"New cells", "", "On: what is added is solid. Off: it is free."});
      },
      [&](ImVec2 size) { resize_preview(look, session, size); });
  const Box after(size_.width, size_.height, size_.depth);
  const Cell by = shift_of(map.box(), size_);
  const auto lost = [&](Cell cell) {
    return !after.contains(Cell{cell.x + by.x, cell.y + by.y, cell.z + by.z});
  };
  const bool ends = lost(scenario.start) || lost(scenario.goal);
  text(look.fonts.ui, ends ? look.theme.warning : look.theme.dim,
       sides_shown(map.box()) + " → " + sides_shown(after) + " cells" +
           (ends ? "; start or goal move to the nearest cell inside" : ""));
  const Result<void> fits = check_world_size(after);
  if (!fits) paragraph(look.fonts.ui, look.theme.bad, as_sentence(fits.error()));
  const Answer answer = confirm(look, "Resize");
  if (answer == Answer::yes && !fits) return;
  if (answer == Answer::yes) commands.emplace_back(ResizeWorld{size_});
  if (answer != Answer::none) kind_ = Kind::none;
}

}  // namespace replan::ui
