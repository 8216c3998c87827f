#include "core/scene/numbers.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/debug/event_words.hpp"
#include "core/scene/cell_mark.hpp"

namespace replan {
namespace {

/// From so many design pixels a cell on, the numbers of cells that wait can be read, those of all cells, and four in the
/// corners.
constexpr double kWaitingFrom = 26, kAllFrom = kNumbersFrom, kFourFrom = 72;
/// Design pixels between a cell's edge and its numbers: the corners of the open list are there.
constexpr double kInset = 6;
/// From here on there is room for larger ones.
constexpr double kLargeFrom = 92;

/// With a decimal where there is room for it, in design pixels.
std::string number_text(Cost cost, double room) {
  std::string text = cost_text(cost, 1);
  if (cost.is_infinite() || static_cast<double>(text.size()) * kDigitWidth <= room) return text;
  return cost_text(cost, 0);
}

/// The second key component of a cell in the open list, as the planner has declared it.
Cost second_key(const SceneContext& context, NodeId node) {
  const ListOrder& order = context.run.info().values.order;
  const auto read = [&](EventKind kind) {
    return Cost{static_cast<std::int64_t>(context.state.value(kind, node))};
  };
  return order.of(context.state.k1(node), read(order.reads[0]), read(order.reads[1]));
}

class CellNumbers final : public CellMark {
 public:
  explicit CellNumbers(SceneContext& context)
      : context_(context),
        layout_(context),
        lookahead_(context.run.info().values.lookahead()),
        raises_(lookahead_ || context.run.info().values.waves),
        two_keys_(!context.run.info().values.order.second.empty()),
        side_(context.zoom / context.view.scale) {}

  [[nodiscard]] bool wants_cells() const override { return layout_.waiting != NumbersShown::none; }
  /// Where nothing was ever written, there are no numbers.
  bool turn_to(NodeId first) override {
    const SearchState& state = context_.state;
    return state.touched(EventKind::g, first) || state.touched(EventKind::rhs, first) ||
           state.touched(EventKind::queue, first) || state.touched(EventKind::dist, first);
  }

  void add(Cell cell, NodeId node) override {
    const bool waiting = waits(context_, node);
    // An obstacle has numbers where the search has settled it before.
    if (context_.state.known_blocked(node) && !waiting && !taken_back(node)) return;
    const NumbersShown shown = layout_.of(waiting);
    if (shown == NumbersShown::none) return;
    ground_ = ground_of(cell, waiting);
    rhs_colour_ = waiting ? context_.palette.rhs : context_.palette.text;
    if (shown == NumbersShown::four)
      add_corners(cell, node);
    else
      add_lines(cell, node);
  }

 private:
  /// Whether the search has made a value infinite again that it had settled: ∞ is what is to be seen.
  [[nodiscard]] bool taken_back(NodeId node) const {
    return raises_ && context_.state.order(node) != 0 && context_.state.g(node).is_infinite();
  }
  /// The cell's colour in the raster, with what marks lay over it.
  [[nodiscard]] Colour ground_of(Cell cell, bool waiting) const {
    const Raster& raster = context_.scene.raster;
    const auto column = static_cast<std::size_t>(cell.x - context_.left),
               row = static_cast<std::size_t>(cell.y - context_.top);
    Colour colour = raster.texels[row * static_cast<std::size_t>(raster.columns) + column];
    if (waiting && context_.has(Overlay::waiting))
      colour = mix(colour, context_.palette.background, kWaitingGround);
    if (context_.written != cell) return colour;
    return mix(colour, context_.palette.accent, static_cast<float>(SceneContext::kTint));
  }

  /// The colour if it can be read on the cell's, else whichever of the strongest two can.
  [[nodiscard]] Colour readable(Colour colour) const {
    constexpr double kEnough = 4.5;
    const Palette& palette = context_.palette;
    if (contrast(colour, ground_) >= kEnough) return colour;
    return contrast(palette.text, ground_) >= contrast(palette.outline, ground_) ? palette.text
                                                                                 : palette.outline;
  }

  void write(NumberMask what, Point at, Anchor anchor, Colour colour, Cost cost, double room) {
    context_.scene.written |= what;
    context_.add(Label{at, anchor, readable(colour), number_text(cost, room), ground_, side_ >= kLargeFrom});
  }

  /// Whether the search has given the cell a value, or had: g = infinity is a number only then.
  [[nodiscard]] bool has_values(NodeId node) const {
    const SearchState& state = context_.state;
    return !state.g(node).is_infinite() || (lookahead_ && !state.rhs(node).is_infinite()) || taken_back(node);
  }

  /// g above rhs; g alone where the planner has no rhs.
  void add_lines(Cell cell, NodeId node) {
    if (!has_values(node)) return;
    const SearchState& state = context_.state;
    const Cost g = state.g(node), rhs = state.rhs(node);
    const double room = side_ - kInset, x = cell.x + 0.5, y = cell.y + 0.5;
    show(lookahead_ ? NumbersShown::two : NumbersShown::one);
    const bool alone = !lookahead_ && layout_.close;
    write(kNumberG, {x, y - (alone ? 0 : layout_.apart)}, Anchor::middle, context_.palette.text, g, room);
    if (lookahead_) write(kNumberRhs, {x, y + layout_.apart}, Anchor::middle, rhs_colour_, rhs, room);
  }

  void add_corners(Cell cell, NodeId node) {
    const SearchState& state = context_.state;
    const double inset = context_.world(kInset), room = side_ / 2 - kInset;
    const double x0 = cell.x + inset, y0 = cell.y + inset, x1 = cell.x + 1 - inset, y1 = cell.y + 1 - inset;
    const Colour strong = context_.palette.text, soft = context_.palette.dim;
    const Cost g = state.g(node), rhs = state.rhs(node);
    show(NumbersShown::four);
    const bool known = has_values(node);
    if (known) write(kNumberG, {x0, y0}, Anchor::upper_left, strong, g, room);
    if (lookahead_ && known) write(kNumberRhs, {x1, y0}, Anchor::upper_right, rhs_colour_, rhs, room);
    if (state.queued(node)) {
      write(kNumberKey, {x0, y1}, Anchor::lower_left, soft, state.k1(node), room);
      if (two_keys_) write(kNumberKey, {x1, y1}, Anchor::lower_right, soft, second_key(context_, node), room);
    }
    // Below the arrow and the signs, which have the very middle.
    if (state.dist(node) > Cost::zero())
      write(kNumberDist, {cell.x + 0.5, cell.y + 0.5 + context_.world(16)}, Anchor::middle, soft,
            state.dist(node), room);
  }

  void show(NumbersShown layout) { context_.scene.numbers = layout; }

  SceneContext& context_;
  NumberLayout layout_;
  bool lookahead_;
  bool raises_;    // costs that were settled may become dearer, be it without a way
  bool two_keys_;  // keys have a second component
  double side_;    // of a cell, design pixels
  Colour ground_ = 0, rhs_colour_ = 0;
};

}  // namespace

bool waits(const SceneContext& context, NodeId node) {
  const SearchState& state = context.state;
  if (!context.run.info().values.lookahead()) return state.queued(node);
  return state.touched(EventKind::rhs, node) && state.g(node) != state.rhs(node);
}

NumberLayout::NumberLayout(const SceneContext& context) {
  const double side = context.zoom / context.view.scale;
  const NumbersShown lines = context.run.info().values.lookahead() ? NumbersShown::two : NumbersShown::one;
  if (context.has(Overlay::numbers) && side >= kAllFrom)
    everywhere = waiting = side >= kFourFrom ? NumbersShown::four : lines;
  else if (context.has(Overlay::waiting) && side >= kWaitingFrom)
    waiting = lines;
  close = side < kAllFrom;
  apart = context.world(close ? 5.5 : std::min(side / 2 - 8, 18.0));
}

void build_numbers(SceneContext& context) {
  const std::array<std::unique_ptr<CellMark>, 1> numbers = {std::make_unique<CellNumbers>(context)};
  add_cell_marks(context, numbers);
}

}  // namespace replan
