#include "ui/tools/surprise.hpp"

#include <algorithm>
#include <array>

#include "core/base/words.hpp"
#include "core/scene/script.hpp"
#include "ui/canvas/view_state.hpp"
#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tools/cells.hpp"

namespace replan::ui {
namespace {

std::vector<CellSpan> surprised_cells(const Press& press, const ViewState&) {
  return rectangle_on(press.sheet, press.first, press.last);
}

class SurpriseDrag final : public ShapeDrag {
 public:
  explicit SurpriseDrag(const SurpriseTool::Options& options)
      : ShapeDrag(surprised_cells), options_(options) {}

  /// A click on one that waits selects it, or lets go of it.
  void end(ToolContext& context) override {
    const Press& press = context.press;
    std::optional<std::size_t>& selected = context.view.editing.surprise;
    if (const auto there = surprise_at(context.run, press.first); there && !press.moved) {
      selected = selected == there ? std::nullopt : there;
      return;
    }
    std::vector<CellChange> cells = changes(context, spans(context), kMostSurprised);
    if (cells.empty()) return;
    if (options_.time == SurpriseTime::now) {
      context.commands.emplace_back(DropSurprise{std::move(cells), press.stroke});
      return;
    }
    context.view.editing.mover.reset();
    selected = context.session.scenario().surprises.size();
    context.commands.emplace_back(ScheduleSurprise{later(press, std::move(cells))});
  }
  [[nodiscard]] bool draws() const override { return false; }
  /// The middle of what is drawn has to be a cell.
  [[nodiscard]] bool leaves_world() const override { return false; }

 private:
  [[nodiscard]] Surprise later(const Press& press, std::vector<CellChange> cells) const {
    Surprise surprise;
    if (options_.time == SurpriseTime::step) {
      surprise.at.move = options_.step;
    } else {
      surprise.at.near = Cell{(press.first.x + press.last.x) / 2, (press.first.y + press.last.y) / 2,
                              (press.first.z + press.last.z) / 2};
      surprise.at.within = options_.within;
    }
    surprise.cells = std::move(cells);
    return surprise;
  }

  const SurpriseTool::Options& options_;
};

/// How far the robot has come: a surprise can only be scheduled for later.
std::int64_t clock_of(const Session& session) {
  const Run& run = session.run();
  const Decision* decision = run.decision_at(run.timeline().cursor());
  return decision == nullptr ? 0 : decision->clock;
}

}  // namespace

std::unique_ptr<Drag> SurpriseTool::press(ToolContext&) {
  return std::make_unique<SurpriseDrag>(options_);
}

void SurpriseTool::choose(ViewState& view) {
  show_script(view.view.overlays);
}

void SurpriseTool::draw_options(Frame& frame) {
  const Look& look = frame.look;
  static constexpr std::array<const char*, 3> kTimes = {"Now", "At a step", "When near"};
  int time = static_cast<int>(options_.time);
  section_title(look, "When it happens");
  if (segments(look, "time", kTimes, time)) options_.time = static_cast<SurpriseTime>(time);
  hint(look,
       {"When", "",
        "At once; after a number of steps of the robot; or when it comes near the middle of what you draw."});
  if (options_.time == SurpriseTime::step) {
    const std::int64_t now = clock_of(frame.session);
    options_.step = std::max(options_.step, now);
    double step = static_cast<double>(options_.step);
    if (slider(look,
               {.label = "Step",
                .min = static_cast<double>(now),
                .max = static_cast<double>(now + 200),
                .initial = static_cast<double>(now + 10),
                .decimals = 0},
               step, {"Step", "", "After that many steps of the robot; waiting counts as well."}))
      options_.step = static_cast<std::int64_t>(step);
  } else if (options_.time == SurpriseTime::near) {
    slider(look, {.label = "Within", .min = 0, .max = 64, .initial = 4, .unit = "cells", .decimals = 1},
           options_.within,
           {"Within", "",
            "How near the robot has to come, from its cell's centre to the middle of what you draw."});
  }
}

std::optional<std::size_t> surprise_at(const Run& run, Cell cell) {
  const Surprises& all = run.scenario().surprises;
  for (std::size_t i = all.size(); i-- > 0;) {
    if (!is_to_come(run, i)) continue;
    for (const CellChange& change : all[i].cells)
      if (change.cell == cell) return i;
  }
  return std::nullopt;
}

void draw_selected_surprise(Frame& frame) {
  const Look& look = frame.look;
  const Surprise& surprise = frame.session.scenario().surprises[*frame.view.editing.surprise];
  section_title(look, "Upcoming surprise");
  const std::string when =
      surprise.at.move ? "at step " + std::to_string(*surprise.at.move) : "when the robot comes near";
  paragraph(look.fonts.ui, look.theme.text, counted(surprise.cells.size(), "cell") + ", " + when);
  draw_remove_button(frame);
}

ToolKind surprise_tool() {
  return {
      .label = "Drop a surprise",
      .icon = icon::bolt,
      .chord = plain('X'),
      .teach =
          "Obstacles that the robot is not told of: it replans once its sensor sees them. Now, at a step, or "
          "when it comes near.",
      .group = ToolGroup::script,
      .make = make_part<Tool, SurpriseTool>,
      .colour = &Theme::surprise};
}

}  // namespace replan::ui
