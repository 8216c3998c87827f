#include "ui/canvas/overlay.hpp"

namespace replan::ui {

void draw_editing(const CellPen& pen, const ViewState& state, const CellPreview& preview,
                  std::optional<Cell> hovered) {
  const Theme& theme = pen.look().theme;
  if (const auto& region = state.editing.region) {
    // Fainter on the layers before and behind it.
    const bool here = pen.meets(*region);
    pen.dashed_frame(*region, with_alpha(theme.accent, here ? 1 : 0.4f));
    if (here) pen.fill(*region, with_alpha(theme.accent, 0.1f));
  }
  const auto own = state.tools.kind().colour;
  const ImU32 colour = !preview.adds ? theme.dim : own != nullptr ? theme.*own : theme.accent;
  pen.area(pen.inside(preview.cells), colour, preview.filled && preview.adds ? 0.3f : 0);
  state.tools.chosen().draw(pen, state, hovered);
}

}  // namespace replan::ui
