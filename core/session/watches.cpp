#include "core/session/watches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/deadline.hpp"
#include "core/session/lockstep.hpp"
#include "core/session/run.hpp"
#include "core/world/scenario.hpp"

namespace replan {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// A quantity that cannot be told (infinity less infinity) is none.
double value_of(Probe& probe) {
  const double value = probe.value().number;
  return std::isnan(value) ? kNone : value;
}

}  // namespace

void WatchSeries::add(WatchPoint point) {
  stale_ = true;
  const std::size_t number = point.position / width_;
  if (stretches_.empty() || stretches_.back().number != number) {
    stretches_.push_back({number, point, point, point});
    while (stretches_.size() > kMostPoints / 3) widen();
    return;
  }
  Stretch& stretch = stretches_.back();
  if (point.value < stretch.least.value) stretch.least = point;
  if (point.value > stretch.most.value) stretch.most = point;
  stretch.last = point;
}

/// Joins stretches in twos.
void WatchSeries::widen() {
  width_ *= 2;
  std::vector<Stretch> wider;
  for (const Stretch& each : stretches_) {
    if (wider.empty() || wider.back().number != each.number / 2) {
      wider.push_back({each.number / 2, each.least, each.most, each.last});
      continue;
    }
    Stretch& joined = wider.back();
    if (each.least.value < joined.least.value) joined.least = each.least;
    if (each.most.value > joined.most.value) joined.most = each.most;
    joined.last = each.last;
  }
  stretches_ = std::move(wider);
}

std::size_t WatchSeries::truncate(std::size_t size) {
  stale_ = true;
  while (!stretches_.empty() && stretches_.back().last.position > size) {
    size = std::min(size, stretches_.back().number * width_);
    stretches_.pop_back();
  }
  return size;
}

std::span<const WatchPoint> WatchSeries::points() const {
  if (!stale_) return points_;
  stale_ = false;
  points_.clear();
  for (const Stretch& each : stretches_) {
    WatchPoint first = each.least, second = each.most;
    if (second.position < first.position) std::swap(first, second);
    for (const WatchPoint& point : {first, second, each.last})
      if (points_.empty() || point.position > points_.back().position) points_.push_back(point);
  }
  return points_;
}

std::span<const WatchPoint> Watches::series(std::size_t pane, std::size_t watch) const {
  if (pane >= panes_.size() || watch >= panes_[pane].tracks.size()) return {};
  return panes_[pane].tracks[watch].series.points();
}

double Watches::value(std::size_t pane, std::size_t watch) const {
  return pane < panes_.size() && watch < panes_[pane].tracks.size() ? panes_[pane].tracks[watch].at_cursor
                                                                    : kNone;
}

void Watches::set_list(std::vector<std::string> list, const Box& world) {
  list_ = std::move(list);
  read_again(world);
}

Result<void> Watches::add(const std::string& expression, const Box& world) {
  if (list_.size() >= kMaxWatches)
    return Error{"there are " + std::to_string(kMaxWatches) +
                 " watches already, the most there can be: remove one"};
  Result<Condition> read = parse_quantity(expression, world);
  if (!read) return Error{read.error()};
  if (std::find(read_.begin(), read_.end(), read.value()) != read_.end())
    return Error{"there is a watch of that already"};
  list_.push_back(expression);
  read_.emplace_back(std::move(read.value()));
  problems_.emplace_back();
  for (Pane& pane : panes_) {
    pane.tracks.emplace_back();
    pane.cursor = SIZE_MAX;
  }
  return {};
}

void Watches::remove(std::size_t index) {
  const auto at = static_cast<std::ptrdiff_t>(index);
  list_.erase(list_.begin() + at);
  read_.erase(read_.begin() + at);
  problems_.erase(problems_.begin() + at);
  for (Pane& pane : panes_)
    if (index < pane.tracks.size()) pane.tracks.erase(pane.tracks.begin() + at);
}

void Watches::read_again(const Box& world) {
  read_.clear();
  problems_.clear();
  panes_.clear();
  for (const std::string& expression : list_) {
    Result<Condition> read = parse_quantity(expression, world);
    problems_.push_back(read ? "" : read.error());
    read_.push_back(read ? std::optional(std::move(read.value())) : std::nullopt);
  }
}

/// Keeps as many panes as there are runs, and of each what its log still has.
void Watches::meet(Runs runs) {
  while (panes_.size() > runs.size()) panes_.pop_back();
  while (panes_.size() < runs.size()) panes_.emplace_back();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Pane& pane = panes_[i];
    while (pane.tracks.size() < list_.size()) pane.tracks.emplace_back();
    if (pane.log_id != runs[i]->log_id()) forget(pane, runs[i]->common_with(pane.log_id));
    pane.log_id = runs[i]->log_id();
  }
}

void Watches::forget(Pane& pane, std::size_t common) {
  pane.cursor = SIZE_MAX;
  for (Track& track : pane.tracks) {
    track.probe.reset();
    track.looked = track.series.truncate(std::min(track.looked, common));
    if (track.looked == 0) track.series = {};
  }
}

Probe Watches::probe_at(const Run& run, std::size_t watch, std::size_t position) const {
  const Condition& quantity = *read_[watch];
  const std::int64_t expansions = quantity.counts_expansions() ? expansions_until(run, position) : 0;
  return {run.log_view(), quantity, position, {}, expansions};
}

/// Takes one watch on to `end`. True if its value changed on the way.
bool Watches::look(const Run& run, Pane& pane, std::size_t watch, std::size_t end) {
  Track& track = pane.tracks[watch];
  bool changed = false;
  if (!track.probe) {
    track.probe.emplace(probe_at(run, watch, track.looked));
    track.last = value_of(*track.probe);
    const auto known = track.series.points();
    if (known.empty() || known.back().value != track.last) track.series.add({track.looked, track.last});
    changed = true;
  }
  while (track.probe->next_change(end)) {
    const double value = value_of(*track.probe);
    if (value == track.last) continue;
    track.series.add({track.probe->position(), value});
    track.last = value;
    changed = true;
  }
  track.looked = end;
  return changed;
}

bool Watches::look(Runs runs, double milliseconds) {
  constexpr std::size_t kSlice = 16384;
  meet(runs);
  const Deadline deadline(milliseconds);
  bool changed = false;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < runs.size(); ++i)
      for (std::size_t watch = 0; watch < list_.size(); ++watch) {
        if (!read_[watch]) continue;
        const std::size_t size = runs[i]->timeline().size(), looked = panes_[i].tracks[watch].looked;
        if (looked == size && panes_[i].tracks[watch].probe) continue;
        if (deadline.passed()) return true;
        changed |= look(*runs[i], panes_[i], watch, std::min(size, looked + kSlice));
        more = true;
      }
  }
  return changed;
}

bool Watches::read_cursors(Runs runs) {
  meet(runs);
  bool changed = false;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t cursor = runs[i]->timeline().cursor();
    Pane& pane = panes_[i];
    if (pane.cursor == cursor) continue;
    pane.cursor = cursor;
    changed |= !list_.empty();
    for (std::size_t watch = 0; watch < list_.size(); ++watch) {
      if (!read_[watch]) {
        pane.tracks[watch].at_cursor = kNone;
        continue;
      }
      Probe probe = probe_at(*runs[i], watch, cursor);
      pane.tracks[watch].at_cursor = value_of(probe);
    }
  }
  return changed;
}

}  // namespace replan
