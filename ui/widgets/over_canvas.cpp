// Chips that float over the canvas (see widgets.hpp).
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr int kGradientSteps = 24;

ImVec2 top_left(ImVec2 pos, ImVec2 size, Corner corner) {
  const bool right = corner == Corner::top_right || corner == Corner::bottom_right;
  const bool bottom = corner == Corner::bottom_left || corner == Corner::bottom_right;
  return {std::floor(right ? pos.x - size.x : pos.x), std::floor(bottom ? pos.y - size.y : pos.y)};
}

void draw_ground(const Look& look, ImDrawList& list, ImVec2 min, ImVec2 size) {
  const ImVec2 max(min.x + size.x, min.y + size.y);
  list.AddRectFilled(min, max, with_alpha(look.theme.panel, kChipOpacity), look.px.radius_l);
  list.AddRect(min, max, look.theme.line, look.px.radius_l, 0, look.px.hair);
}

/// Where a font's base line lies below the top of its line.
float baseline(const ImFont* font) {
  return std::round(font->Ascent);
}

void draw_gradient(ImDrawList& list, ImVec2 min, ImVec2 max, const Colormap& map) {
  const float radius = (max.y - min.y) * 0.5f;
  const ImU32 first = map.front();
  const ImU32 last = map.back();
  list.AddRectFilled(min, {min.x + radius * 2, max.y}, first, radius, ImDrawFlags_RoundCornersLeft);
  list.AddRectFilled({max.x - radius * 2, min.y}, max, last, radius, ImDrawFlags_RoundCornersRight);
  const float left = min.x + radius;
  const float step = (max.x - radius - left) / kGradientSteps;
  for (int i = 0; i < kGradientSteps; ++i) {
    const ImU32 a = sample(map, static_cast<float>(i) / kGradientSteps);
    const ImU32 b = sample(map, static_cast<float>(i + 1) / kGradientSteps);
    const float x = left + step * static_cast<float>(i);
    list.AddRectFilledMultiColor({x, min.y}, {x + step, max.y}, a, b, b, a);
  }
}

void draw_arrow(const Look& look, ImDrawList& list, ImVec2 tail, float length, ImU32 colour,
                float thickness) {
  const float head = look.px(3);
  const ImVec2 tip(tail.x + length, tail.y);
  list.AddLine(tail, tip, colour, thickness);
  list.AddLine({tip.x - head, tip.y - head}, tip, colour, thickness);
  list.AddLine({tip.x - head, tip.y + head}, tip, colour, thickness);
}

/// A mark of 12 x 10 with its left edge at x, its middle at y.
void draw_mark(const Look& look, ImDrawList& list, float x, float y, const LegendEntry& entry) {
  const float size = look.px(9);
  const float half = size * 0.5f;
  const float stroke = look.px.hair * 1.3f;
  switch (entry.shape) {
    case LegendShape::dot:
      list.AddCircleFilled({x + half, y}, half, entry.colour);
      break;
    case LegendShape::star:
      draw_star(list, {x + half, y}, half * 1.25f, 5, 0.45f, entry.colour, entry.colour, look.px.hair);
      break;
    case LegendShape::diamond:
      draw_star(list, {x + half, y}, half * 1.25f, 4, 0.72f, entry.colour, entry.colour, look.px.hair);
      break;
    case LegendShape::ring:
      list.AddCircle({x + half, y}, half - stroke * 0.5f, entry.colour, 0, stroke * 1.6f);
      break;
    case LegendShape::tile:
      list.AddRectFilled({x, y - half}, {x + size, y + half}, entry.colour);
      list.AddRect({x, y - half}, {x + size, y + half}, look.theme.faint, 0, 0, look.px.hair);
      break;
    case LegendShape::two_values:
      list.AddRectFilled({x, y - half}, {x + size, y - look.px.hair}, look.theme.text);
      list.AddRectFilled({x, y + look.px.hair}, {x + size, y + half}, entry.colour);
      break;
    case LegendShape::square:
      list.AddRectFilled({x, y - half}, {x + size, y + half}, entry.colour);
      break;
    case LegendShape::outline:
      list.AddRect({x, y - half}, {x + size, y + half}, entry.colour, 0, 0, stroke);
      break;
    case LegendShape::corners:
      list.AddLine({x, y - half}, {x + half * 0.8f, y - half}, entry.colour, stroke);
      list.AddLine({x, y - half}, {x, y - half + half * 0.8f}, entry.colour, stroke);
      list.AddLine({x + size, y + half}, {x + size - half * 0.8f, y + half}, entry.colour, stroke);
      list.AddLine({x + size, y + half}, {x + size, y + half - half * 0.8f}, entry.colour, stroke);
      break;
    case LegendShape::up:
      list.AddTriangle({x, y + half}, {x + half, y - half}, {x + size, y + half}, entry.colour, stroke);
      break;
    case LegendShape::down:
      list.AddTriangle({x, y - half}, {x + half, y + half}, {x + size, y - half}, entry.colour, stroke);
      break;
    case LegendShape::line:
      list.AddLine({x, y}, {x + look.px.m, y}, entry.colour, look.px(3));
      break;
    case LegendShape::dashed:
      for (float dash = 0; dash < look.px.m; dash += look.px(5)) {
        list.AddLine({x + dash, y}, {x + dash + look.px(3), y}, entry.colour, stroke);
      }
      break;
    case LegendShape::cross:
      list.AddLine({x, y - half}, {x + size, y + half}, entry.colour, stroke * 1.4f);
      list.AddLine({x, y + half}, {x + size, y - half}, entry.colour, stroke * 1.4f);
      break;
    case LegendShape::bent: {
      const float third = look.px(13) / 3;
      const std::array<ImVec2, 4> way = {ImVec2(x, y + half), ImVec2(x + third, y - half * 0.5f),
                                         ImVec2(x + 2 * third, y + half * 0.5f),
                                         ImVec2(x + 3 * third, y - half)};
      list.AddPolyline(way.data(), static_cast<int>(way.size()), entry.colour, 0, stroke * 1.6f);
      break;
    }
    case LegendShape::arrow:
      draw_arrow(look, list, {x, y}, size, entry.colour, stroke);
      break;
    case LegendShape::long_arrow:
      draw_arrow(look, list, {x, y}, look.px(13), entry.colour, stroke * 1.4f);
      break;
  }
}

float shape_room(const Look& look, LegendShape shape) {
  return look.px(5) + (shape == LegendShape::long_arrow || shape == LegendShape::line ||
                               shape == LegendShape::dashed || shape == LegendShape::bent
                           ? look.px(13)
                           : look.px(9));
}

/// A pen that moves to the right along the middle of a chip; without a list it only measures.
struct Pen {
  const Look& look;
  ImDrawList* list;
  float x;
  float top;  // of a line of UI text

  void write(const ImFont* font, ImU32 colour, std::string_view text) {
    // On the base line of the UI face, whatever the size.
    const float y = top + baseline(look.fonts.ui) - baseline(font);
    if (list != nullptr) draw_text(*list, font, {x, y}, colour, text);
    x += std::ceil(text_width(font, text));
  }
  void mark(const LegendEntry& entry) {
    if (list != nullptr) draw_mark(look, *list, x, top + look.px(9), entry);
    x += shape_room(look, entry.shape);
    // The colours of grounds cannot be read as words.
    const bool ground = entry.shape == LegendShape::tile || entry.shape == LegendShape::square;
    const std::size_t slash = entry.label.rfind('/');
    if (entry.shape == LegendShape::two_values && slash != std::string_view::npos) {
      write(look.fonts.ui, look.theme.text, entry.label.substr(0, slash + 1));
      write(look.fonts.ui, entry.colour, entry.label.substr(slash + 1));
      return;
    }
    write(look.fonts.ui, ground ? look.theme.dim : entry.colour, entry.label);
  }
  void gradient(const LegendField& field) {
    const float width = look.px(field.length);
    if (list != nullptr) {
      draw_gradient(*list, {x, top + look.px(5)}, {x + width, top + look.px(12)}, *field.map);
      if (field.mark >= 0) mark_value(x + width * std::min(field.mark, 1.0f));
    }
    x += width;
  }
  /// A pointer from above, with a line through the gradient.
  void mark_value(float at) const {
    const float half = look.px(4), tip = top + look.px(5);
    list->AddTriangleFilled({at - half, tip - half}, {at + half, tip - half}, {at, tip}, look.theme.text);
    list->AddLine({at, tip}, {at, top + look.px(12)}, look.theme.text, look.px.hair);
  }
};

void write_legend(Pen& pen, const LegendField& field, std::span<const LegendEntry> entries,
                  std::vector<ScreenArea>* boxes = nullptr) {
  const Look& look = pen.look;
  const auto box = [&](float from) {
    const float half = look.px.xs, top = pen.top - look.px.xs;
    if (boxes != nullptr)
      boxes->push_back({{from - half, top}, {pen.x + half, top + look.px.l + 2 * look.px.xs}});
  };
  if (field.map != nullptr) {
    const float from = pen.x;
    pen.write(look.fonts.ui, look.theme.dim, field.label);
    pen.x += look.px(14);
    pen.gradient(field);
    pen.x += look.px(14);
    pen.write(look.fonts.mono, look.theme.dim, field.min);
    pen.write(look.fonts.mono, look.theme.faint, " … ");
    pen.write(look.fonts.mono, look.theme.dim, field.max);
    box(from);
  }
  for (const LegendEntry& entry : entries) {
    if (field.map != nullptr || &entry != entries.data()) pen.x += look.px(18);
    const float from = pen.x;
    pen.mark(entry);
    box(from);
  }
}

}  // namespace

ImVec2 chip(const Look& look, ImDrawList& list, ImVec2 pos, std::span<const TextRun> runs, Corner corner) {
  const auto write = [&](Pen& pen) {
    for (const TextRun& run : runs) {
      if (&run != runs.data()) pen.x += look.px.m;
      pen.write(run.font, run.colour, run.text);
    }
  };
  Pen measure{look, nullptr, 0, 0};
  write(measure);
  const ImVec2 size(measure.x + look.px(10) * 2, look.px(29));
  const ImVec2 min = top_left(pos, size, corner);
  draw_ground(look, list, min, size);
  Pen pen{look, &list, min.x + look.px(10), min.y + look.px(6)};
  write(pen);
  return size;
}

ImVec2 chip_message(const Look& look, ImDrawList& list, ImVec2 pos, const TextRun& run, float room) {
  const ImFont& font = *run.font;
  const float across = look.px(10), down = look.px(6);
  const char *begin = run.text.data(), *end = begin + run.text.size();
  const float wrap = std::max(look.px(80), room - 2 * across);
  const ImVec2 text = font.CalcTextSizeA(font.FontSize, FLT_MAX, wrap, begin, end);
  const ImVec2 size(text.x + 2 * across, std::max(look.px(29), text.y + 2 * down));
  draw_ground(look, list, pos, size);
  list.AddText(&font, font.FontSize, {pos.x + across, pos.y + down}, run.colour, begin, end, wrap);
  return size;
}

ImVec2 legend_size(const Look& look, const LegendField& field, std::span<const LegendEntry> entries) {
  Pen measure{look, nullptr, 0, 0};
  write_legend(measure, field, entries);
  return {measure.x + look.px(10) * 2, look.px(32)};
}

ImVec2 legend(const Look& look, ImDrawList& list, ImVec2 pos, const LegendField& field,
              std::span<const LegendEntry> entries, Corner corner, std::vector<ScreenArea>* boxes) {
  const ImVec2 size = legend_size(look, field, entries);
  const ImVec2 min = top_left(pos, size, corner);
  draw_ground(look, list, min, size);
  Pen pen{look, &list, min.x + look.px(10), min.y + look.px(8)};
  write_legend(pen, field, entries, boxes);
  return size;
}

void draw_star(ImDrawList& list, ImVec2 at, float radius, int tips, float inner, ImU32 fill, ImU32 rim,
               float width) {
  std::array<ImVec2, 16> points{};
  const int count = std::min(tips * 2, 16);
  for (int i = 0; i < count; ++i) {
    const float angle = static_cast<float>(i) * 3.14159265f / static_cast<float>(tips) - 1.57079633f;
    const float reach = i % 2 == 0 ? radius : radius * inner;
    points[static_cast<std::size_t>(i)] = {at.x + reach * std::cos(angle), at.y + reach * std::sin(angle)};
  }
  // Not convex: from the middle out.
  for (int i = 0; i < count; ++i)
    list.AddTriangleFilled(at, points[static_cast<std::size_t>(i)],
                           points[static_cast<std::size_t>((i + 1) % count)], fill);
  list.AddPolyline(points.data(), count, rim, ImDrawFlags_Closed, width);
}

}  // namespace replan::ui
