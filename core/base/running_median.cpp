#include "core/base/running_median.hpp"

#include <algorithm>
#include <functional>

#include "core/base/statistics.hpp"

namespace replan {
namespace {

/// Takes the top of one heap to the other. `From` and `To` are their orders.
template <class From, class To>
void move_top(std::vector<double>& from, std::vector<double>& to) {
  std::pop_heap(from.begin(), from.end(), From());
  to.push_back(from.back());
  from.pop_back();
  std::push_heap(to.begin(), to.end(), To());
}

}  // namespace

void RunningMedian::add(double value) {
  using Greatest = std::less<>;
  using Least = std::greater<>;
  if (empty() || value <= lower_.front()) {
    lower_.push_back(value);
    std::push_heap(lower_.begin(), lower_.end(), Greatest());
  } else {
    upper_.push_back(value);
    std::push_heap(upper_.begin(), upper_.end(), Least());
  }
  if (lower_.size() > upper_.size() + 1) move_top<Greatest, Least>(lower_, upper_);
  if (lower_.size() < upper_.size()) move_top<Least, Greatest>(upper_, lower_);
}

double RunningMedian::median() const {
  if (lower_.size() > upper_.size()) return lower_.front();
  const double middle[] = {lower_.front(), upper_.front()};
  return quantile(middle, 0.5);
}

}  // namespace replan
