// The size of an empty world.
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

DialogDecision Dialogs::new_world_dialog(const Look& look) {
  heading(look, "New world");
  paragraph(look.fonts.ui, look.theme.dim, "All cells are free; paint the obstacles with the brush.");
  slider(look,
         {.label = "Width",
          .min = 4,
          .max = 2048,
          .initial = 48,
          .unit = "cells",
          .decimals = 0,
          .logarithmic = true},
         width_, {"Width", "", "Columns of cells, from left to right."});
  slider(look,
         {.label = "Height",
          .min = 4,
          .max = 2048,
          .initial = 32,
          .unit = "cells",
          .decimals = 0,
          .logarithmic = true},
         height_, {"Height", "", "Rows of cells, from top to bottom."});
  slider(
      look, {.label = "Layers", .min = 1, .max = 512, .initial = 1, .decimals = 0, .logarithmic = true},
      layers_,
      {"Layers", "", "One makes a plane; more make a world in space, whose layers lie one above the other."});
  const std::int64_t most = layers_ > 1 ? kMaxVoxels : kMaxCells;
  const bool too_many = width_ * height_ * layers_ > static_cast<double>(most);
  if (too_many)
    paragraph(
        look.fonts.ui, look.theme.bad,
        "That is more than the " + grouped(static_cast<std::size_t>(most)) + " cells that a world can have.");
  const Answer answer = confirm(look, "Create");
  if (answer == Answer::none || (answer == Answer::yes && too_many)) return {};
  DialogDecision decision;
  decision.kind = answer == Answer::yes ? DialogDecision::Kind::new_world : DialogDecision::Kind::cancel;
  decision.width = static_cast<int>(width_);
  decision.height = static_cast<int>(height_);
  decision.layers = static_cast<int>(layers_);
  return decision;
}

}  // namespace replan::ui
