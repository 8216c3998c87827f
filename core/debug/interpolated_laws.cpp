// The laws of searches that interpolate (core/lattice/interpolation.hpp): those of a lookahead, but that a way on may
// lead across a square and is then made of what two neighbours offer. So wherever one's offer has changed all ways on are
// looked at.
#include "core/debug/lookahead_laws.hpp"
#include "core/lattice/interpolation.hpp"

namespace replan {
namespace {

class InterpolatedLaws final : public LookaheadLaws<2> {
  using Laws = LookaheadLaws<2>;

 public:
  using Laws::Laws;

 private:
  [[nodiscard]] Right right_of(NodeId s) const override {
    const Grid2& known = values_.known();
    const WayOn way = best_way_on(known.moves(s), [&](int d) { return values_.at(known.neighbour(s, d)).g; });
    const auto end = [&](std::uint32_t d) {
      return d == WayOn::kNone ? kNoNode : known.neighbour(s, static_cast<int>(d));
    };
    return {way.cost, end(way.to), end(way.and_to)};
  }
  [[nodiscard]] bool of_single_offers() const override { return false; }
  [[nodiscard]] const char* rhs_law() const override {
    return "rhs(s) is the least of all moves and ways across open squares";
  }
  [[nodiscard]] Cost estimate(NodeId a, NodeId b) const override {
    return interpolated_bound(Laws::estimate(a, b));
  }
  [[nodiscard]] Cost estimate_up(NodeId a, NodeId b) const override {
    return interpolated_bound_up(Laws::estimate_up(a, b));
  }
};

}  // namespace

/// Such planners are for the plane alone.
template <int D>
std::unique_ptr<LawBook<D>> make_interpolated_laws(const LogView& view, LawValues<D>& values) {
  if constexpr (D == 2)
    return std::make_unique<InterpolatedLaws>(view, values);
  else
    return std::make_unique<LookaheadLaws<D>>(view, values);
}

template std::unique_ptr<LawBook<2>> make_interpolated_laws(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_interpolated_laws(const LogView&, LawValues<3>&);

}  // namespace replan
