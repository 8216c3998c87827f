#include "ui/tools/cells.hpp"

#include <algorithm>
#include <unordered_set>

#include "ui/canvas/view_state.hpp"

namespace replan::ui {
namespace {

/// The cell of a node that the log speaks of, or `otherwise` before it does.
Cell place(const Run& run, NodeId node, Cell otherwise) {
  return node == kNoNode ? otherwise : run.lattice().position(node);
}

class BrushDrag final : public Drag {
 public:
  void move(ToolContext& context) override {
    // The mouse may have leapt over cells since the last frame.
    std::vector<CellChange> cells =
        changes(context, stroke_spans(brush_of(context.view), context.press.before, context.press.last));
    std::erase_if(cells, [&](const CellChange& each) {
      return !written_.insert(context.run.lattice().node(each.cell)).second;
    });
    paint(context, std::move(cells));
  }
  [[nodiscard]] CellPreview preview(const Press& press, const ViewState& view) const override {
    return {brush_spans(brush_of(view), press.last), press.adds()};
  }
  [[nodiscard]] bool draws() const override { return true; }
  [[nodiscard]] bool leaves_world() const override { return true; }

 private:
  std::unordered_set<std::uint32_t> written_;  // nodes: each once in a stroke
};

}  // namespace

std::unique_ptr<Drag> Tool::press_right(ToolContext& context) {
  context.view.menu = context.press.first;
  return nullptr;
}

std::unique_ptr<Drag> brush_drag() {
  return std::make_unique<BrushDrag>();
}

Cell clamped(const Box& lattice, Cell cell) {
  return {std::clamp(cell.x, 0, lattice.width() - 1), std::clamp(cell.y, 0, lattice.height() - 1)};
}

bool is_wall(const Run& run, Cell cell) {
  return run.timeline().state().wall(run.lattice().node(cell));
}

Cell goal_cell(const Run& run) {
  return place(run, run.timeline().state().wanted_goal(), run.scenario().goal);
}

Cell robot_cell(const Run& run) {
  return place(run, run.timeline().state().node(Scalar::robot), run.scenario().start);
}

CellRect rectangle(Cell a, Cell b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

std::optional<CellRect> in_world(const Box& lattice, const CellRect& all) {
  const CellRect kept = {
      {std::max(all.low.x, 0), std::max(all.low.y, 0)},
      {std::min(all.high.x, lattice.width() - 1), std::min(all.high.y, lattice.height() - 1)}};
  if (kept.low.x > kept.high.x || kept.low.y > kept.high.y) return std::nullopt;
  return kept;
}

Brush brush_of(const ViewState& view) {
  return {view.brush, view.editing.round};
}

std::vector<CellChange> changes(const ToolContext& context, std::span<const CellSpan> spans,
                                std::size_t enough) {
  const Run& run = context.run;
  const Box& lattice = run.lattice();
  const bool adds = context.press.adds();
  const Cell start = run.scenario().start, goal = goal_cell(run);
  std::vector<CellChange> cells;
  for (const CellSpan& span : spans) {
    if (span.y < 0 || span.y >= lattice.height() || cells.size() > enough) continue;
    for (int x = std::max(0, span.first); x <= std::min(lattice.width() - 1, span.last); ++x) {
      const Cell at{x, span.y};
      if (is_wall(run, at) != adds && !(adds && (at == start || at == goal))) cells.push_back({at, adds});
    }
  }
  return cells;
}

void paint(ToolContext& context, std::vector<CellChange> cells) {
  if (!cells.empty()) context.commands.emplace_back(PaintCells{std::move(cells), context.press.stroke});
}

void paint(ToolContext& context, std::vector<CellSpan> spans) {
  if (count_cells(spans) > kLargeWorld)
    context.commands.emplace_back(PaintSpans{std::move(spans), context.press.adds()});
  else
    paint(context, changes(context, spans));
}

void ShapeDrag::end(ToolContext& context) {
  paint(context, spans(context));
}

CellPreview ShapeDrag::preview(const Press& press, const ViewState& view) const {
  return {shape_(press, view), press.adds(), true};
}

std::vector<CellSpan> ShapeDrag::spans(const ToolContext& context) const {
  std::vector<CellSpan> inside;
  for (const CellSpan& span : shape_(context.press, context.view))
    if (const auto part = in_world(context.run.lattice(), {{span.first, span.y}, {span.last, span.y}}))
      inside.push_back({span.y, part->low.x, part->high.x});
  return inside;
}

}  // namespace replan::ui
