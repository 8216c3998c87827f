#include "core/scene/script.hpp"

#include <algorithm>
#include <span>

#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

/// More cells than this in sight are shown by the rectangle around them.
constexpr std::size_t kMostOutlined = 20'000;

/// The cells of a surprise in the layer that shows, by the view's coordinates and in the order of its rows.
class CellSet {
 public:
  CellSet(std::span<const CellChange> cells, const SceneContext& context) {
    if (context.lattice.along() != Axis::z) cells = turn(cells, context);
    const auto from = [&](int z) {
      return std::partition_point(cells.begin(), cells.end(),
                                  [z](const CellChange& each) { return each.cell.z < z; });
    };
    cells_ = {from(context.slice), from(context.slice + 1)};
  }
  [[nodiscard]] std::span<const CellChange> all() const { return cells_; }
  [[nodiscard]] bool has(Cell cell) const {
    const auto before = [](const CellChange& a, Cell b) { return in_node_order(a.cell, b); };
    const auto found = std::lower_bound(cells_.begin(), cells_.end(), cell, before);
    return found != cells_.end() && found->cell == cell;
  }

 private:
  std::span<const CellChange> turn(std::span<const CellChange> cells, const SceneContext& context) {
    for (const CellChange& each : cells)
      if (const Cell cell = context.seen(each.cell); cell.z == context.slice)
        turned_.push_back({cell, each.blocked});
    std::sort(turned_.begin(), turned_.end(),
              [](const CellChange& a, const CellChange& b) { return in_node_order(a.cell, b.cell); });
    return turned_;
  }

  std::vector<CellChange> turned_;  // where they are not in that order already
  std::span<const CellChange> cells_;
};

/// One surprise that is to come.
class ComingSurprise {
 public:
  ComingSurprise(SceneContext& context, const Surprise& surprise, bool selected)
      : context_(context),
        surprise_(surprise),
        colour_(selected ? context.palette.accent : context.palette.surprise),
        width_(context.pixels(selected ? 2.2 : 1.4)) {}

  void add() {
    if (cells_.all().empty()) return;
    const auto visible = static_cast<std::size_t>(
        std::count_if(cells_.all().begin(), cells_.all().end(),
                      [this](const CellChange& each) { return context_.in_sight(each.cell); }));
    if (visible > 0) context_.scene.show(Sign::to_come);
    if (visible > kMostOutlined || context_.grown(3, 4) <= 0) {
      add_bounds();
    } else {
      for (const CellChange& each : cells_.all())
        if (context_.in_sight(each.cell)) add_cell(each);
    }
    add_trigger();
  }

 private:
  void add_cell(const CellChange& change) {
    const auto x = static_cast<double>(change.cell.x), y = static_cast<double>(change.cell.y);
    const auto edge = [&](int dx, int dy, Point from, Point to) {
      if (!cells_.has({change.cell.x + dx, change.cell.y + dy, change.cell.z}))
        context_.add(Line{from, to, colour_, width_});
    };
    edge(0, -1, {x, y}, {x + 1, y});
    edge(0, 1, {x, y + 1}, {x + 1, y + 1});
    edge(-1, 0, {x, y}, {x, y + 1});
    edge(1, 0, {x + 1, y}, {x + 1, y + 1});
    const double strength = context_.grown(5, 9);
    if (!change.blocked || strength <= 0) return;  // what opens is outlined only
    const Colour hatch = faded(colour_, strength * 0.55);
    const float width = context_.pixels(1);
    context_.add(Line{{x, y + 0.5}, {x + 0.5, y}, hatch, width});
    context_.add(Line{{x + 0.5, y + 1}, {x + 1, y + 0.5}, hatch, width});
  }

  void add_bounds() {
    Cell low = cells_.all().front().cell, high = low;
    for (const CellChange& each : cells_.all()) {
      low = {std::min(low.x, each.cell.x), std::min(low.y, each.cell.y)};
      high = {std::max(high.x, each.cell.x), std::max(high.y, each.cell.y)};
    }
    context_.add(Outline{static_cast<double>(low.x), static_cast<double>(low.y), high.x - low.x + 1.0,
                         high.y - low.y + 1.0, OutlineShape::square, colour_, width_, 0});
  }

  /// What sets it off: the step beside it, or a ring around the place.
  void add_trigger() {
    const Trigger& at = surprise_.at;
    const Point place = SceneContext::centre(context_.seen(at.near.value_or(Cell{})));
    const double radius = at.near ? context_.cut_radius(place, at.within) : 0;
    if (radius * context_.zoom > context_.pixels(4))
      context_.add(Ring{place, radius, faded(colour_, 0.7), context_.pixels(1), context_.pixels(4)});
    const CellChange* first = &cells_.all().front();
    if (!context_.in_sight(first->cell)) return;
    const std::string words = at.move ? "step " + std::to_string(*at.move) : "when near";
    context_.notes.push_back({first->cell, {words}, colour_});
  }

  SceneContext& context_;
  const Surprise& surprise_;
  CellSet cells_{surprise_.cells, context_};
  Colour colour_;
  float width_;
};

void add_way(SceneContext& context, const MovingObstacle& mover, bool selected) {
  const Colour colour = selected ? context.palette.accent : context.palette.mover;
  Polyline way{{}, colour, context.pixels(1.6), 0, context.pixels(5)};
  for (const Point& point : way_points(mover)) way.points.push_back(context.seen(point));
  const Cell size = context.lattice.turned({mover.width, mover.height, mover.depth});
  const std::vector<Point> corners = way.points;
  if (mover.at_end == WayEnd::loop && corners.size() > 2) way.points.push_back(corners.front());
  context.scene.show(Sign::mover);
  if (way.points.size() > 1) add_through_layers(context, std::move(way), size.z);
  for (std::size_t i = 1; i < corners.size(); ++i)
    context.add(Disc{corners[i], context.pixels(selected ? 4.5 : 3),
                     context.seen_at(corners[i], colour, size.z),
                     context.seen_at(corners[i], context.palette.outline, size.z), context.pixels(1)});
  const Point middle = corners.front();
  context.add(Outline{middle.x - size.x / 2.0, middle.y - size.y / 2.0, static_cast<double>(size.x),
                      static_cast<double>(size.y), OutlineShape::square,
                      context.seen_at(middle, colour, size.z), context.pixels(selected ? 2.4 : 1.6), 0});
}

void draw_script(SceneContext& context) {
  const Scenario& scenario = context.run.scenario();
  for (std::size_t i = 0; i < scenario.movers.size(); ++i)
    add_way(context, scenario.movers[i], context.view.selected_mover == i);
  for (std::size_t i = 0; i < scenario.surprises.size(); ++i)
    if (is_to_come(context.run, i))
      ComingSurprise(context, scenario.surprises[i], context.view.selected_surprise == i).add();
}

void way_in_space(SolidPen& pen, const MovingObstacle& mover) {
  pen.show(Sign::mover);
  std::vector<Point> way = way_points(mover);
  if (mover.at_end == WayEnd::loop && way.size() > 2) way.push_back(way.front());
  pen.polyline(way, faded(pen.palette().mover, 0.7), 1.4f);
}

/// The box around its cells: they lie in many layers.
void surprise_in_space(SolidPen& pen, const Surprise& surprise) {
  if (surprise.cells.empty()) return;
  CellBox box{surprise.cells.front().cell, surprise.cells.front().cell};
  for (const CellChange& each : surprise.cells) {
    box.low = box_of(box.low, each.cell).low;
    box.high = box_of(box.high, each.cell).high;
  }
  const auto corner = [](Cell cell, int by) {
    return Point{static_cast<double>(cell.x + by), static_cast<double>(cell.y + by),
                 static_cast<double>(cell.z + by)};
  };
  pen.show(Sign::to_come);
  pen.edges(corner(box.low, 0), corner(box.high, 1), pen.palette().surprise, 1.4f);
}

void script_in_space(SolidPen& pen) {
  const Run& run = pen.context().run;
  for (const MovingObstacle& mover : run.scenario().movers) way_in_space(pen, mover);
  for (std::size_t i = 0; i < run.scenario().surprises.size(); ++i)
    if (is_to_come(run, i)) surprise_in_space(pen, run.scenario().surprises[i]);
}

}  // namespace

OverlayKind overlay_script() {
  return {
      .info = {.label = "upcoming events",
               .help =
                   "Surprises that have not happened yet, with what sets them off, and the ways of moving "
                   "obstacles.",
               .at_first = true},
      .layer = Layer::script,
      .draw = draw_script,
      .draw_in_space = script_in_space};
}

}  // namespace replan
