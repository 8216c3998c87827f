#include "ui/canvas/draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace replan::ui {
namespace {

/// Draws shapes one after the other.
class Painter {
 public:
  Painter(ImDrawList& list, const Look& look, const Scene& scene, ImVec2 min)
      : list_(list), look_(look), screen_(scene, min) {}

  void operator()(const Line& line) {
    ImVec2 a = screen_(line.from), b = screen_(line.to);
    // Straight lines one pixel wide fill whole pixels, as the cells do.
    if (a.x == b.x || a.y == b.y) {
      const float w = std::max(1.0f, std::round(line.width));
      const ImVec2 from(std::round(std::min(a.x, b.x)), std::round(std::min(a.y, b.y)));
      const ImVec2 to(a.x == b.x ? from.x + w : std::max(a.x, b.x),
                      a.y == b.y ? from.y + w : std::max(a.y, b.y));
      list_.AddRectFilled(from, to, line.colour);
      return;
    }
    list_.AddLine(a, b, line.colour, line.width);
  }

  void operator()(const Arrow& arrow) {
    const ImVec2 tail = screen_(arrow.from), tip = screen_(arrow.to);
    const float dx = tip.x - tail.x, dy = tip.y - tail.y, length = std::sqrt(dx * dx + dy * dy);
    if (length <= 0) return;
    const float ux = dx / length * arrow.head, uy = dy / length * arrow.head;
    list_.AddLine(tail, tip, arrow.colour, arrow.width);
    if (arrow.head <= 0) return;
    const std::array<ImVec2, 3> head = {{{tip.x - ux - uy * 0.8f, tip.y - uy + ux * 0.8f},
                                         tip,
                                         {tip.x - ux + uy * 0.8f, tip.y - uy - ux * 0.8f}}};
    list_.AddPolyline(head.data(), 3, arrow.colour, ImDrawFlags_None, arrow.width);
  }

  void operator()(const Outline& mark) {
    const ImVec2 lower = screen_({mark.x, mark.y}),
                 upper = screen_({mark.x + mark.width, mark.y + mark.height});
    const ImVec2 a(lower.x + mark.inset, lower.y + mark.inset), b(upper.x - mark.inset, upper.y - mark.inset);
    const float x = (a.x + b.x) / 2, y = (a.y + b.y) / 2;
    switch (mark.shape) {
      case OutlineShape::filled:
        list_.AddRectFilled(lower, upper, mark.colour);
        break;
      case OutlineShape::square:
        frame(a, b, mark.colour, mark.stroke);
        break;
      case OutlineShape::corners:
        corners(a, b, mark.colour, mark.stroke);
        break;
      case OutlineShape::diamond:
        list_.AddQuad({x, a.y}, {b.x, y}, {x, b.y}, {a.x, y}, mark.colour, mark.stroke);
        break;
      case OutlineShape::up:
        list_.AddTriangle({a.x, b.y}, {x, a.y}, b, mark.colour, mark.stroke);
        break;
      case OutlineShape::down:
        list_.AddTriangle(a, {b.x, a.y}, {x, b.y}, mark.colour, mark.stroke);
        break;
    }
  }

  void operator()(const Polyline& line) {
    points_.clear();
    for (const Point& point : line.points) {
      const ImVec2 at = screen_(point);
      // Points closer than a pixel add cost and ragged joints, nothing else.
      const bool last = &point == &line.points.back();
      if (!last && !points_.empty() &&
          std::abs(at.x - points_.back().x) + std::abs(at.y - points_.back().y) < 1)
        continue;
      points_.push_back(at);
    }
    const auto stroke = [&](Colour colour, float width) { stretches(colour, width); };
    if (line.dash > 0) {
      dashes(line);
      return;
    }
    if (line.casing >> 24 != 0) stroke(line.casing, line.width + look_.px(2));
    stroke(line.colour, line.width);
  }

  void operator()(const Ring& ring) {
    const ImVec2 centre = screen_(ring.centre);
    const auto radius = static_cast<float>(ring.radius * screen_.camera.zoom);
    if (radius < 1) return;
    if (ring.dash <= 0) {
      list_.AddCircle(centre, radius, ring.colour, 0, ring.width);
      return;
    }
    const float around = 2 * std::numbers::pi_v<float>;
    const int dashes = std::min(std::max(8, static_cast<int>(around * radius / (2 * ring.dash))), 2000);
    for (int i = 0; i < dashes; ++i) {
      const float from = around * static_cast<float>(i) / static_cast<float>(dashes);
      list_.PathArcTo(centre, radius, from, from + around / static_cast<float>(dashes) / 2, 3);
      list_.PathStroke(ring.colour, ImDrawFlags_None, ring.width);
    }
  }

  void operator()(const Disc& disc) {
    const ImVec2 at = screen_(disc.centre);
    if (disc.rim_width > 0) list_.AddCircleFilled(at, disc.radius + disc.rim_width / 2, disc.rim);
    list_.AddCircleFilled(at, disc.radius - disc.rim_width / 2, disc.fill);
    glyph(disc, at);
  }

  void operator()(const Label& label) {
    ImFont* font = label.large ? look_.fonts.mono : look_.fonts.mono_small;
    const char* begin = label.text.data();
    const char* end = begin + label.text.size();
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, begin, end);
    ImVec2 at = screen_(label.at);
    // The line's upper and lower bearings are no part of the digits.
    const float bearing = size.y * 0.16f;
    const bool right = label.anchor == Anchor::upper_right || label.anchor == Anchor::lower_right;
    const bool low = label.anchor == Anchor::lower_left || label.anchor == Anchor::lower_right;
    if (label.anchor == Anchor::middle)
      at = {at.x - size.x / 2, at.y - size.y / 2};
    else
      at = {right ? at.x - size.x : at.x, low ? at.y - size.y + bearing : at.y - bearing};
    at = {std::round(at.x), std::round(at.y)};
    if (label.ground >> IM_COL32_A_SHIFT != 0) {
      const float rim = look_.px.hair;
      list_.AddRectFilled({at.x - rim, at.y + bearing - rim},
                          {at.x + size.x + rim, at.y + size.y - bearing + rim}, label.ground);
    }
    list_.AddText(font, font->FontSize, at, label.colour, begin, end);
  }

 private:
  /// points_ as a line, broken where it turns back sharply: there a mitre would be a spike.
  void stretches(Colour colour, float width) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const bool ends = i + 1 == points_.size();
      if (!ends && !turns_back(points_[i - 1], points_[i], points_[i + 1])) continue;
      list_.AddPolyline(points_.data() + first, static_cast<int>(i - first + 1), colour, ImDrawFlags_None,
                        width);
      if (!ends) list_.AddCircleFilled(points_[i], width / 2, colour);
      first = i;
    }
  }
  /// Whether the way over b turns by more than a right angle.
  static bool turns_back(ImVec2 a, ImVec2 b, ImVec2 c) {
    return (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < -1e-3f;
  }

  /// points_ as dashes; where they would be too many to be told apart, as a line.
  void dashes(const Polyline& line) {
    double on = 0;  // how far into a dash and its gap
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const ImVec2 a = points_[i - 1], b = points_[i];
      const float dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
      if (length > line.dash * 2000) {
        list_.AddLine(a, b, line.colour, line.width);
        continue;
      }
      for (float at = 0; at < length;) {
        const auto rest = static_cast<float>(line.dash - std::fmod(on, static_cast<double>(line.dash)));
        const float end = std::min(length, at + std::max(rest, 0.1f));
        const bool drawn =
            std::fmod(on, 2.0 * static_cast<double>(line.dash)) < static_cast<double>(line.dash);
        if (drawn)
          list_.AddLine({a.x + dx * at / length, a.y + dy * at / length},
                        {a.x + dx * end / length, a.y + dy * end / length}, line.colour, line.width);
        on += static_cast<double>(end - at);
        at = end;
      }
    }
  }

  /// A square frame of whole pixels.
  void frame(ImVec2 a, ImVec2 b, ImU32 colour, float stroke) {
    const float w = std::max(1.0f, std::round(stroke));
    a = {std::round(a.x), std::round(a.y)};
    b = {std::round(b.x), std::round(b.y)};
    list_.AddRectFilled(a, {b.x, a.y + w}, colour);
    list_.AddRectFilled({a.x, b.y - w}, b, colour);
    list_.AddRectFilled({a.x, a.y + w}, {a.x + w, b.y - w}, colour);
    list_.AddRectFilled({b.x - w, a.y + w}, {b.x, b.y - w}, colour);
  }

  void corners(ImVec2 a, ImVec2 b, ImU32 colour, float stroke) {
    const float w = std::max(1.0f, std::round(stroke)),
                arm = std::clamp((b.x - a.x) * 0.35f, 2.0f, look_.px(7));
    list_.AddRectFilled(a, {a.x + arm, a.y + w}, colour);
    list_.AddRectFilled({a.x, a.y + w}, {a.x + w, a.y + arm}, colour);
    list_.AddRectFilled({b.x - arm, b.y - w}, b, colour);
    list_.AddRectFilled({b.x - w, b.y - arm}, {b.x, b.y - w}, colour);
  }

  void glyph(const Disc& disc, ImVec2 at) {
    const float r = disc.radius;
    switch (disc.glyph) {
      case Glyph::none:
        break;
      case Glyph::dot:
        list_.AddCircleFilled(at, r * 0.3f, disc.rim);
        break;
      case Glyph::target:
        list_.AddCircle(at, r * 0.42f, disc.rim, 0, r * 0.2f);
        break;
      case Glyph::heading: {
        const auto c = static_cast<float>(std::cos(disc.angle)) * r,
                   s = static_cast<float>(std::sin(disc.angle)) * r;
        // A dart: its notch tells the tip from the other corners.
        const ImVec2 tip(at.x + c * 0.75f, at.y + s * 0.75f), notch(at.x - c * 0.2f, at.y - s * 0.2f);
        list_.AddTriangleFilled(tip, {at.x - c * 0.55f - s * 0.5f, at.y - s * 0.55f + c * 0.5f}, notch,
                                disc.rim);
        list_.AddTriangleFilled(tip, notch, {at.x - c * 0.55f + s * 0.5f, at.y - s * 0.55f - c * 0.5f},
                                disc.rim);
        break;
      }
    }
  }

  ImDrawList& list_;
  const Look& look_;
  Projection screen_;
  std::vector<ImVec2> points_;
};

}  // namespace

Palette scene_palette(const Theme& theme, FieldColours colours) {
  Palette palette;
  palette.background = theme.background;
  palette.surround = theme.surround;
  palette.free = theme.free;
  palette.obstacle = theme.obstacle;
  palette.surprise = theme.surprise;
  palette.mover = theme.mover;
  palette.grid = theme.grid;
  palette.arrow = theme.arrow;
  palette.path = theme.path;
  palette.accent = theme.accent;
  palette.start = theme.start;
  palette.goal = theme.goal;
  palette.robot = theme.robot;
  palette.warning = theme.warning;
  palette.bad = theme.bad;
  palette.good = theme.good;
  palette.text = theme.text;
  palette.dim = theme.dim;
  palette.outline = theme.outline;
  palette.rhs = theme.rhs;
  palette.unseen = theme.unseen;
  palette.field = field_colours(theme, colours);
  palette.field_opacity = theme.field_opacity;
  return palette;
}

void draw_scene(ImDrawList& list, const Look& look, const Scene& scene, ImVec2 min,
                const RasterTexture& raster) {
  const Projection screen(scene, min);
  if (raster.id != nullptr && scene.raster.columns > 0) {
    const Raster& cells = scene.raster;
    list.AddImage(raster.id, screen({cells.x, cells.y}),
                  screen({cells.x + cells.width, cells.y + cells.height}), {0, 0}, raster.used);
  }
  Painter painter(list, look, scene, min);
  for (const Shape& shape : scene.shapes) std::visit(painter, shape);
}

}  // namespace replan::ui
