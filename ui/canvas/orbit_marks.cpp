#include "ui/canvas/orbit_marks.hpp"

#include <array>
#include <cmath>
#include <string>

#include "ui/canvas/cell_words.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

ImVec2 on_screen(const PaneArea& area, const OrbitLens::Pixel& pixel) {
  return {area.min.x + static_cast<float>(pixel.x), area.min.y + static_cast<float>(pixel.y)};
}

/// Whether an obstacle within the world stands before a place; those at its border show no face to the outside.
bool is_hidden(const Run& run, const SolidScene& scene, const Point& at, const Point& eye) {
  const SearchState& state = run.timeline().state();
  const Box& world = run.lattice();
  const Cell own = cell_of(at);
  const EyeRay back{at, {eye.x - at.x, eye.y - at.y, eye.z - at.z}};
  return first_on_ray(world, back,
                      [&](Cell cell, Cell) {
                        const bool shown = !scene.cut || scene.cut->shows(centre_of(cell));
                        const bool inner = cell.x > 0 && cell.y > 0 && cell.z > 0 &&
                                           cell.x + 1 < world.width() && cell.y + 1 < world.height() &&
                                           cell.z + 1 < world.depth();
                        return cell != own && shown && inner && state.truly_blocked(world.node(cell));
                      })
      .has_value();
}

struct CompassAxis {
  ImVec2 end, middle;  // of its line, and of its name
};

/// Where the compass stands, and where its axes lead.
struct Compass {
  ImVec2 at;
  std::array<CompassAxis, 3> axes;
};

Compass compass_of(const Look& look, const OrbitLens& lens, const PaneArea& area) {
  Compass compass;
  compass.at = {area.min.x + look.px(44),
                area.min.y + static_cast<float>(area.view.height - area.view.below) - look.px(44)};
  const OrbitLens small(Orbit{lens.orbit().yaw, lens.orbit().pitch, 8, {}}, Box(1, 1, 1), {100, 100});
  const auto origin = small.pixel({});
  const std::array<Point, 3> tips = {Point{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto tip = small.pixel(tips[i]);
    if (!tip || !origin) continue;
    const float scale = look.px(26) / 20.0f;
    const ImVec2 way(static_cast<float>(tip->x - origin->x) * scale,
                     static_cast<float>(tip->y - origin->y) * scale);
    compass.axes[i] = {{compass.at.x + way.x, compass.at.y + way.y},
                       {compass.at.x + way.x * 1.3f, compass.at.y + way.y * 1.3f}};
  }
  return compass;
}

bool within(ImVec2 a, ImVec2 b, float reach) {
  return std::hypot(a.x - b.x, a.y - b.y) < reach;
}

}  // namespace

void draw_solid_marks(const Look& look, const Run& run, const SolidScene& scene, const OrbitLens& lens,
                      const PaneArea& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const SolidMark& mark : scene.marks) {
    const auto pixel = lens.pixel(mark.at);
    if (!pixel) continue;
    const bool hidden = scene.opacity >= 1 && is_hidden(run, scene, mark.at, lens.eye());
    const float strength = hidden ? 0.45f : 1;
    const ImVec2 at = on_screen(area, *pixel);
    const ImU32 fill = with_alpha(mark.fill, strength), rim = with_alpha(look.theme.outline, strength);
    const float radius = look.px(9);
    if (mark.shape == SolidMark::Shape::star) {
      draw_star(list, at, radius * 1.2f, 5, 0.45f, fill, rim, look.px(1.5f));
    } else if (mark.shape == SolidMark::Shape::diamond) {
      draw_star(list, at, radius * 1.2f, 4, 0.72f, fill, rim, look.px(1.5f));
    } else {
      list.AddCircleFilled(at, radius * 0.8f, fill);
      list.AddCircle(at, radius * 0.8f, rim, 0, look.px(2));
    }
  }
}

void draw_pointed_cell(const Look& look, const Run& run, Cell cell, const OrbitLens& lens,
                       const PaneArea& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::array<std::optional<OrbitLens::Pixel>, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners[i] = lens.pixel({cell.x + static_cast<double>(i & 1u), cell.y + static_cast<double>(i >> 1 & 1u),
                             cell.z + static_cast<double>(i >> 2 & 1u)});
  for (unsigned from = 0; from < 8; ++from)
    for (unsigned bit = 1; bit < 8; bit <<= 1)
      if ((from & bit) == 0 && corners[from] && corners[from | bit])
        list.AddLine(on_screen(area, *corners[from]), on_screen(area, *corners[from | bit]),
                     with_alpha(look.theme.text, 0.6f), look.px(1.2f));
  const std::string place = "(" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ", " +
                            std::to_string(cell.z) + ")",
                    what = cell_words(run, cell);
  const std::array<TextRun, 2> words = {
      {{place, look.theme.text, look.fonts.mono}, {what, look.theme.dim, look.fonts.small}}};
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  // On the side of the mouse where there is more room.
  const bool left = mouse.x > area.min.x + static_cast<float>(area.view.width) / 2;
  chip(look, list, {mouse.x + look.px(left ? -14 : 14), mouse.y + look.px(left ? -6 : 16)}, words,
       left ? Corner::bottom_right : Corner::top_left);
}

void draw_compass(const Look& look, const OrbitLens& lens, const PaneArea& area, ImVec2 mouse) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Compass compass = compass_of(look, lens, area);
  list.AddCircleFilled(compass.at, look.px(41), with_alpha(look.theme.surround, 0.75f));
  const auto under = compass_part(look, lens, area, mouse);
  constexpr std::array<const char*, 3> kNames = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool lit = under == static_cast<CompassPart>(i);
    const CompassAxis& axis = compass.axes[i];
    list.AddLine(compass.at, axis.end, lit ? look.theme.accent : look.theme.dim, look.px(1.5f));
    const ImVec2 half(look.px(8), look.px(8));
    draw_text_centred(list, look.fonts.small, {axis.middle.x - half.x, axis.middle.y - half.y},
                      {axis.middle.x + half.x, axis.middle.y + half.y},
                      lit ? look.theme.accent : look.theme.text, kNames[i]);
  }
  if (under == CompassPart::middle)
    list.AddCircle(compass.at, look.px(5), look.theme.accent, 0, look.px(1.5f));
}

std::optional<CompassPart> compass_part(const Look& look, const OrbitLens& lens, const PaneArea& area,
                                        ImVec2 mouse) {
  const Compass compass = compass_of(look, lens, area);
  for (std::size_t i = 0; i < 3; ++i)
    if (within(mouse, compass.axes[i].middle, look.px(9)) && !within(mouse, compass.at, look.px(9)))
      return static_cast<CompassPart>(i);
  return within(mouse, compass.at, look.px(9)) ? std::optional(CompassPart::middle) : std::nullopt;
}

}  // namespace replan::ui
