// A moment of a session as an address: what follows # in it holds the world and says what is looked at. docs/links.md
// has the format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/lattice/seen_box.hpp"
#include "core/scene/orbit.hpp"
#include "core/scene/view.hpp"
#include "core/session/lockstep.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// What a link says besides its world. What it does not say is left as it is where it is opened.
struct LinkView {
  std::optional<std::size_t>
      event;  ///< the playhead's position in the leading pane's log; nothing: the first plan
  std::optional<std::uint32_t> log;  ///< LogHash::short_value() of the log up to there
  std::size_t lead = 0;              ///< the pane that leads
  std::optional<Lockstep> lockstep;
  std::optional<OverlaySet> overlays;
  std::optional<bool> dark;                 ///< the theme
  std::string tab;                          ///< the id of the tab at the side; empty: not said
  std::optional<Cell> pin;                  ///< the cell that is pinned
  std::optional<ViewSetup::Camera> camera;  ///< its zoom in design pixels per cell
  std::vector<Slice>
      slices;  ///< of a world of several layers: what each pane shows, the last one for those that follow
  bool follows_robot = false;       ///< the layer is the robot's
  std::optional<Orbit> orbit;       ///< the world from outside, from there
  std::vector<std::size_t> orbits;  ///< in these panes; none named: in all
  bool cut = false, glass = false;  ///< as `render --cut` and `--glass` have it
  friend bool operator==(const LinkView&, const LinkView&) = default;
};

/// A world and a look at it.
struct Link {
  Scenario scenario;  ///< with as many planners as there are panes; its map comes along
  LinkView view;
  std::vector<std::string>
      notes;  ///< what this version does not know of the link and has left out, a sentence each
};

/// How many characters browsers take, and from where on other programs may cut a link off.
inline constexpr std::size_t kLongestLink = 2'000'000, kLongLink = 32'000, kChatLink = 8'000,
                             kShortLink = 2'000;
/// The most cells of a world in a link.
inline constexpr std::int64_t kMaxLinkCells = std::int64_t{1} << 24;

/// The link, from # on: what stands before it is the address of a page. An Error says that the world is too large for
/// one.
Result<std::string> link_text(const Scenario& scenario, const LinkView& view);
/// The scenario as link_text() puts it in and parse_link() reads it: without the file that its map came from.
Scenario linked_scenario(const Scenario& scenario);

/// Whether a text is such a link, or what is left of one; what stands before # does not matter.
bool is_link(std::string_view text);
/// Reads a link. Line ends and blanks that a mail program put into it are passed over. Errors begin with "the link".
Result<Link> parse_link(std::string_view text);

}  // namespace replan
