// In a pane of a world with several layers, below its title: which layer it shows, and along which axis.
#pragma once

#include "ui/canvas/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// The height that the bar takes, with the space below it.
float slice_bar_height(const Look& look);

/// Draws it in a window of its own, its upper left corner at `at` and at most so wide, within the ID of its pane.
void draw_slice_bar(const Look& look, const Sheet& sheet, std::size_t pane, ViewState& state, ImVec2 at,
                    float width);

/// "x → · z ↑": where the axes of the world lead in what a pane shows.
std::string axes_text(Axis along);
/// "z = 3 of 0 to 11"
std::string layer_text(const Sheet& sheet);
/// "z = 3", where there is no room for that.
std::string short_layer_text(const Sheet& sheet);

}  // namespace replan::ui
