// The median of numbers that keep coming: each is taken in logarithmic time, and the median is there at any moment.
#pragma once

#include <cstddef>
#include <vector>

namespace replan {

/// The lower half of the numbers in a heap with its greatest on top, the upper half in one with its least on top; where
/// their count is odd the lower half has one more.
class RunningMedian {
 public:
  void add(double value);
  [[nodiscard]] std::size_t count() const { return lower_.size() + upper_.size(); }
  [[nodiscard]] bool empty() const { return lower_.empty(); }
  /// That of all so far, of which there is one at least: quantile(values, 0.5) to the last bit.
  [[nodiscard]] double median() const;

 private:
  std::vector<double> lower_, upper_;
};

}  // namespace replan
