#include "core/scene/cover.hpp"

#include <algorithm>
#include <cmath>

namespace replan {
namespace {

constexpr double kWorld = 0.02, kThing = 3, kRing = 0.5, kWay = 3;

struct Screen {
  const Scene& scene;
  [[nodiscard]] double x(double at) const {
    return (at - scene.camera.x) * scene.camera.zoom + scene.width / 2.0;
  }
  [[nodiscard]] double y(double at) const {
    return (at - scene.camera.y) * scene.camera.zoom + scene.height / 2.0;
  }
};

PixelBox box_of(const Screen& screen, const Label& label) {
  const double scale = label.size() * screen.scene.scale;
  const double width = label_width(label.text) * scale, height = kDigitHeight * scale;
  double x = screen.x(label.at.x), y = screen.y(label.at.y);
  const bool right = label.anchor == Anchor::upper_right || label.anchor == Anchor::lower_right;
  const bool low = label.anchor == Anchor::lower_left || label.anchor == Anchor::lower_right;
  if (label.anchor == Anchor::middle) {
    x -= width / 2;
    y -= height / 2;
  } else {
    if (right) x -= width;
    if (low) y -= height;
  }
  return {x, y, x + width, y + height};
}

PixelBox around(double x, double y, double radius) {
  return {x - radius, y - radius, x + radius, y + radius};
}

/// How long a straight stretch is within a box.
double length_within(const PixelBox& box, double x0, double y0, double x1, double y1) {
  double from = 0, to = 1;
  const auto cut = [&](double at, double step, double low, double high) {
    if (step == 0) {
      if (at < low || at > high) to = from;
      return;
    }
    const double a = (low - at) / step, b = (high - at) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  cut(x0, x1 - x0, box.left, box.right);
  cut(y0, y1 - y0, box.top, box.bottom);
  return to <= from ? 0 : (to - from) * std::hypot(x1 - x0, y1 - y0);
}

}  // namespace

Cover::Cover(const Scene& scene) : world_(world(scene)) {
  const Screen screen{scene};
  for (const Shape& shape : scene.shapes) {
    if (const auto* label = std::get_if<Label>(&shape)) {
      add(box_of(screen, *label), kWords);
    } else if (const auto* disc = std::get_if<Disc>(&shape)) {
      add(around(screen.x(disc->centre.x), screen.y(disc->centre.y), static_cast<double>(disc->radius)),
          kThing);
    } else if (const auto* ring = std::get_if<Ring>(&shape); ring != nullptr && ring->dash == 0) {
      add(around(screen.x(ring->centre.x), screen.y(ring->centre.y), ring->radius * scene.camera.zoom),
          kRing);
    } else if (const auto* line = std::get_if<Polyline>(&shape)) {
      for (std::size_t i = 1; i < line->points.size(); ++i)
        ways_.push_back({screen.x(line->points[i - 1].x), screen.y(line->points[i - 1].y),
                         screen.x(line->points[i].x), screen.y(line->points[i].y),
                         static_cast<double>(line->width)});
    }
  }
}

double Cover::hidden(const PixelBox& box) const {
  double sum = kWorld * box.common(world_);
  for (const Thing& thing : things_) sum += thing.weight * box.common(thing.box);
  for (const Way& way : ways_) sum += kWay * way.width * length_within(box, way.x0, way.y0, way.x1, way.y1);
  return sum;
}

Cover Cover::within(const PixelBox& box) const {
  Cover part;
  part.world_ = world_;
  for (const Thing& thing : things_)
    if (thing.box.common(box) > 0) part.things_.push_back(thing);
  for (const Way& way : ways_)
    if (length_within(box, way.x0, way.y0, way.x1, way.y1) > 0) part.ways_.push_back(way);
  return part;
}

PixelBox Cover::best_beside(const PixelBox& size, const PixelBox& about, const PixelBox& room, double gap,
                            double reach, double farther) const {
  const PixelBox around{about.left - reach - size.width(), about.top - reach - size.height(),
                        about.right + reach + size.width(), about.bottom + reach + size.height()};
  const PixelBox kept{about.left - gap, about.top - gap, about.right + gap, about.bottom + gap};
  const Cover near = within(around);
  const auto moved = [&](double x, double y) {
    return size.moved_to(std::clamp(x, room.left, std::max(room.left, room.right - size.width())),
                         std::clamp(y, room.top, std::max(room.top, room.bottom - size.height())));
  };
  const auto cost = [&](const PixelBox& box) {
    return near.hidden(box) + kWords * box.common(kept) + farther * box.apart(kept);
  };
  // Narrow gaps between numbers shall be met, but not at any cost.
  const auto places = [](double range) { return std::clamp(static_cast<int>(range / 4), 16, 64); };
  const int rows = places(around.height()), columns = places(around.width());
  PixelBox best = moved(about.left, kept.top - size.height());
  double least = cost(best);
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const PixelBox box = moved(around.left + (about.right + reach - around.left) * column / columns,
                                 around.top + (about.bottom + reach - around.top) * row / rows);
      if (const double its = cost(box); its < least) {
        least = its;
        best = box;
      }
    }
  return best;
}

PixelBox Cover::cell(const Scene& scene, Cell cell) {
  const Screen screen{scene};
  return {screen.x(cell.x), screen.y(cell.y), screen.x(cell.x + 1), screen.y(cell.y + 1)};
}

PixelBox Cover::world(const Scene& scene) {
  const Screen screen{scene};
  return {screen.x(0), screen.y(0), screen.x(scene.columns), screen.y(scene.rows)};
}

}  // namespace replan
