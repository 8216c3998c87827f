// Two measures of every point that a search has come to, as columns of numbers: what a scatter plot shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/debug/measures.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

/// What a point is to the search at the moment; of several that hold the last.
enum class PointState : std::uint8_t {
  touched,       ///< a value of it was written
  closed,        ///< it had its turn, or is a vertex of the tree
  inconsistent,  ///< g is not rhs, of a search that has both
  open,          ///< it waits in the open list
  on_path        ///< the path that parents tell at the moment leads over it
};
inline constexpr std::size_t kPointStates = 5;
/// "open"; in files too.
std::string_view point_state_name(PointState state);

/// From the least number of a column to the greatest; empty before there is one.
struct ColumnRange {
  double low = 0, high = 0;
  bool empty = true;
  void take(double value);
};

/// A rectangle of numbers, both ends included.
struct PlotBrush {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
  [[nodiscard]] bool has(double x, double y) const {
    return x >= x_low && x <= x_high && y >= y_low && y <= y_high;
  }
  friend bool operator==(const PlotBrush&, const PlotBrush&) = default;
};

/// One row for each point that has both numbers, in the order in which the search came to them.
struct RunColumns {
  std::size_t position = 0;  ///< of the log
  std::uint64_t log_id = 0;
  std::size_t nodes = 0;       ///< of the world
  std::vector<NodeId> points;  ///< nodes, or vertices of a tree
  std::vector<NodeId> cells;   ///< the nodes that vertices of a tree lie in; else none
  std::vector<double> x, y;
  std::vector<PointState> states;
  ColumnRange x_range, y_range;
  std::size_t without = 0;  ///< points that lack one of the numbers
  /// The node of the cell of a row.
  [[nodiscard]] NodeId cell(std::size_t row) const { return cells.empty() ? points[row] : cells[row]; }
};

/// The columns at a position of the log, all at once.
RunColumns run_columns(const LogView& view, std::size_t position, const Measure& x, const Measure& y);

/// The columns at the cursor of a log, worked out a slice at a time, and each time for one moment: the state of that moment
/// is kept while the cursor moves on.
class ColumnReader {
 public:
  /// Goes on until the deadline. With `hurry` what was begun for another moment is given up for the present one; without, it
  /// is brought to its end first, so that something comes of it while the cursor never rests. `log_id` is another one when the log is
  /// another one, or was cut.
  void follow(const LogView& view, std::uint64_t log_id, const Measure& x, const Measure& y, bool hurry,
              const Deadline& deadline);
  /// The latest that are complete; nullptr before there are any.
  [[nodiscard]] const std::shared_ptr<const RunColumns>& columns() const { return done_; }
  /// Whether these are not those of the cursor.
  [[nodiscard]] bool behind() const { return job_ != nullptr || late_; }
  /// How much of the next ones is there, 0 to 1.
  [[nodiscard]] double progress() const;

 private:
  friend RunColumns run_columns(const LogView& view, std::size_t position, const Measure& x,
                                const Measure& y);
  struct Job;
  struct Asked {
    std::uint64_t log_id = 0;
    std::size_t position = 0;
    std::string x, y;
    friend bool operator==(const Asked&, const Asked&) = default;
  };

  TouchOrder order_;
  std::shared_ptr<Job> job_;
  std::shared_ptr<const RunColumns> done_;
  Asked asked_, shown_;
  bool late_ = false;
};

/// At most `most` rows with a heading: the vertex of a tree, the cell, the two measures, the state. With a brush those in it alone.
std::string columns_csv(const LogView& view, const RunColumns& columns, const Measure& x, const Measure& y,
                        const std::optional<PlotBrush>& brush, std::size_t most);

}  // namespace replan
