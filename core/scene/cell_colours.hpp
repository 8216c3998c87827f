// The colour of each cell of a view: what stands there, and the field that lies over it.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/scene/context.hpp"

namespace replan {

/// The cells that some surprise blocks without telling the robot, ascending.
inline std::vector<NodeId> surprising_cells(const Run& run) {
  std::vector<NodeId> cells;
  for (const Surprise& surprise : run.scenario().surprises)
    for (const CellChange& change : surprise.cells)
      if (change.blocked && !surprise.announced) cells.push_back(run.lattice().node(change.cell));
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// The colours of one view's cells.
class CellColours {
 public:
  explicit CellColours(SceneContext& context)
      : context_(context),
        map_(context.run.scenario().map),
        original_(map_.blocked),
        found_(context.run.scenario().map_found),
        surprises_(surprising_cells(context.run)),
        shows_unknown_(context.has(Overlay::unknown)),
        settled_alone_(context.scene.field && shows_settled_alone(context.run, *context.scene.field)) {
    const Palette& palette = context.palette;
    unknown_ = mix(palette.free, palette.obstacle, 0.5f);
    unknown_surprise_ = mix(palette.free, palette.surprise, 0.6f);
    unseen_mover_ = mix(palette.free, palette.mover, 0.5f);
    gone_ = mix(palette.free, palette.obstacle, 0.3f);
    for (std::size_t i = 0; i < ramp_.size(); ++i)
      ramp_[i] = mix(palette.free, palette.field[i], palette.field_opacity);
    if (!context.scene.range) return;
    reader_ = FieldReader::of(*context.scene.field);
    low_ = context.scene.range->low / reader_.unit;
    const double span = context.scene.range->high / reader_.unit - low_;
    steps_ = span > 0 ? 255.0 / span : 0;
  }

  /// The colour of a cell that is free and that the robot takes for free.
  Colour free(NodeId node) {
    context_.scene.show(Sign::free);
    return ground(node);
  }

  /// The colour of a cell that is no obstacle to the robot.
  Colour ground(NodeId node) { return value(node).value_or(context_.palette.free); }

  /// The colour of the field's value in a cell, if it has one.
  std::optional<Colour> value(NodeId node) {
    if (!context_.scene.range) return std::nullopt;
    turn_to(node);
    if (page_ == nullptr) return std::nullopt;
    if (queue_ != nullptr && queue_[node % SearchState::kPage] != 0) return std::nullopt;
    const std::int64_t value = reader_.read(page_[node % SearchState::kPage]);
    if (value == FieldReader::kNone) return std::nullopt;
    const double step = std::clamp((static_cast<double>(value) - low_) * steps_, 0.0, 255.0);
    return ramp_[static_cast<std::size_t>(step + 0.5)];
  }

  Colour cell(NodeId node) {
    turn_to(node);
    const std::size_t at = node % SearchState::kPage;
    const bool truth = truth_ != nullptr && truth_[at] != 0, known = known_ != nullptr && known_[at] != 0;
    if (!truth && !known) return free(node);
    if (truth && truth_[at] >= kMoverUnit) return moving(known);
    // What the robot was told of is a wall like any other; an unseen surprise shows even where the rest of
    // the unknown world does not.
    const bool surprising =
        truth && original_[node] == 0 && std::binary_search(surprises_.begin(), surprises_.end(), node);
    if (surprising) context_.scene.show(Sign::surprise);
    if (truth && known) return surprising ? context_.palette.surprise : obstacle(node);
    if (!shows_unknown_ && surprising) return unknown_surprise_;
    if (!shows_unknown_) return known ? obstacle(node) : free(node);
    context_.scene.show(truth ? Sign::unknown : Sign::gone);
    if (known) return gone_;
    return surprising ? unknown_surprise_ : unknown_;
  }

  /// The colour of a cell that the robot takes for an obstacle: a wall, or what its map calls unknown.
  Colour obstacle(NodeId node) {
    const bool unseen = found_.is_unknown(map_, node);
    context_.scene.show(unseen ? Sign::unseen : Sign::obstacle);
    return unseen ? context_.palette.unseen : context_.palette.obstacle;
  }

  /// Something that moves, in full where the robot has seen it there.
  Colour moving(bool known) {
    context_.scene.show(Sign::mover);
    return known ? context_.palette.mover : unseen_mover_;
  }

  [[nodiscard]] bool shows_unknown() const { return shows_unknown_; }
  [[nodiscard]] Colour unknown() const { return unknown_; }

 private:
  /// Has the pages of `node` at hand: neighbours mostly lie on the same ones.
  void turn_to(NodeId node) {
    if (node / SearchState::kPage == page_number_) return;
    page_number_ = node / SearchState::kPage;
    page_ = context_.state.page(reader_.kind, node);
    truth_ = context_.state.map_page(EventKind::truth, node);
    known_ = context_.state.map_page(EventKind::known, node);
    queue_ = settled_alone_ ? context_.state.page(EventKind::queue, node) : nullptr;
  }

  SceneContext& context_;
  const GridMap& map_;
  const SharedBytes& original_;
  const MapFindings& found_;
  std::vector<NodeId> surprises_;  // cells that some surprise blocks without telling the robot, ascending
  bool shows_unknown_, settled_alone_;
  Colour unknown_ = 0, unknown_surprise_ = 0, unseen_mover_ = 0, gone_ = 0;
  std::array<Colour, 256> ramp_{};
  FieldReader reader_;  // of the field that shows, if one does
  double low_ = 0, steps_ = 0;
  std::size_t page_number_ = SIZE_MAX;
  const std::uint64_t* page_ = nullptr;
  const std::uint8_t* truth_ = nullptr;
  const std::uint8_t* known_ = nullptr;
  const std::uint64_t* queue_ = nullptr;  // where what is in the open list has no colour
};

}  // namespace replan
