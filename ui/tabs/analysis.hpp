// The Analysis tab: a run as a whole. Its points in a scatter plot, and the tree that its parents make.
#pragma once

#include "ui/shell/frame.hpp"
#include "ui/tabs/family.hpp"
#include "ui/tabs/scatter.hpp"

namespace replan::ui {

class AnalysisTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  void show_scatter() { part_ = Part::scatter; }
  void show_family() { part_ = Part::family; }

  [[nodiscard]] ScatterView& scatter() { return scatter_; }
  [[nodiscard]] FamilyView& family() { return family_; }

 private:
  enum class Part : int { scatter, family };

  Part part_ = Part::scatter;
  bool lit_ = false;  // the family was switched on for the canvas
  ScatterView scatter_;
  FamilyView family_;
};

// Each shows the tab with that part.
void show_scatter(ViewState& view, PanelState& panels);
void show_family(ViewState& view, PanelState& panels);
/// Whether the scatter plot has points to copy, and copies them.
bool has_scatter(const Session& session, const PanelState& panels);
void copy_scatter(const Session& session, PanelState& panels);

}  // namespace replan::ui
