#include "core/scene/svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace replan {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string out = text;
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

/// ` name="#rrggbb"`, with the opacity beside it if it is not 1.
std::string paint(const char* name, Colour colour) {
  char text[64];
  std::snprintf(text, sizeof text, " %s=\"#%02x%02x%02x\"", name, colour & 255u, colour >> 8 & 255u,
                colour >> 16 & 255u);
  std::string out = text;
  if (const unsigned alpha = colour >> 24; alpha < 255)
    out += std::string(" ") + name + "-opacity=\"" + number(alpha / 255.0) + "\"";
  return out;
}

class Writer {
 public:
  explicit Writer(const Scene& scene) : scene_(scene) {}

  void operator()(const Line& line) {
    out_ += "<line" + attribute("x1", x(line.from)) + attribute("y1", y(line.from)) +
            attribute("x2", x(line.to)) + attribute("y2", y(line.to)) + stroke(line.colour, line.width) +
            "/>\n";
  }
  void operator()(const Arrow& arrow) {
    const double dx = x(arrow.to) - x(arrow.from), dy = y(arrow.to) - y(arrow.from),
                 length = std::hypot(dx, dy);
    if (length <= 0) return;
    const double ux = dx / length * arrow.head, uy = dy / length * arrow.head;
    const double tx = x(arrow.to), ty = y(arrow.to);
    if (arrow.head <= 0) {
      (*this)(Line{arrow.from, arrow.to, arrow.colour, arrow.width});
      return;
    }
    out_ += "<path d=\"M" + pair(x(arrow.from), y(arrow.from)) + "L" + pair(tx, ty) + "M" +
            pair(tx - ux - uy * 0.8, ty - uy + ux * 0.8) + "L" + pair(tx, ty) + "L" +
            pair(tx - ux + uy * 0.8, ty - uy - ux * 0.8) + "\"" + stroke(arrow.colour, arrow.width) +
            " fill=\"none\"/>\n";
  }
  void operator()(const Outline& mark) {
    const double x0 = x({mark.x, mark.y}) + mark.inset, y0 = y({mark.x, mark.y}) + mark.inset;
    const double x1 = x({mark.x + mark.width, 0}) - mark.inset,
                 y1 = y({0, mark.y + mark.height}) - mark.inset;
    const double xm = (x0 + x1) / 2, ym = (y0 + y1) / 2, arm = std::min((x1 - x0) * 0.35, 7 * scene_.scale);
    switch (mark.shape) {
      case OutlineShape::filled:
        rectangle(x0, y0, x1 - x0, y1 - y0, paint("fill", mark.colour));
        return;
      case OutlineShape::square:
        rectangle(x0, y0, x1 - x0, y1 - y0, " fill=\"none\"" + stroke(mark.colour, mark.stroke));
        return;
      case OutlineShape::corners:
        figure("M" + pair(x0, y0 + arm) + "L" + pair(x0, y0) + "L" + pair(x0 + arm, y0) + "M" +
                   pair(x1 - arm, y1) + "L" + pair(x1, y1) + "L" + pair(x1, y1 - arm),
               mark);
        return;
      case OutlineShape::diamond:
        figure("M" + pair(xm, y0) + "L" + pair(x1, ym) + "L" + pair(xm, y1) + "L" + pair(x0, ym) + "Z", mark);
        return;
      case OutlineShape::up:
        figure("M" + pair(x0, y1) + "L" + pair(xm, y0) + "L" + pair(x1, y1) + "Z", mark);
        return;
      case OutlineShape::down:
        figure("M" + pair(x0, y0) + "L" + pair(x1, y0) + "L" + pair(xm, y1) + "Z", mark);
        return;
    }
  }
  void operator()(const Polyline& line) {
    std::string points;
    for (const Point& point : line.points) points += (points.empty() ? "" : " ") + pair(x(point), y(point));
    out_ += "<polyline points=\"" + points + "\" fill=\"none\" stroke-linejoin=\"round\"" +
            stroke(line.colour, line.width) +
            (line.dash > 0 ? attribute("stroke-dasharray", line.dash) : "") + "/>\n";
  }
  void operator()(const Ring& ring) {
    out_ += "<circle" + attribute("cx", x(ring.centre)) + attribute("cy", y(ring.centre)) +
            attribute("r", ring.radius * scene_.camera.zoom) + " fill=\"none\"" +
            stroke(ring.colour, ring.width) +
            (ring.dash > 0 ? attribute("stroke-dasharray", ring.dash) : "") + "/>\n";
  }
  void operator()(const Disc& disc) {
    const double cx = x(disc.centre), cy = y(disc.centre), r = disc.radius;
    circle(cx, cy, r,
           paint("fill", disc.fill) + (disc.rim_width > 0 ? stroke(disc.rim, disc.rim_width) : ""));
    if (disc.glyph == Glyph::dot) circle(cx, cy, r * 0.3, paint("fill", disc.rim));
    if (disc.glyph == Glyph::target) circle(cx, cy, r * 0.42, " fill=\"none\"" + stroke(disc.rim, r * 0.2));
    if (disc.glyph != Glyph::heading) return;
    const double c = std::cos(disc.angle) * r, s = std::sin(disc.angle) * r;
    out_ += "<path d=\"M" + pair(cx + c * 0.75, cy + s * 0.75) + "L" +
            pair(cx - c * 0.55 - s * 0.5, cy - s * 0.55 + c * 0.5) + "L" + pair(cx - c * 0.2, cy - s * 0.2) +
            "L" + pair(cx - c * 0.55 + s * 0.5, cy - s * 0.55 - c * 0.5) + "Z\"" + paint("fill", disc.rim) +
            "/>\n";
  }
  void operator()(const Label& label) {
    const double size = 10 * label.size() * scene_.scale;
    const bool right = label.anchor == Anchor::upper_right || label.anchor == Anchor::lower_right;
    const bool low = label.anchor == Anchor::lower_left || label.anchor == Anchor::lower_right;
    const bool middle = label.anchor == Anchor::middle;
    // Digits are about seven tenths of the type size high.
    const double rise = middle ? 0.35 * size : low ? 0 : 0.7 * size;
    if (label.ground >> 24 != 0) plate(label, rise - 0.7 * size, size);
    out_ += "<text" + attribute("x", x(label.at)) + attribute("y", y(label.at) + rise) +
            attribute("font-size", size) + " text-anchor=\"" +
            (middle  ? "middle"
             : right ? "end"
                     : "start") +
            "\"" + paint("fill", label.colour) + ">" + label.text + "</text>\n";
  }

  /// Equal neighbours in a row become one rectangle, equal rows below each other too.
  void raster(const Raster& raster, Colour ground) {
    if (raster.columns == 0) return;
    const double width = raster.width / raster.columns, height = raster.height / raster.rows;
    const auto texel = [&](int column, int row) {
      return raster.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
                           static_cast<std::size_t>(column)];
    };
    const auto row_equal = [&](int a, int b) {
      for (int column = 0; column < raster.columns; ++column)
        if (texel(column, a) != texel(column, b)) return false;
      return true;
    };
    out_ += "<g shape-rendering=\"crispEdges\">\n";
    const Point from{raster.x, raster.y}, to{raster.x + raster.width, raster.y + raster.height};
    rectangle(x(from), y(from), x(to) - x(from), y(to) - y(from), paint("fill", ground));
    for (int row = 0, next = 0; row < raster.rows; row = next) {
      for (next = row + 1; next < raster.rows && row_equal(row, next);) ++next;
      for (int column = 0, end = 0; column < raster.columns; column = end) {
        for (end = column + 1; end < raster.columns && texel(end, row) == texel(column, row);) ++end;
        if (texel(column, row) == ground) continue;
        const Point a{raster.x + column * width, raster.y + row * height},
            b{raster.x + end * width, raster.y + next * height};
        rectangle(x(a), y(a), x(b) - x(a), y(b) - y(a), paint("fill", texel(column, row)));
      }
    }
    out_ += "</g>\n";
  }

  std::string finish() {
    const std::string width = std::to_string(scene_.width), height = std::to_string(scene_.height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height +
           "\" font-family=\"JetBrains Mono, monospace\">\n<rect width=\"100%\" height=\"100%\"" +
           paint("fill", scene_.background) + "/>\n" + out_ + "</svg>\n";
  }

 private:
  [[nodiscard]] double x(Point at) const {
    return (at.x - scene_.camera.x) * scene_.camera.zoom + scene_.width / 2.0;
  }
  [[nodiscard]] double y(Point at) const {
    return (at.y - scene_.camera.y) * scene_.camera.zoom + scene_.height / 2.0;
  }
  static std::string pair(double a, double b) { return number(a) + "," + number(b); }
  static std::string attribute(const char* name, double value) {
    return std::string(" ") + name + "=\"" + number(value) + "\"";
  }
  static std::string stroke(Colour colour, double width) {
    return paint("stroke", colour) + attribute("stroke-width", width);
  }
  void rectangle(double left, double top, double width, double height, const std::string& style) {
    out_ += "<rect" + attribute("x", left) + attribute("y", top) + attribute("width", width) +
            attribute("height", height) + style + "/>\n";
  }
  void circle(double cx, double cy, double r, const std::string& style) {
    out_ += "<circle" + attribute("cx", cx) + attribute("cy", cy) + attribute("r", r) + style + "/>\n";
  }
  /// The ground of a label whose digits begin `top` below its anchor.
  void plate(const Label& label, double top, double size) {
    const double width = label_width(label.text) * label.size() * scene_.scale;
    const bool right = label.anchor == Anchor::upper_right || label.anchor == Anchor::lower_right;
    const double left = x(label.at) - (label.anchor == Anchor::middle ? width / 2 : right ? width : 0);
    rectangle(left - 1, y(label.at) + top - 1, width + 2, 0.7 * size + 2, paint("fill", label.ground));
  }
  void figure(const std::string& path, const Outline& mark) {
    out_ += "<path d=\"" + path + "\" fill=\"none\"" + stroke(mark.colour, mark.stroke) + "/>\n";
  }

  const Scene& scene_;
  std::string out_;
};

}  // namespace

std::string scene_svg(const Scene& scene, const Palette& palette) {
  Writer writer(scene);
  writer.raster(scene.raster, palette.free);
  for (const Shape& shape : scene.shapes) std::visit(writer, shape);
  return writer.finish();
}

}  // namespace replan
