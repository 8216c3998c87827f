#include "core/scene/orbit.hpp"

#include <algorithm>

namespace replan {
namespace {

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a + t b
Point along(const Point& a, double t, const Point& b) {
  return {a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
}

}  // namespace

OrbitLens::OrbitLens(const Orbit& orbit, const Box& world, const Viewport& view)
    : orbit_(orbit), width_(std::max(view.width, 1)), height_(std::max(view.height, 1)) {
  orbit_.pitch = std::clamp(orbit.pitch, -Orbit::kSteepest, Orbit::kSteepest);
  const double c = std::cos(orbit_.pitch), s = std::sin(orbit_.pitch);
  ahead_ = {-std::sin(orbit_.yaw) * c, -std::cos(orbit_.yaw) * c, -s};
  right_ = {std::cos(orbit_.yaw), -std::sin(orbit_.yaw), 0};
  up_ = {-std::sin(orbit_.yaw) * s, -std::cos(orbit_.yaw) * s, c};
  if (orbit.distance <= 0) {
    orbit_.focus = {world.width() / 2.0, world.height() / 2.0, world.depth() / 2.0};
    fit(world, view);
  }
  eye_ = along(orbit_.focus, -orbit_.distance, ahead_);
  find_depths(world);
}

namespace {

template <class Visit>
void each_corner(const Box& world, Visit&& visit) {
  for (const double x : {0, world.width()})
    for (const double y : {0, world.height()})
      for (const double z : {0, world.depth()}) visit(Point{x, y, z});
}

}  // namespace

/// As near together as the world allows, and what is drawn beside it, such as how far a sensor reaches.
void OrbitLens::find_depths(const Box& world) {
  constexpr double kNearest = 0.2;
  depths_ = {0, 0, HUGE_VAL, 0};
  each_corner(world, [&](const Point& corner) {
    const double depth = dot(along(corner, -1, eye_), ahead_);
    depths_.first = std::min(depths_.first, depth);
    depths_.last = std::max(depths_.last, depth);
  });
  const Point size{static_cast<double>(world.width()), static_cast<double>(world.height()),
                   static_cast<double>(world.depth())};
  const double beside = 1 + 0.2 * distance(Point{}, size);
  depths_.first = std::max(depths_.first, 0.0);
  depths_.last = std::max(depths_.last, depths_.first + 1);
  depths_.near = std::max(depths_.first - beside, kNearest);
  depths_.far = depths_.last + beside;
}

void OrbitLens::fit(const Box& world, const Viewport& view) {
  constexpr double kFilled = 0.94;
  const double tangent = std::tan(kFieldOfView / 2);
  const double tall = std::max(1, view.height - view.above - view.below) / static_cast<double>(height_);
  const double across = tangent * width_ / height_ * kFilled, high = tangent * tall * kFilled;
  each_corner(world, [&](const Point& corner) {
    const Point way = along(corner, -1, orbit_.focus);
    const double nearer = -dot(way, ahead_);
    orbit_.distance = std::max({orbit_.distance, std::abs(dot(way, right_)) / across + nearer,
                                std::abs(dot(way, up_)) / high + nearer, 1.0});
  });
  orbit_.focus = panned(0, -(view.above - view.below) / 2.0);
}

PixelBox OrbitLens::bounds(const Box& world) const {
  PixelBox box{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  each_corner(world, [&](const Point& corner) {
    const auto at = pixel(corner);
    if (!at) return;
    box = {std::min(box.left, at->x), std::min(box.top, at->y), std::max(box.right, at->x),
           std::max(box.bottom, at->y)};
  });
  return box.left <= box.right ? box : PixelBox{};
}

std::array<float, 16> OrbitLens::matrix() const {
  const double zoom = 1 / std::tan(kFieldOfView / 2), across = zoom * height_ / width_;
  const double deep = depths_.deep(), shift = depths_.shift();
  const auto row = [this](const Point& axis, double scale) {
    return std::array<double, 4>{axis.x * scale, axis.y * scale, axis.z * scale, -dot(axis, eye_) * scale};
  };
  const std::array<std::array<double, 4>, 4> rows = {row(right_, across), row(up_, zoom), row(ahead_, deep),
                                                     row(ahead_, 1)};
  std::array<float, 16> matrix{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      matrix[k * 4 + i] = static_cast<float>(rows[i][k] - (i == 2 && k == 3 ? shift : 0));
  return matrix;
}

std::optional<OrbitLens::Pixel> OrbitLens::pixel(const Point& point) const {
  const Point way{point.x - eye_.x, point.y - eye_.y, point.z - eye_.z};
  const double depth = dot(way, ahead_);
  if (depth <= 0) return std::nullopt;
  const double scale = height_ / 2.0 / std::tan(kFieldOfView / 2) / depth;
  return Pixel{width_ / 2.0 + dot(way, right_) * scale, height_ / 2.0 - dot(way, up_) * scale, depth};
}

EyeRay OrbitLens::ray(double x, double y) const {
  const double scale = std::tan(kFieldOfView / 2) / (height_ / 2.0);
  const Point aside = along(ahead_, (x - width_ / 2.0) * scale, right_);
  return {eye_, along(aside, -(y - height_ / 2.0) * scale, up_)};
}

double OrbitLens::pixel_angle() const {
  return std::tan(kFieldOfView / 2) / (height_ / 2.0);
}

double OrbitLens::cells_per_pixel() const {
  return orbit_.distance * pixel_angle();
}

Point OrbitLens::panned(double right, double down) const {
  const double cells = cells_per_pixel();
  return along(along(orbit_.focus, right * cells, right_), -down * cells, up_);
}

}  // namespace replan
