#include "ui/shell/links.hpp"

#include <algorithm>

#include "ui/tabs/tab.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kMostSlices = 4;  // as many as there are panes

/// What each pane shows of a world of several layers.
void add_slices(LinkView& link, const Session& session, const ViewState& view) {
  const std::size_t panes = std::min(session.runs().size(), kMostSlices);
  const Box box = session.run().lattice();
  for (std::size_t pane = 0; pane < panes; ++pane) {
    const Sheet sheet = sheet_of(box, view.slices.of(pane));  // of a layer that there is
    link.slices.push_back({sheet.box.along(), sheet.layer});
    if (view.slices.orbits(pane)) link.orbits.push_back(pane);
  }
  while (link.slices.size() > 1 && link.slices.back() == link.slices[link.slices.size() - 2])
    link.slices.pop_back();
  link.follows_robot = view.slices.follows_robot;
  if (link.orbits.empty()) return;
  link.orbit = view.orbit;
  if (link.orbits.size() == panes) link.orbits.clear();
  link.cut = view.solid.cut;
  link.glass = view.solid.see_through;
}

}  // namespace

LinkView link_view(const Session& session, const ViewState& view) {
  LinkView link;
  link.event = session.run().timeline().cursor();
  link.lead = session.lead();
  if (session.runs().size() > 1) link.lockstep = session.lockstep();
  link.overlays = view.view.overlays;
  link.dark = view.dark;
  link.tab = tab_kinds()[tab_number(view.tab)].id;
  link.pin = view.view.pinned;
  if (const Camera& camera = view.view.camera; camera.zoom > 0)
    link.camera = ViewSetup::Camera{camera.x, camera.y, camera.zoom / view.view.scale};
  if (session.run().lattice().solid()) add_slices(link, session, view);
  return link;
}

Scenario link_world(const Session& session) {
  Scenario world = session.scenario();
  world.debug = session.debug();
  return world;
}

void show_link(const LinkView& link, ViewState& view) {
  if (link.overlays) view.view.overlays = *link.overlays;
  if (link.dark && !view.live) view.dark = *link.dark;
  const auto kinds = tab_kinds();
  if (std::any_of(kinds.begin(), kinds.end(), [&](const TabKind& kind) { return kind.id == link.tab; }))
    view.tab = link.tab;
  if (link.pin) view.view.pinned = link.pin;
  if (link.camera) view.view.camera = {link.camera->x, link.camera->y, link.camera->zoom * view.view.scale};
  show_link_layers(link, view);
}

void show_link_layers(const LinkView& link, ViewState& view) {
  if (!link.slices.empty()) view.slices.set_all(link.slices.back());
  for (std::size_t pane = 0; pane < link.slices.size(); ++pane)
    view.slices.set(pane, link.slices[pane], SlicePanes::alone);
  view.slices.follows_robot = link.follows_robot;
  for (std::size_t pane = 0; pane < kMostSlices; ++pane) {
    const bool named = std::find(link.orbits.begin(), link.orbits.end(), pane) != link.orbits.end();
    view.slices.set_orbits(pane, link.orbit && (link.orbits.empty() || named));
  }
  if (!link.orbit) return;
  view.orbit = *link.orbit;
  view.solid.cut = link.cut;
  view.solid.see_through = link.glass;
}

LinkCopy::LinkCopy(const Session& session, LinkView view, const WorkPlace& place)
    : view_(std::move(view)),
      hash_(view_.event.value_or(0)),
      log_(session.run().log_id()),
      world_(std::make_shared<const Scenario>(link_world(session))),
      text_(place) {}

std::optional<Result<std::string>> LinkCopy::go_on(const Session& session, const Deadline& deadline) {
  if (packing_) return text_.take();
  const Run& run = session.run();
  if (run.log_id() != log_)
    return Error{"the run was changed while its link was made: ask for the link again"};
  if (!hash_.advance(run.timeline(), deadline)) return std::nullopt;
  view_.log = hash_.short_value();
  packing_ = true;
  text_.start([world = world_, view = view_](const StopToken&) { return link_text(*world, view); });
  return text_.take();
}

Result<std::string> link_here(const Session& session, const ViewState& view) {
  LinkView link = link_view(session, view);
  LogHash hash(link.event.value_or(0));
  hash.advance(session.run().timeline(), Deadline::never());
  link.log = hash.short_value();
  return link_text(link_world(session), link);
}

}  // namespace replan::ui
