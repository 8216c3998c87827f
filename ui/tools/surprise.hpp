// The tool for surprises: drops them now, lets them wait, and selects those that do.
#pragma once

#include <cstdint>
#include <optional>

#include "ui/tools/tool.hpp"

namespace replan::ui {

/// When a surprise that is drawn happens.
enum class SurpriseTime : std::uint8_t { now, step, near };

class SurpriseTool final : public Tool {
 public:
  struct Options {
    SurpriseTime time = SurpriseTime::now;
    std::int64_t step = 10;
    double within = 4;  ///< cells from the middle of what is drawn
  };

  std::unique_ptr<Drag> press(ToolContext& context) override;
  [[nodiscard]] bool has_options(const ViewState&) const override { return true; }
  void draw_options(Frame& frame) override;
  void choose(ViewState& view) override;

  Options& options() { return options_; }

 private:
  Options options_;
};

/// The scheduled surprise that has a cell there and has not happened yet at the cursor, the latest first.
std::optional<std::size_t> surprise_at(const Run& run, Cell cell);
/// What can be done with the surprise that is selected.
void draw_selected_surprise(Frame& frame);

}  // namespace replan::ui
