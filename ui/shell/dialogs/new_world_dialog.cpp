// The size of an empty world.
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
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
  const Answer answer = confirm(look, "Create");
  if (answer == Answer::none) return {};
  DialogDecision decision;
  decision.kind = answer == Answer::yes ? DialogDecision::Kind::new_world : DialogDecision::Kind::cancel;
  decision.width = static_cast<int>(width_);
  decision.height = static_cast<int>(height_);
  return decision;
}

}  // namespace replan::ui
