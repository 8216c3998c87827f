// What has changed on a run's maps since somebody looked last: what is drawn of them is kept up to date by that.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/scene/digest.hpp"

namespace replan {

/// Follows a run's cursor, also where an edit cuts the log and it goes on otherwise.
class MapFollower {
  // Ahead of follow(), which asks for the type that it returns.
  template <class Events>
  static auto place(Events& events, std::size_t position) {
    return std::partition_point(events.begin(), events.end(),
                                [position](const MapEvent& event) { return event.event < position; });
  }

 public:
  /// Calls `visit(event)` for every write to a map that was done or undone since the last call; some may come though both
  /// states are alike there. False if the log is another one, or with `afresh`: then all may have changed, and nothing is
  /// visited.
  template <class Visit>
  bool follow(const Run& run, const RunDigest& digest, bool afresh, Visit&& visit) {
    const std::size_t cursor = run.timeline().cursor(), common = run.common_with(log_id_);
    // A log that has no event yet has none in common with itself.
    const bool another = afresh || (common == 0 && log_id_ != run.log_id());
    if (another) {
      counted_.clear();
      position_ = cursor;
    } else if (log_id_ != run.log_id()) {
      const auto gone = place(counted_, common);
      for (auto event = gone; event != counted_.end(); ++event) visit(*event);
      counted_.erase(gone, counted_.end());
      position_ = std::min(position_, common);
    }
    const auto events = digest.map_events();
    const auto last = place(events, std::max(position_, cursor));
    for (auto event = place(events, std::min(position_, cursor)); event != last; ++event) visit(*event);
    count(events, static_cast<std::size_t>(place(events, cursor) - events.begin()));
    position_ = cursor;
    log_id_ = run.log_id();
    return !another;
  }

 private:
  template <class Events>
  void count(const Events& events, std::size_t size) {
    if (size < counted_.size()) counted_.resize(size);
    counted_.insert(counted_.end(), events.begin() + static_cast<std::ptrdiff_t>(counted_.size()),
                    events.begin() + static_cast<std::ptrdiff_t>(size));
  }

  std::uint64_t log_id_ = 0;
  std::size_t position_ = 0;
  std::vector<MapEvent> counted_;  // before that position: what a cut takes out of the log is looked at anew
};

}  // namespace replan
