#include "ui/canvas/cell_words.hpp"

#include "core/debug/offers.hpp"

namespace replan::ui {

std::string cell_words(const Run& run, Cell cell) {
  const SearchState& state = run.timeline().state();
  const NodeId node = run.lattice().node(cell);
  const bool truth = state.truly_blocked(node), known = state.known_blocked(node);
  const std::string what = truth                                   ? "obstacle"
                           : too_near(run.log_view(), state, node) ? "free, but too near"
                                                                   : "free";
  if (truth == known) return what + " · known";
  return what + (truth ? " · not seen yet" : " · believed blocked");
}

}  // namespace replan::ui
