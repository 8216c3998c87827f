#include "core/debug/plot_bins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace replan {
namespace {

/// Rows between two looks at the clock.
constexpr std::size_t kPaintSlice = 8192;

/// The bin of a place on an axis; -1 off the plot.
int bin_at(double place, int count) {
  if (!(place >= 0 && place <= 1)) return -1;
  return std::min(static_cast<int>(place * count), count - 1);
}

}  // namespace

double least_positive(const std::vector<double>& column) {
  double least = std::numeric_limits<double>::infinity();
  for (const double value : column)
    if (value > 0) least = std::min(least, value);
  return std::isinf(least) ? 1 : least;
}

PlotAxis PlotAxis::over(const ColumnRange& range, double least_positive, bool logarithmic) {
  PlotAxis axis{range.low, range.high, logarithmic};
  if (logarithmic) axis.low = range.low > 0 ? range.low : least_positive;
  if (range.empty || axis.high < axis.low) axis.high = axis.low;
  if (axis.high > axis.low) return axis;
  // One number alone stands in the middle.
  axis.high = logarithmic ? axis.low * 2 : axis.low + 1;
  axis.low = logarithmic ? axis.low / 2 : axis.low - 1;
  return axis;
}

double PlotAxis::place(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  if (value <= 0) return std::numeric_limits<double>::quiet_NaN();
  return std::log(value / low) / std::log(high / low);
}

double PlotAxis::value(double place) const {
  return logarithmic ? low * std::pow(high / low, place) : low + place * (high - low);
}

void PlotPainter::begin(const PlotAsked& asked) {
  asked_ = asked;
  row_ = 0;
  next_ = std::make_shared<PlotPicture>();
  next_->columns = asked.columns;
  const RunColumns& columns = *asked.columns;
  next_->x = PlotAxis::over(columns.x_range, asked.x_logarithmic ? least_positive(columns.x) : 1,
                            asked.x_logarithmic);
  next_->y = PlotAxis::over(columns.y_range, asked.y_logarithmic ? least_positive(columns.y) : 1,
                            asked.y_logarithmic);
  next_->width = std::max(asked.width, 1);
  next_->height = std::max(asked.height, 1);
  next_->bins.assign(static_cast<std::size_t>(next_->width) * static_cast<std::size_t>(next_->height), {});
  next_->brush = asked.brush;
  cells_ = asked.brush ? std::make_shared<CellSet>(columns.nodes, columns.log_id) : nullptr;
}

void PlotPainter::take(std::size_t row) {
  const RunColumns& columns = *asked_.columns;
  const double x = columns.x[row], y = columns.y[row];
  const int column = bin_at(next_->x.place(x), next_->width), line = bin_at(next_->y.place(y), next_->height);
  if (column < 0 || line < 0) return;
  PlotBin& bin = next_->bins[static_cast<std::size_t>(line) * static_cast<std::size_t>(next_->width) +
                             static_cast<std::size_t>(column)];
  if (bin.count == 0 || columns.states[row] > bin.state) {
    bin.state = columns.states[row];
    bin.first = static_cast<std::uint32_t>(row);
  }
  next_->most = std::max(next_->most, ++bin.count);
  ++next_->shown;
  if (!cells_ || !asked_.brush->has(x, y)) return;
  cells_->add(columns.cell(row));
  ++next_->brushed_points;
  next_->brushed_x.take(x);
  next_->brushed_y.take(y);
}

void PlotPainter::follow(const PlotAsked& asked, const Deadline& deadline) {
  if (!asked.columns) {
    *this = {};
    return;
  }
  behind_ = !done_ || !(asked == shown_);
  if (!behind_ && !next_) return;
  if (!next_) begin(asked);
  const std::size_t rows = asked_.columns->points.size();
  while (row_ < rows) {
    const std::size_t end = std::min(rows, row_ + kPaintSlice);
    for (; row_ < end; ++row_) take(row_);
    if (deadline.passed()) break;
  }
  if (row_ < rows) return;
  next_->brushed = std::move(cells_);
  done_ = std::move(next_);
  shown_ = asked_;
  behind_ = !(asked == shown_);
}

}  // namespace replan
