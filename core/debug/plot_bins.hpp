// A scatter plot as it is drawn and asked: points in bins of its picture, and those in a rectangle that was drawn in it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/debug/cell_set.hpp"
#include "core/debug/run_columns.hpp"

namespace replan {

/// One axis: what its ends stand for.
struct PlotAxis {
  double low = 0, high = 1;
  bool logarithmic = false;
  /// That shows a column whole. A logarithmic one begins at the least number above 0 and leaves out what lies below.
  static PlotAxis over(const ColumnRange& range, double least_positive, bool logarithmic);
  /// Where a number stands, 0 at the low end to 1; outside of them, and NaN where a logarithm has none, it is not on the
  /// plot.
  [[nodiscard]] double place(double value) const;
  /// The number that stands there.
  [[nodiscard]] double value(double place) const;
  friend bool operator==(const PlotAxis&, const PlotAxis&) = default;
};
/// The least number above 0; 1 if there is none.
double least_positive(const std::vector<double>& column);

/// Points that stand on the same square of the picture.
struct PlotBin {
  std::uint32_t count = 0;
  std::uint32_t first = 0;  ///< the row of one of them, of its most telling state
  PointState state{};       ///< the most telling of theirs
};

struct PlotPicture {
  std::shared_ptr<const RunColumns> columns;
  PlotAxis x, y;
  int width = 0, height = 0;  ///< bins
  std::vector<PlotBin> bins;  ///< row by row, the first row at the bottom
  std::size_t shown = 0;      ///< points in some bin
  std::uint32_t most = 0;     ///< in one bin
  std::optional<PlotBrush> brush;
  std::shared_ptr<const CellSet> brushed;  ///< the cells of the points in the brush; nullptr without one
  std::size_t brushed_points = 0;
  ColumnRange brushed_x, brushed_y;
};

/// What is asked of a picture.
struct PlotAsked {
  std::shared_ptr<const RunColumns> columns;
  bool x_logarithmic = false, y_logarithmic = false;
  int width = 1, height = 1;  ///< bins
  std::optional<PlotBrush> brush;
  friend bool operator==(const PlotAsked&, const PlotAsked&) = default;
};

/// Makes pictures a slice at a time. One that was begun is brought to its end before the next is.
class PlotPainter {
 public:
  void follow(const PlotAsked& asked, const Deadline& deadline);
  /// The latest that is complete; nullptr before there is one.
  [[nodiscard]] const std::shared_ptr<const PlotPicture>& picture() const { return done_; }
  /// Whether it is not what was asked for last.
  [[nodiscard]] bool behind() const { return behind_; }

 private:
  void begin(const PlotAsked& asked);
  void take(std::size_t row);

  PlotAsked asked_, shown_;  // of the one in the making, and of the latest
  std::shared_ptr<PlotPicture> next_;
  std::shared_ptr<CellSet> cells_;
  std::size_t row_ = 0;
  std::shared_ptr<const PlotPicture> done_;
  bool behind_ = false;
};

}  // namespace replan
