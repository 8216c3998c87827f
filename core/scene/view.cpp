#include "core/scene/view.hpp"

#include <array>
#include <bit>
#include <vector>

#include "core/plan/parameters.hpp"

namespace replan {
namespace {

constexpr std::array<OverlayInfo, static_cast<std::size_t>(Overlay::count)> kOverlays = {{
    {Overlay::g, "g", "g", "The cost to the goal that the search has settled (A*: from the start)."},
    {Overlay::rhs, "rhs", "rhs", "One step of lookahead: the best neighbour's g plus the way to it."},
    {Overlay::dist, "dist", "dist", "The penalty that a cell costs for lying near an obstacle."},
    {Overlay::key, "key", "key",
     "The first key component of the cells in the open list: the smallest comes next."},
    {Overlay::order, "order", "expansion order",
     "When each cell was last expanded: the wave that the search ran in."},
    {Overlay::times, "times", "times expanded",
     "How often each cell was expanded; a repair expands some again."},
    {Overlay::consistency, "consistency", "consistency",
     "Cells whose g and rhs differ: over (g > rhs) can be settled, under (g < rhs) must be raised first."},
    {Overlay::queue, "queue", "open list", "The cells that wait in the open list."},
    {Overlay::repair, "repair", "last repair", "The cells that the last replans touched; older ones fade."},
    {Overlay::numbers, "numbers", "numbers",
     "g, rhs, key and dist inside the cells, from a readable zoom on."},
    {Overlay::lp, "lp", "lp", "Local parents: the neighbour that each cell's rhs comes from."},
    {Overlay::rp, "rp", "rp", "Remote parents: the vertex in sight that the path goes to straight."},
    {Overlay::path, "path", "path", "The path that stands."},
    {Overlay::trail, "trail", "trail", "The way that the robot has driven."},
    {Overlay::sensor, "sensor", "sensor", "How far the robot senses."},
    {Overlay::unknown, "unknown", "unknown",
     "Obstacles that the robot does not know yet, and those that are gone."},
    {Overlay::sight, "sight", "sight",
     "The sight checks of the current expansion: free, or stopped by an obstacle."},
    {Overlay::script, "script", "what is to come",
     "Surprises that have not happened yet, with what sets them off, and the ways of moving obstacles."},
    {Overlay::grid, "grid", "grid", "Lines between the cells."},
}};

constexpr std::uint32_t kFieldBits = (1u << kFieldOverlays) - 1u;

}  // namespace

std::span<const OverlayInfo> overlays() {
  return kOverlays;
}

void OverlaySet::set(Overlay overlay, bool on) {
  const std::uint32_t bit = 1u << static_cast<unsigned>(overlay);
  if (on && (bit & kFieldBits) != 0) bits_ &= ~kFieldBits;
  bits_ = on ? bits_ | bit : bits_ & ~bit;
}

std::optional<Overlay> OverlaySet::field() const {
  const std::uint32_t fields = bits_ & kFieldBits;
  if (fields == 0) return std::nullopt;
  return static_cast<Overlay>(std::countr_zero(fields));
}

Result<OverlaySet> parse_overlays(std::span<const std::string> ids) {
  OverlaySet set;
  for (const std::string& id : ids) {
    const OverlayInfo* found = nullptr;
    for (const OverlayInfo& info : kOverlays)
      if (info.id == id) found = &info;
    if (found == nullptr) {
      std::vector<std::string_view> names;
      for (const OverlayInfo& info : kOverlays) names.push_back(info.id);
      const std::string_view nearest = nearest_name(id, names);
      std::string message = "there is no overlay '" + id + "'";
      if (!nearest.empty()) message += "; did you mean '" + std::string(nearest) + "'?";
      return Error{message};
    }
    set.set(found->overlay, true);
  }
  return set;
}

OverlaySet default_overlays() {
  OverlaySet set;
  for (const Overlay overlay :
       {Overlay::g, Overlay::lp, Overlay::rp, Overlay::path, Overlay::trail, Overlay::sensor, Overlay::repair,
        Overlay::unknown, Overlay::script, Overlay::grid})
    set.set(overlay, true);
  return set;
}

}  // namespace replan
