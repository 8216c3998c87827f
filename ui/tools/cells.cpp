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
    std::vector<CellChange> cells = changes(
        context, stroke_on(context.press.sheet, context.view, context.press.before, context.press.last));
    std::erase_if(cells, [&](const CellChange& each) {
      return !written_.insert(context.run.lattice().node(each.cell)).second;
    });
    paint(context, std::move(cells));
  }
  [[nodiscard]] CellPreview preview(const Press& press, const ViewState& view) const override {
    return {brush_on(press.sheet, view, press.last), press.adds()};
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
  return {std::clamp(cell.x, 0, lattice.width() - 1), std::clamp(cell.y, 0, lattice.height() - 1),
          std::clamp(cell.z, 0, lattice.depth() - 1)};
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

std::optional<CellBox> in_world(const Box& lattice, const CellBox& all) {
  const CellBox kept = {
      {std::max(all.low.x, 0), std::max(all.low.y, 0), std::max(all.low.z, 0)},
      {std::min(all.high.x, lattice.width() - 1), std::min(all.high.y, lattice.height() - 1),
       std::min(all.high.z, lattice.depth() - 1)}};
  if (kept.low.x > kept.high.x || kept.low.y > kept.high.y || kept.low.z > kept.high.z) return std::nullopt;
  return kept;
}

std::vector<CellSpan> brush_on(const Sheet& sheet, const ViewState& view, Cell at) {
  return brush_spans({view.brush, view.editing.round}, sheet.box.seen(at));
}

std::vector<CellSpan> stroke_on(const Sheet& sheet, const ViewState& view, Cell from, Cell to) {
  return stroke_spans({view.brush, view.editing.round}, sheet.box.seen(from), sheet.box.seen(to));
}

std::vector<CellSpan> rectangle_on(const Sheet& sheet, Cell a, Cell b) {
  return rectangle_spans(sheet.box.seen(a), sheet.box.seen(b));
}

namespace {

/// The layers that a press draws in: its sheet's, and as many behind it as there are and tools are to draw.
std::vector<Sheet> sheets_of(const ToolContext& context) {
  const Sheet& first = context.press.sheet;
  std::vector<Sheet> sheets;
  const int end = std::min(first.layer + context.view.layers, first.box.depth());
  for (int layer = first.layer; layer < end; ++layer) sheets.push_back({first.box, layer});
  return sheets;
}

/// What of a row lies on a sheet; nothing: none of it.
std::optional<CellSpan> on_sheet(const Sheet& sheet, const CellSpan& span) {
  const CellSpan kept{span.y, std::max(0, span.first), std::min(sheet.box.width() - 1, span.last)};
  if (kept.y < 0 || kept.y >= sheet.box.height() || kept.first > kept.last) return std::nullopt;
  return kept;
}

}  // namespace

std::vector<CellChange> changes(const ToolContext& context, std::span<const CellSpan> spans,
                                std::size_t enough) {
  const Run& run = context.run;
  const bool adds = context.press.adds();
  const Cell start = run.scenario().start, goal = goal_cell(run);
  std::vector<CellChange> cells;
  for (const Sheet& sheet : sheets_of(context))
    for (const CellSpan& span : spans) {
      const auto part = on_sheet(sheet, span);
      if (!part || cells.size() > enough) continue;
      for (int column = part->first; column <= part->last; ++column) {
        const Cell at = sheet.cell(column, part->y);
        if (is_wall(run, at) != adds && !(adds && (at == start || at == goal))) cells.push_back({at, adds});
      }
    }
  return cells;
}

void paint(ToolContext& context, std::vector<CellChange> cells) {
  if (!cells.empty()) context.commands.emplace_back(PaintCells{std::move(cells), context.press.stroke});
}

void paint(ToolContext& context, const std::vector<CellSpan>& spans) {
  const std::vector<Sheet> sheets = sheets_of(context);
  if (count_cells(spans) * sheets.size() <= kLargeWorld) return paint(context, changes(context, spans));
  std::vector<CellBox> boxes;
  for (const CellSpan& span : spans)
    boxes.push_back(box_of(sheets.front().cell(span.first, span.y), sheets.back().cell(span.last, span.y)));
  context.commands.emplace_back(PaintBoxes{std::move(boxes), context.press.adds()});
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
    if (const auto part = on_sheet(context.press.sheet, span)) inside.push_back(*part);
  return inside;
}

}  // namespace replan::ui
