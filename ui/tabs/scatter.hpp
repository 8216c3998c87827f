// The scatter plot of a run: two numbers of every cell that its search has come to, against each other.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/debug/plot_bins.hpp"
#include "ui/shell/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// Before there are any: what will be points here, and how to come by the first.
std::string no_points_words(const PlannerInfo& planner);

class ScatterView {
 public:
  void draw(Frame& frame);
  /// The numbers of the run as shown, with a heading, to the clipboard; those in the rectangle alone, if there is one.
  void copy(const Run& run, PanelState& panels) const;
  /// Whether it has numbers of that run.
  [[nodiscard]] bool has_points(const Run& run) const;

  // By the measures' ids. What the planner does not have is another one until it has.
  void choose(std::string x, std::string y);
  [[nodiscard]] const std::optional<PlotBrush>& brush() const { return brush_; }
  void set_brush(std::optional<PlotBrush> brush) { brush_ = std::move(brush); }
  /// As drawn last; nullptr before that.
  [[nodiscard]] const std::shared_ptr<const PlotPicture>& picture() const { return painter_.picture(); }
  /// Where in the window that was.
  [[nodiscard]] const ScreenArea& plot() const { return plot_; }

 private:
  struct Axis {
    std::string id;
    bool logarithmic = false;
  };

  /// The rows of a cell, kept until it or the columns are others.
  struct Rows {
    std::shared_ptr<const RunColumns> columns;
    NodeId cell = kNoNode;
    std::vector<std::size_t> rows;
  };
  [[nodiscard]] static const std::vector<std::size_t>& rows_of(Rows& kept, const PlotPicture& picture,
                                                               NodeId cell);

  void follow(Frame& frame);
  void choose_axes(Frame& frame);
  void axis_row(const Look& look, const char* name, const char* id, Axis& axis);
  [[nodiscard]] const Measure& measure(const Axis& axis) const;
  void draw_plot(Frame& frame, const PlotPicture& picture);
  void take_mouse(Frame& frame, const PlotPicture& picture);
  void take_keys(Frame& frame, const PlotPicture& picture, int steps);
  void draw_brush(const Look& look, const PlotPicture& picture) const;
  void draw_marks(Frame& frame, const PlotPicture& picture);
  void tell(const Frame& frame, const PlotPicture& picture) const;
  void tell_brush(Frame& frame, const PlotPicture& picture);
  void mark_cells(Frame& frame, const PlotPicture& picture) const;

  std::vector<Measure> measures_;
  const PlannerInfo* planner_ = nullptr;  // that they are of
  Axis x_{"event"}, y_{"g"};
  ColumnReader reader_;
  PlotPainter painter_;
  ScreenArea plot_{};
  std::optional<PlotBrush> brush_;
  std::optional<ImVec2> pressed_;  // where a drag began
  Rows pinned_rows_, hovered_rows_;
};

}  // namespace replan::ui
