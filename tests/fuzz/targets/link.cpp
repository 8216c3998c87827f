#include "core/link/link.hpp"

#include "core/base/base64.hpp"
#include "core/link/deflate.hpp"
#include "tests/fuzz/target.hpp"

namespace {

void look_at(std::string_view input) {
  using namespace replan;
  is_link(input);
  const auto link = parse_link(input);
  fuzz::require_good_error(link, "the link: ");
  if (!link) return;
  fuzz::require(link->view.lead < link->scenario.planners.size(), "the pane is one of the world's");
  fuzz::require(link->scenario.map_file.empty(), "the map comes with the link");
  const Box world = link->scenario.map.box();
  fuzz::require(!link->view.pin || world.contains(*link->view.pin), "the pinned cell is in the world");
  for (const Slice& slice : link->view.slices)
    fuzz::require(sheet_of(world, slice).layer == slice.layer, "the slice is in the world");
  const auto text = link_text(link->scenario, link->view);
  if (!text) return;
  const auto again = parse_link(*text);
  fuzz::require(again.ok(), "what was written is read back: " + (again.ok() ? "" : again.error()));
  fuzz::require(again->scenario == link->scenario, "the scenario is whole");
  fuzz::require(link_text(again->scenario, again->view).value() == *text, "the look is whole");
}

}  // namespace

// A link; or, after a line that is one but for its world, that world as it is before it is packed, which no chance would
// pack rightly.
REPLAN_FUZZ_TARGET(link) {
  const std::size_t line = input.find('\n');
  look_at(input);
  if (line == std::string_view::npos) return;
  look_at(std::string(input.substr(0, line)) + "&world=" + base64url(deflated(input.substr(line + 1))));
}
