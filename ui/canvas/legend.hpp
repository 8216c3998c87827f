// The legend: one for all panes. A click on a key explains it.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.hpp"
#include "ui/colormap.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// All that the canvas can show, with the mark that the legend gives it.
std::vector<LegendEntry> all_signs(const Look& look);

/// What a key of the legend means: a heading and a few sentences. Empty if there is no such key.
struct LegendWords {
  std::string title, text;
};
LegendWords legend_words(std::string_view label);

/// What stands in the legend beside a field.
struct LegendSigns {
  SignSet signs;
  int every_edge = 1;  ///< as in Scene, the largest of all

  void add(const Scene& scene) {
    signs |= scene.signs;
    every_edge = std::max(every_edge, scene.every_edge);
  }
};

class Legend {
 public:
  /// The height that it takes in one row, with the space around it.
  [[nodiscard]] static float height(const Look& look);

  /// In a window of its own at the lower left of `min`..`max`: the field of one pane's scene in its colours, and
  /// the signs that any pane shows. `of` says whose field it is, where another pane's means something else. `outside`: start and goal have
  /// the shapes that they have in 3D. What has no room in its row unfolds above its end while the mouse is there.
  void draw(const Look& look, const Scene& scene, std::string_view of, FieldColours colours,
            const LegendSigns& signs, bool outside, ImVec2 min, ImVec2 max);

 private:
  void row(const Look& look, const LegendField& field, const std::vector<LegendEntry>& entries,
           ImVec2 corner);
  void key(const Look& look, std::string_view label, const LegendWords& words, const ScreenArea& box);
  void explain(const Look& look);

  bool unfolded_ = false;   // the mouse was on it
  std::string_view field_;  // the field's name in the list of overlays
  LegendWords asked_;       // of the key that was clicked last
};

}  // namespace replan::ui
