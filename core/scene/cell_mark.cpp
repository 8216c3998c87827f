#include "core/scene/cell_mark.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace replan {
namespace {

/// Cells this small (design pixels) are tinted in the raster instead of outlined; between the two, both by half.
constexpr double kOutlineFrom = 6, kOutlineTo = 11;
/// Of a tint: the field's colour is to be seen through it.
constexpr double kTintStrength = 0.55;

void tint(SceneContext& context, Cell cell, Colour colour, double strength) {
  Raster& raster = context.scene.raster;
  if (raster.texels.empty()) return;
  const auto place = [](double at, double extent, int count) {
    return std::clamp(static_cast<int>(std::floor(at / extent * count)), 0, count - 1);
  };
  const int column = place(cell.x + 0.5 - raster.x, raster.width, raster.columns);
  const int row = place(cell.y + 0.5 - raster.y, raster.height, raster.rows);
  Colour& texel = raster.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
                                static_cast<std::size_t>(column)];
  texel = mix(texel, colour | 0xFF000000u, static_cast<float>(strength));
}

void add_to_cells(SceneContext& context, std::span<CellMark* const> marks) {
  constexpr std::size_t kPage = SearchState::kPage;
  const int step = std::max(1, static_cast<int>(1 / context.zoom));
  std::vector<CellMark*> here;
  for (int y = context.top; y < context.bottom; y += step)
    for (int x = context.left; x < context.right;) {
      NodeId node = context.node(x, y);
      const int end = std::min(context.right, x + context.lattice.columns_on_page(node, kPage));
      here.clear();
      for (CellMark* mark : marks)
        if (mark->turn_to(node)) here.push_back(mark);
      for (; x < end && !here.empty();
           x += step, node += static_cast<NodeId>(step) * context.lattice.column_step())
        for (CellMark* mark : here) mark->add({x, y, context.slice}, node);
      while (x < end) x += step;
    }
}

}  // namespace

bool CellMark::turn_to(NodeId) {
  return true;
}

void add_cell_marks(SceneContext& context, std::span<const std::unique_ptr<CellMark>> marks) {
  std::vector<CellMark*> wanting;
  for (const auto& mark : marks)
    if (mark->wants_cells()) wanting.push_back(mark.get());
  if (!wanting.empty()) add_to_cells(context, wanting);
  for (const auto& mark : marks) mark->finish();
}

void mark_cell(SceneContext& context, Cell cell, OutlineShape shape, Colour colour, double strength,
               float stroke, float inset) {
  const double outlined = context.grown(kOutlineFrom, kOutlineTo);
  if (outlined < 1) tint(context, cell, colour, (1 - outlined) * strength * kTintStrength);
  if (outlined > 0)
    context.add(Outline{static_cast<double>(cell.x), static_cast<double>(cell.y), 1, 1, shape,
                        faded(colour, outlined * strength), stroke, inset});
}

void add_cell_lines(SceneContext& context, Colour colour) {
  const float width = std::max(1.0f, std::floor(context.pixels(1)));
  const auto left = static_cast<double>(context.left), right = static_cast<double>(context.right),
             top = static_cast<double>(context.top), bottom = static_cast<double>(context.bottom);
  for (int column = context.left; column <= context.right; ++column) {
    const auto x = static_cast<double>(column);
    context.add(Line{{x, top}, {x, bottom}, colour, width});
  }
  for (int row = context.top; row <= context.bottom; ++row) {
    const auto y = static_cast<double>(row);
    context.add(Line{{left, y}, {right, y}, colour, width});
  }
}

double words_width(const SceneContext& context, std::string_view words) {
  return context.world(label_width(words));
}

}  // namespace replan
