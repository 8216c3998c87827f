// The laws of values that promise nothing.
#include "core/debug/law_book.hpp"

namespace replan {
namespace {

template <int D>
class NoLaws final : public LawBook<D> {
 public:
  using LawBook<D>::LawBook;
  void step() override {}
  void plan(PlanStatus, std::span<const Hop>) override {}
  void look(NodeId) override {}
};

}  // namespace

template <int D>
std::unique_ptr<LawBook<D>> make_no_laws(const LogView&, LawValues<D>& values) {
  return std::make_unique<NoLaws<D>>(values);
}

template std::unique_ptr<LawBook<2>> make_no_laws(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_no_laws(const LogView&, LawValues<3>&);

}  // namespace replan
