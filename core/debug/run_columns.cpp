#include "core/debug/run_columns.hpp"

#include <algorithm>
#include <array>

#include "core/base/words.hpp"
#include "core/debug/parents.hpp"

namespace replan {
namespace {

/// Points between two looks at the clock.
constexpr std::size_t kColumnSlice = 1024;

/// The points on the path that parents tell, sorted. None where they lead in a circle: planners as printed can.
std::vector<NodeId> points_on_path(const LogView& view, const SearchState& state) {
  if (!keeps_parents(view.info)) return {};
  std::vector<NodeId> path;
  const std::size_t most = point_count(view.info, state);
  for (NodeId at = path_end(view.info, state); at != kNoNode; at = parent_of(view.info, state, at)) {
    if (path.size() > most) return {};
    path.push_back(at);
  }
  if (path.size() < 2) return {};
  std::sort(path.begin(), path.end());
  return path;
}

PointState point_state(const LogView& view, const SearchState& state, NodeId point) {
  if (view.info.values.grows()) return PointState::closed;
  if (state.queued(point)) return PointState::open;
  if (view.info.values.lookahead() && state.g(point) != state.rhs(point)) return PointState::inconsistent;
  return state.times_expanded(point) > 0 ? PointState::closed : PointState::touched;
}

}  // namespace

std::string_view point_state_name(PointState state) {
  static constexpr std::array<std::string_view, kPointStates> kNames = {"touched", "closed", "inconsistent",
                                                                        "open", "on path"};
  return kNames[static_cast<std::size_t>(state)];
}

void ColumnRange::take(double value) {
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

/// One moment, from its first point to its last.
struct ColumnReader::Job {
  Job(const LogView& its_view, SearchState its_state, std::size_t position, const Measure& its_x,
      const Measure& its_y)
      : view(its_view),
        state(std::move(its_state)),
        x(its_x),
        y(its_y),
        x_reader(view, state, x),
        y_reader(view, state, y),
        path(points_on_path(view, state)) {
    columns.position = position;
    columns.nodes = view.lattice.node_count();
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Whether all of the points are read.
  bool read(std::span<const FirstTouch> touches, const Deadline& deadline) {
    count = touches.size();
    if (next == 0) make_room();
    while (next < count) {
      const std::size_t end = std::min(count, next + kColumnSlice);
      for (; next < end; ++next) take(touches[next]);
      if (deadline.passed()) break;
    }
    return next == count;
  }
  /// What grew by doubling would be copied within a frame.
  void make_room() {
    columns.points.reserve(count);
    if (view.info.values.grows()) columns.cells.reserve(count);
    columns.x.reserve(count);
    columns.y.reserve(count);
    columns.states.reserve(count);
  }
  void take(const FirstTouch& touch) {
    const auto at_x = x_reader.read(touch), at_y = y_reader.read(touch);
    if (!at_x || !at_y) {
      ++columns.without;
      return;
    }
    columns.points.push_back(touch.point);
    if (view.info.values.grows())
      columns.cells.push_back(view.lattice.node(cell_of_point(view, state, touch.point)));
    columns.x.push_back(*at_x);
    columns.y.push_back(*at_y);
    const bool on_path = std::binary_search(path.begin(), path.end(), touch.point);
    columns.states.push_back(on_path ? PointState::on_path : point_state(view, state, touch.point));
    columns.x_range.take(*at_x);
    columns.y_range.take(*at_y);
  }

  LogView view;
  SearchState state;
  Measure x, y;
  MeasureReader x_reader, y_reader;
  std::vector<NodeId> path;
  std::size_t next = 0, count = 0;
  RunColumns columns;
};

RunColumns run_columns(const LogView& view, std::size_t position, const Measure& x, const Measure& y) {
  TouchOrder order;
  order.follow(view, 0, position, Deadline::never());
  ColumnReader::Job job(view, view.log.state_at(position), position, x, y);
  job.read(order.points(), Deadline::never());
  return std::move(job.columns);
}

void ColumnReader::follow(const LogView& view, std::uint64_t log_id, const Measure& x, const Measure& y,
                          bool hurry, const Deadline& deadline) {
  const Asked now{log_id, view.log.cursor(), x.id, y.id};
  if (done_ && done_->log_id != log_id) done_.reset();
  const bool other = asked_.log_id != log_id || asked_.x != x.id || asked_.y != y.id;
  if (other || (hurry && now != asked_)) job_.reset();
  late_ = now != shown_ || !done_;
  if (!late_ && !job_) return;
  if (!job_) {
    job_ = std::make_shared<Job>(view, view.log.state(), now.position, x, y);
    asked_ = now;
  }
  order_.follow(view, log_id, asked_.position, deadline);
  if (order_.behind() || !job_->read(order_.points(), deadline)) return;
  job_->columns.log_id = log_id;
  done_ = std::make_shared<const RunColumns>(std::move(job_->columns));
  shown_ = asked_;
  late_ = now != shown_;
  job_.reset();
}

double ColumnReader::progress() const {
  if (!job_ || job_->count == 0) return 0;
  return static_cast<double>(job_->next) / static_cast<double>(job_->count);
}

std::string columns_csv(const LogView& view, const RunColumns& columns, const Measure& x, const Measure& y,
                        const std::optional<PlotBrush>& brush, std::size_t most) {
  const bool grows = view.info.values.grows(), solid = view.lattice.solid();
  std::string csv = grows ? "vertex," : "";
  csv += solid ? "cell_x,cell_y,cell_z," : "cell_x,cell_y,";
  csv += x.id + "," + y.id + ",state\n";
  const auto number = [](const Measure& measure, double value) {
    return measure.whole() ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(value);
  };
  for (std::size_t row = 0; row < columns.points.size() && most > 0; ++row) {
    if (brush && !brush->has(columns.x[row], columns.y[row])) continue;
    --most;
    if (grows) csv += std::to_string(columns.points[row]) + ",";
    for (const int each : coordinates_of(view.lattice.position(columns.cell(row)), solid))
      csv += std::to_string(each) + ",";
    csv += number(x, columns.x[row]) + "," + number(y, columns.y[row]) + ",";
    csv += std::string(point_state_name(columns.states[row])) + "\n";
  }
  return csv;
}

}  // namespace replan
