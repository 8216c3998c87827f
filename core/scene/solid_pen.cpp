#include "core/scene/solid_pen.hpp"

#include <array>

namespace replan {
namespace {

/// More small cubes than these are left out.
constexpr std::size_t kMostCubes = 60'000;

float narrow(double value) {
  return static_cast<float>(value);
}

}  // namespace

Point SolidPen::on_sheet(Point point) const {
  coordinate(point, slice_.box.along()) = sheet();
  return point;
}

void SolidPen::line(const Point& a, const Point& b, Colour colour, float width) {
  scene_.lines.push_back({{narrow(a.x), narrow(a.y), narrow(a.z)},
                          {narrow(b.x), narrow(b.y), narrow(b.z)},
                          colour,
                          width * narrow(context_.view.scale)});
}

void SolidPen::polyline(const std::vector<Point>& points, Colour colour, float width) {
  for (std::size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i], colour, width);
}

void SolidPen::edges(const Point& low, const Point& high, Colour colour, float width) {
  const std::array<Point, 2> ends = {low, high};
  const auto corner = [&](unsigned bits) {
    return Point{ends[bits & 1u].x, ends[bits >> 1 & 1u].y, ends[bits >> 2 & 1u].z};
  };
  for (unsigned from = 0; from < 8; ++from)
    for (unsigned bit = 1; bit < 8; bit <<= 1)
      if ((from & bit) == 0) line(corner(from), corner(from | bit), colour, width);
}

bool SolidPen::cube(const Point& centre, double half, Colour colour) {
  if (scene_.cut && !scene_.cut->shows(centre)) return true;
  if (scene_.boxes.size() >= kMostCubes) {
    scene_.left_out = true;
    return false;
  }
  scene_.boxes.push_back({{narrow(centre.x - half), narrow(centre.y - half), narrow(centre.z - half)},
                          {narrow(centre.x + half), narrow(centre.y + half), narrow(centre.z + half)},
                          colour});
  return true;
}

void SolidPen::field(Overlay field) {
  // As a canvas shows the slice, a texel a cell.
  Scene plane;
  plane.camera.zoom = 1;
  View view = context_.view;
  view.slice = {slice_.box.along(), slice_.layer};
  view.overlays.set(field, true);
  SceneContext context{context_.run, view, context_.palette, context_.memory, plane};
  context.deadline = deadline_;
  build_field_sheet(context);
  if (context.memory.ranges.behind()) go_on();
  const SeenBox& box = slice_.box;
  const auto width = static_cast<double>(box.width()), height = static_cast<double>(box.height());
  SolidSheet& sheet = scene_.sheet;
  sheet.columns = plane.raster.columns;
  sheet.rows = plane.raster.rows;
  sheet.texels = std::move(plane.raster.texels);
  sheet.corner = on_sheet(box.world(Point{0, 0, 0}));
  sheet.right = on_sheet(box.world(Point{width, 0, 0}));
  sheet.down = on_sheet(box.world(Point{0, height, 0}));
  scene_.field = field;
  scene_.range = plane.range;
  scene_.field_words = plane.field_words;
}

}  // namespace replan
