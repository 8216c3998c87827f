#include <algorithm>

#include "core/debug/event_words.hpp"
#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// From so many design pixels a cell on its corners can be told apart, and its numbers be read.
constexpr double kSeeFrom = 8, kSeeTo = 11, kReadFrom = 20, kReadTo = 24;

/// What waits for the search, near enough to see: the cells of the open list, and nearer both numbers where g and rhs
/// differ.
class WaitingCells final : public CellMark {
 public:
  WaitingCells(SceneContext& context, double seen)
      : context_(context),
        seen_(seen),
        strength_(context.grown(kReadFrom, kReadTo)),
        // From there on the numbers have all four corners of the cell.
        numbers_(strength_ * (context.has(Overlay::numbers) ? 1 - context.grown(68, 76) : 1)) {}

  /// Planners without an rhs leave its pages untouched.
  bool turn_to(NodeId first) override {
    queue_ = context_.state.page(EventKind::queue, first);
    rhs_ = context_.state.page(EventKind::rhs, first);
    return queue_ != nullptr || rhs_ != nullptr;
  }

  void add(Cell cell, NodeId node) override {
    const std::size_t at = node % SearchState::kPage;
    const bool differs = rhs_ != nullptr && context_.state.g(node) != context_.state.rhs(node);
    if (differs && strength_ > 0) add_values(cell, node);
    if (queue_ == nullptr || queue_[at] == 0 || context_.has(Overlay::queue)) return;
    context_.scene.show(Sign::queue);
    mark_cell(context_, cell, OutlineShape::corners, context_.palette.accent, seen_, context_.pixels(1.6),
              context_.pixels(1));
  }

 private:
  void add_values(Cell cell, NodeId node) {
    const auto x = static_cast<double>(cell.x), y = static_cast<double>(cell.y);
    const double inset = context_.world(2);
    context_.scene.show(Sign::two_values);
    // What is blocked, as a repair finds it, is still to be seen.
    const double ground = context_.state.known_blocked(node) ? 0.5 : 0.85;
    context_.add(Outline{x + inset, y + inset, 1 - 2 * inset, 1 - 2 * inset, OutlineShape::filled,
                         faded(context_.palette.background, ground * strength_), 0, 0});
    if (numbers_ <= 0) return;
    context_.scene.numbers = NumbersShown::two;
    const double apart = context_.world(5.5);
    const auto value = [&](double dy, Colour colour, Cost cost) {
      context_.add(Label{{x + 0.5, y + 0.5 + dy}, Anchor::middle, faded(colour, numbers_), text(cost)});
    };
    value(-apart, context_.palette.text, context_.state.g(node));
    value(apart, context_.palette.rhs, context_.state.rhs(node));
  }

  /// With a decimal where the cell has room for it.
  [[nodiscard]] std::string text(Cost cost) const {
    const bool narrow = context_.zoom / context_.view.scale < 34 && cost.to_double() >= 100;
    return cost_text(cost, narrow ? 0 : 1);
  }

  SceneContext& context_;
  double seen_, strength_, numbers_;
  const std::uint64_t* queue_ = nullptr;
  const std::uint64_t* rhs_ = nullptr;
};

std::unique_ptr<CellMark> waiting_cells(SceneContext& context) {
  const double seen = context.grown(kSeeFrom, kSeeTo);
  return seen > 0 ? std::make_unique<WaitingCells>(context, seen) : nullptr;
}

}  // namespace

OverlayKind overlay_waiting() {
  return {.info = {.label = "waiting cells",
                   .help = "Near enough to see: the cells of the open list with corners, and nearer g above "
                           "rhs where the two "
                           "differ, so that the search still has to deal with the cell.",
                   .at_first = true},
          .layer = Layer::frames,
          .each = waiting_cells};
}

}  // namespace replan
