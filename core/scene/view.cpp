#include "core/scene/view.hpp"

#include <bit>
#include <vector>

#include "core/plan/parameters.hpp"

namespace replan {
namespace {

constexpr std::uint32_t kFieldBits = (1u << kFieldOverlays) - 1u;

}  // namespace

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
    for (const OverlayInfo& info : overlays())
      if (info.id == id) found = &info;
    if (found == nullptr) {
      std::vector<std::string_view> names;
      for (const OverlayInfo& info : overlays()) names.push_back(info.id);
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
  for (const OverlayInfo& info : overlays())
    if (info.at_first) set.set(info.overlay, true);
  return set;
}

}  // namespace replan
