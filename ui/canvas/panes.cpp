#include "ui/canvas/panes.hpp"

#include <algorithm>

#include "core/base/deadline.hpp"
#include "ui/canvas/pane_grid.hpp"

namespace replan::ui {
namespace {

/// What the panes' pictures may take of a frame before others have to wait for the next one.
constexpr double kScenesMs = 30;

/// Whether a colour of the field says the same in both.
bool field_alike(const Scene& a, const Scene& b) {
  return a.field_words == b.field_words && a.range == b.range;
}

}  // namespace

Canvas& Panes::canvas(std::size_t pane) {
  while (canvases_.size() <= pane) canvases_.push_back(std::make_unique<Canvas>(renderer_));
  return *canvases_[pane];
}

void Panes::fit() {
  for (const auto& each : canvases_) each->fit();
}

void Panes::take_over(const Box& world, ViewState& state) {
  for (const auto& each : canvases_) each->take_over(world, state);
}

bool Panes::animating() const {
  // Others may have been left in the middle of something.
  const auto first = canvases_.begin() + static_cast<std::ptrdiff_t>(first_drawn_);
  return std::any_of(first, first + static_cast<std::ptrdiff_t>(drawn_),
                     [](const auto& each) { return each->animating(); });
}

void Panes::draw(const Look& look, const Session& session, std::size_t most, ViewState& state, ImVec2 min,
                 ImVec2 max, bool interactive, std::vector<Command>& commands) {
  const std::size_t all = session.runs().size();
  const std::size_t count = std::min(all, most > 0 ? most : PaneGrid::room(look, min, max));
  // Too narrow for all: the one that the side panel is about.
  const std::size_t first = count < all ? std::min(session.lead(), all - count) : 0;
  state.hides_panes = state.live && count < all;
  // One pane has the legend over its lower edge; several have it below them.
  const float legend = state.legend ? Legend::height(look) : 0;
  const ImVec2 foot = max;
  if (count > 1) max.y -= legend;
  const PaneGrid grid(look, count, min, max);
  shown_ = std::clamp(session.lead(), first, first + count - 1);
  canvas(first + count - 1);  // there are as many
  first_drawn_ = first;
  drawn_ = count;
  LegendSigns signs;
  bool alike = true;  // the colours mean the same in all panes
  // Where a picture takes long, others may be a frame late, and then come first; else the leading pane does.
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count; ++i) order.push_back((shown_ - first + i) % count);
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t at) { return canvas(first + at).behind(); });
  const Deadline deadline(kScenesMs);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = order[i], pane = first + at;
    const bool may_wait = state.live && i > 0 && deadline.passed();
    canvas(pane).draw(look, session, pane, state, grid.min(at), grid.max(at), interactive, commands,
                      count > 1 ? 0 : legend, may_wait);
    grid.draw_parting(at);
    signs.add(canvas(pane).scene());
    alike = alike && field_alike(canvas(pane).scene(), scene());
    const ScreenArea area{grid.min(at), grid.max(at)};
    if (interactive && area.holds(ImGui::GetIO().MousePos)) pointed_ = pane;
  }
  area_ = {grid.min(shown_ - first), grid.max(shown_ - first)};
  if (!interactive || pointed_ < first || pointed_ >= first + count) pointed_ = shown_;
  const std::string_view of = alike ? std::string_view() : session.runs()[pointed_]->info().name;
  const bool outside = session.runs()[pointed_]->lattice().solid() && state.slices.orbits(pointed_);
  if (state.legend)
    legend_.draw(look, canvas(pointed_).scene(), of, state.colours, signs, outside, min, foot);
}

}  // namespace replan::ui
