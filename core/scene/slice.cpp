// What a view of one layer of the world shows of what leads through several, or stands in another.
#include <cmath>

#include "core/scene/context.hpp"

namespace replan {
namespace {

constexpr double kFaint = 0.3;

Point between(const Point& a, const Point& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

struct Heights {
  double low, high;
  [[nodiscard]] bool has(double z) const { return z >= low && z < high; }
};

/// Where the middle of something of so many layers is while it meets a slice: what moves does so from cell to cell,
/// so half way to the next layer it is in that one.
Heights meeting(int slice, int thickness) {
  return {slice + 0.5 - thickness / 2.0, slice + 0.5 + thickness / 2.0};
}

/// A line parted where it enters a range of heights and leaves it.
class PartedLine {
 public:
  PartedLine(const Polyline& line, Heights heights) : line_(line), heights_(heights) {
    for (std::size_t i = 1; i < line.points.size(); ++i) part(line.points[i - 1], line.points[i]);
    end_piece();
  }

  std::vector<Polyline> inside, outside;

 private:
  void part(const Point& from, const Point& to) {
    std::vector<double> shares = {0, 1};
    for (const double height : {heights_.low, heights_.high})
      if ((from.z < height) != (to.z < height)) shares.push_back((height - from.z) / (to.z - from.z));
    std::sort(shares.begin(), shares.end());
    for (std::size_t i = 1; i < shares.size(); ++i) {
      const double middle = between(from, to, (shares[i - 1] + shares[i]) / 2).z;
      add(between(from, to, shares[i - 1]), between(from, to, shares[i]), heights_.has(middle));
    }
  }

  void add(const Point& from, const Point& to, bool within) {
    if (within != within_) end_piece();
    within_ = within;
    if (piece_.empty()) piece_.push_back(from);
    // Straight up or down nothing is to be seen.
    if (to.x != from.x || to.y != from.y) piece_.push_back(to);
  }

  void end_piece() {
    if (piece_.size() > 1) {
      Polyline part = line_;
      part.points = piece_;
      (within_ ? inside : outside).push_back(std::move(part));
    }
    piece_.clear();
  }

  const Polyline& line_;
  Heights heights_;
  bool within_ = false;
  std::vector<Point> piece_;
};

}  // namespace

Colour SceneContext::seen_at(const Point& middle, Colour colour, int thickness) const {
  const bool here = !lattice.solid() || meeting(slice, thickness).has(middle.z);
  return here ? colour : faded(colour, kFaint);
}

double SceneContext::cut_radius(const Point& centre, double radius) const {
  if (!lattice.solid()) return radius;
  const double off = slice + 0.5 - centre.z;
  return std::sqrt(std::max(0.0, radius * radius - off * off));
}

void add_through_layers(SceneContext& context, Polyline line, int thickness) {
  if (!context.lattice.solid()) return context.add(std::move(line));
  const PartedLine parted(line, meeting(context.slice, thickness));
  for (Polyline piece : parted.outside) {
    piece.colour = faded(piece.colour, kFaint);
    context.add(std::move(piece));
  }
  for (const Polyline& piece : parted.inside) context.add(piece);
}

}  // namespace replan
