#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/base64.hpp"
#include "core/base/words.hpp"
#include "core/export/case_text.hpp"
#include "core/link/deflate.hpp"
#include "core/link/link.hpp"
#include "core/link/link_limits.hpp"
#include "core/link/link_words.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

/// With three decimals, which nobody sees any more of.
std::string rounded_text(double value) {
  return plain_number(std::round(value * 1000) / 1000).dump();
}

std::string degrees_text(double radians) {
  return rounded_text(radians * 180 / std::numbers::pi);
}

std::string hash_digits(std::uint32_t hash) {
  std::string text(8, '0');
  for (std::size_t i = text.size(); i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 15];
  return text;
}

/// "a,b,c" of what `word` makes of each.
template <class Values, class Word>
std::string comma_list(const Values& values, const Word& word) {
  std::string list;
  for (const auto& value : values) list += (list.empty() ? "" : ",") + word(value);
  return list;
}

std::string slices_text(const std::vector<Slice>& slices) {
  return comma_list(slices, [](const Slice& slice) {
    return "xyz"[static_cast<std::size_t>(slice.along)] + std::to_string(slice.layer);
  });
}

std::string orbit_text(const Orbit& orbit) {
  std::string text = degrees_text(orbit.yaw) + "," + degrees_text(orbit.pitch);
  if (orbit.distance > 0)
    for (const double part : {orbit.distance, orbit.focus.x, orbit.focus.y, orbit.focus.z})
      text += "," + rounded_text(part);
  return text;
}

std::string overlays_text(const OverlaySet& set) {
  std::string list;
  for (const OverlayInfo& info : overlays())
    if (set.has(info.overlay)) list += (list.empty() ? "" : ",") + std::string(info.id);
  return list;
}

/// Puts keys and values together.
class LinkWriter {
 public:
  void add(std::string_view key, const std::string& value) {
    text_ += (text_.empty() ? "#" : "&") + std::string(key) + "=" + value;
  }
  std::string text_;
};

void add_moment(LinkWriter& link, const LinkView& view) {
  if (view.event) link.add(link_key::at, std::to_string(*view.event));
  if (view.log) link.add(link_key::log, hash_digits(*view.log));
  if (view.lead > 0) link.add(link_key::lead, std::to_string(view.lead + 1));
  if (view.lockstep)
    link.add(link_key::lockstep, std::string(lockstep_names()[static_cast<std::size_t>(*view.lockstep)]));
}

void add_look(LinkWriter& link, const LinkView& view, bool solid) {
  if (view.dark) link.add(link_key::theme, *view.dark ? "dark" : "light");
  if (view.overlays) link.add(link_key::overlays, overlays_text(*view.overlays));
  if (!view.tab.empty()) link.add(link_key::tab, view.tab);
  if (view.pin)
    link.add(link_key::pin,
             comma_list(coordinates_of(*view.pin, solid), [](int each) { return std::to_string(each); }));
  if (view.camera)
    link.add(link_key::camera, rounded_text(view.camera->x) + "," + rounded_text(view.camera->y) + "," +
                                   rounded_text(view.camera->zoom));
  if (view.follows_robot)
    link.add(link_key::slice, "robot");
  else if (!view.slices.empty())
    link.add(link_key::slice, slices_text(view.slices));
  if (view.orbit) link.add(link_key::orbit, orbit_text(*view.orbit));
  if (!view.orbits.empty())
    link.add(link_key::orbits,
             comma_list(view.orbits, [](std::size_t pane) { return std::to_string(pane + 1); }));
  if (view.cut || view.glass)
    link.add(link_key::solid, std::string(view.cut ? "cut" : "") + (view.cut && view.glass ? "," : "") +
                                  (view.glass ? "glass" : ""));
}

Error too_large(const std::string& what) {
  return {what + ": save the world as a file instead"};
}

}  // namespace

Scenario linked_scenario(const Scenario& scenario) {
  Scenario held = scenario;
  held.map_file.clear();
  held.map_reading = {};
  held.map_found = {};
  return held;
}

Result<std::string> link_text(const Scenario& scenario, const LinkView& view) {
  if (static_cast<std::int64_t>(scenario.map.blocked.size()) > kMaxLinkCells)
    return too_large("the world has " + std::to_string(scenario.map.blocked.size()) +
                     " cells, and a link holds at most " + std::to_string(kMaxLinkCells));
  const std::string world = case_scenario(scenario);
  if (world.size() > kMostWorldBytes || json_values_at_most(world) > kMostWorldValues)
    return too_large("so much happens in this world that its text is too long for a link");
  LinkWriter link;
  link.add(link_key::version, std::to_string(kLinkVersion));
  add_moment(link, view);
  link.add(link_key::panes, std::to_string(scenario.planners.size()));
  add_look(link, view, scenario.map.box().solid());
  link.add(link_key::world, base64url(deflated(world)));  // last: what can be read stands before it
  if (link.text_.size() > kLongestLink)
    return too_large("the link would have " + std::to_string(link.text_.size()) +
                     " characters, and browsers take " + std::to_string(kLongestLink));
  return std::move(link.text_);
}

}  // namespace replan
