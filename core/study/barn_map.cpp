#include "core/study/barn_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/lattice/segment.hpp"

namespace replan {
namespace {

Box box_of(const BarnWorld& world, double cell) {
  return {static_cast<int>(std::lround(world.width / cell)),
          static_cast<int>(std::lround(world.height / cell))};
}

/// The distance along a ray of unit length to a disc, or `most`.
double along_ray(Spot from, Spot way, Spot disc, double radius, double most) {
  const double x = disc.x - from.x, y = disc.y - from.y;
  const double along = x * way.x + y * way.y, across = x * way.y - y * way.x;
  const double half = radius * radius - across * across;
  if (half < 0) return most;
  const double at = along - std::sqrt(half);
  return at >= 0 && at < most ? at : most;
}

}  // namespace

BarnLaser::BarnLaser(const BarnWorld& world, const BarnSettings& settings)
    : world_(world), settings_(settings), frame_{box_of(world, world.cell), world.cell} {
  cylinders_.resize(frame_.box.node_count());
  for (const Spot& disc : world.discs) cylinders_[frame_.box.node(frame_.cell(disc))] = 1;
}

/// A disc lies within its cell, so a ray meets the discs in the order in which it passes through their cells.
double BarnLaser::hit(Spot from, Spot way) const {
  const double range = settings_.range, side = frame_.side;
  Cell at = frame_.cell(from);
  const int step_x = way.x > 0 ? 1 : -1, step_y = way.y > 0 ? 1 : -1;
  const auto next = [side](double from_x, double way_x, int cell, int step) {
    return way_x == 0 ? 1e9 : ((cell + (step > 0 ? 1 : 0)) * side - from_x) / way_x;
  };
  for (double entered = 0; entered < range;) {
    if (frame_.box.contains(at) && cylinders_[frame_.box.node(at)] != 0) {
      const double found = along_ray(from, way, frame_.centre(at), world_.disc_radius, range);
      if (found < range) return found;
    }
    const double x = next(from.x, way.x, at.x, step_x), y = next(from.y, way.y, at.y, step_y);
    entered = std::min(x, y);
    if (x <= y)
      at.x += step_x;
    else
      at.y += step_y;
  }
  return range;
}

std::vector<Spot> BarnLaser::scan(const Pose& from) const {
  std::vector<Spot> hits;
  const double view = settings_.field_of_view * kPi / 180;
  for (int i = 0; i < settings_.rays; ++i) {
    const auto [sine, cosine] = sine_cosine(from.heading + view * ((i + 0.5) / settings_.rays - 0.5));
    const double far = hit(from.spot(), {cosine, sine});
    if (far < settings_.range) hits.push_back({from.x + far * cosine, from.y + far * sine});
  }
  return hits;
}

BarnMap::BarnMap(const BarnWorld& world, double cell, double radius)
    : frame_{box_of(world, cell), cell}, radius_(radius) {
  marked_.resize(frame_.box.node_count());
  inflated_.resize(frame_.box.node_count());
}

bool BarnMap::sees(Spot a, Spot b) const {
  const auto point = [this](Spot at) { return Point{at.x / frame_.side, at.y / frame_.side, 0.5}; };
  if (!frame_.box.contains(frame_.cell(a)) || !frame_.box.contains(frame_.cell(b))) return false;
  return walk_segment(frame_.box, point(a), point(b), [this](NodeId node) { return !inflated(node); });
}

void BarnMap::mark(const std::vector<Spot>& hits, std::vector<CellEdit>& closed) {
  const double reach = radius_ / frame_.side;
  const int cells = static_cast<int>(std::ceil(reach + 0.5));
  for (const Spot& hit : hits) {
    const Cell cell = frame_.cell(hit);
    if (!frame_.box.contains(cell) || marked_[frame_.box.node(cell)] != 0) continue;
    marked_[frame_.box.node(cell)] = 1;
    frame_.box.each_cell_around(cell, cells, [&](NodeId node) {
      const Cell other = frame_.box.position(node);
      const double x = std::max(std::abs(other.x - cell.x) - 0.5, 0.0);
      const double y = std::max(std::abs(other.y - cell.y) - 0.5, 0.0);
      if (inflated_[node] != 0 || x * x + y * y >= reach * reach) return;
      inflated_[node] = 1;
      closed.push_back({node, true});
    });
  }
}

}  // namespace replan
