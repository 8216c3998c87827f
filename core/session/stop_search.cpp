#include "core/session/stop_search.hpp"

#include <algorithm>

namespace replan {

StopSearch::StopSearch(const LogView& view, std::vector<NumberedCondition> conditions, std::size_t position,
                       const Verdicts& verdicts, std::int64_t expansions_before)
    : position_(position) {
  probes_.reserve(conditions.size());
  for (NumberedCondition& each : conditions)
    probes_.push_back(
        {each.number, Probe(view, std::move(each.condition), position, verdicts, expansions_before)});
}

std::size_t StopSearch::slice() const {
  constexpr std::size_t kEvents = 32768, kFewest = 512;
  return std::max(kFewest, kEvents / std::max<std::size_t>(1, probes_.size()));
}

void StopSearch::forwards(std::size_t end, const Verdicts& verdicts, std::vector<Hit>& hits) {
  const std::size_t before = hits.size();
  for (auto& [number, probe] : probes_) {
    probe.set_verdicts(verdicts);
    while (probe.position() < end)
      if (const auto stop = probe.forwards(end)) hits.push_back({*stop, number});
  }
  std::sort(hits.begin() + static_cast<std::ptrdiff_t>(before), hits.end());
  position_ = std::max(position_, end);
}

std::optional<Hit> StopSearch::backwards(std::size_t begin, const Verdicts& verdicts) {
  std::optional<Hit> last;
  for (auto& [number, probe] : probes_) {
    probe.set_verdicts(verdicts);
    const std::size_t limit = last ? last->position : begin;
    if (const auto stop = probe.backwards(limit); stop && (!last || *stop > last->position))
      last = Hit{*stop, number};
  }
  position_ = last ? last->position : std::min(position_, begin);
  return last;
}

}  // namespace replan
