#include "core/scene/size_zone.hpp"

#include <algorithm>

namespace replan {

void SizeZone::follow(const Run& run, const RunDigest& digest) {
  if (log_id_ != run.log_id() || grown_.index() == 0)
    begin(run);
  else if (position_ != run.timeline().cursor())
    turn(run, digest);
  log_id_ = run.log_id();
  position_ = run.timeline().cursor();
}

void SizeZone::begin(const Run& run) {
  const std::vector<std::uint8_t> known = run.timeline().state().known_map().plain();
  with_dimensions(run.lattice(), [&](auto d) {
    constexpr int kDimensions = decltype(d)::value;
    const auto& grown = grown_.emplace<Inflation<kDimensions>>(run.lattice().sides<kDimensions>(), known,
                                                               run.scenario().robot.radius);
    cells_ = grown.blocked();
  });
}

void SizeZone::turn(const Run& run, const RunDigest& digest) {
  const auto [first, last] = std::minmax({position_, run.timeline().cursor()});
  const auto place = [events = digest.map_events()](std::size_t position) {
    return std::partition_point(events.begin(), events.end(),
                                [position](const MapEvent& event) { return event.event < position; });
  };
  std::vector<CellEdit> edits;
  for (auto event = place(first); event != place(last); ++event)
    if (event->kind == EventKind::known)
      edits.push_back({event->node, run.timeline().state().known_blocked(event->node)});
  const auto apply = [&](auto& grown) {
    for (const CellEdit& edit : grown.apply(edits, cells_)) cells_[edit.node] = edit.blocked ? 1 : 0;
  };
  if (auto* plane = std::get_if<1>(&grown_)) apply(*plane);
  if (auto* space = std::get_if<2>(&grown_)) apply(*space);
}

}  // namespace replan
