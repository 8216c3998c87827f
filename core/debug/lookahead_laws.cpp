#include "core/debug/lookahead_laws.hpp"

namespace replan {

template <int D>
std::unique_ptr<LawBook<D>> make_lookahead_laws(const LogView& view, LawValues<D>& values) {
  return std::make_unique<LookaheadLaws<D>>(view, values);
}

template std::unique_ptr<LawBook<2>> make_lookahead_laws(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_lookahead_laws(const LogView&, LawValues<3>&);

}  // namespace replan
