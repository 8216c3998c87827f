#include <algorithm>

#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// The value of a planner's own that says which expansion's jumps passed over a cell last; nullptr: it keeps none.
const Field* scans_of(const PlannerInfo& planner) {
  for (const Field& field : planner.values.fields)
    if (is_own_field(field.kind) && field.name == "scanned") return &field;
  return nullptr;
}

class ScannedCells final : public CellMark {
 public:
  ScannedCells(SceneContext& context, EventKind kind)
      : context_(context), kind_(kind), inset_(context.pixels(2)), latest_(latest()) {}

  bool turn_to(NodeId first) override {
    values_ = context_.state.page(kind_, first);
    return values_ != nullptr;
  }
  void add(Cell cell, NodeId node) override {
    const std::uint64_t value = values_[node % SearchState::kPage];
    if (value == 0) return;
    context_.scene.show(Sign::scanned);
    mark_cell(context_, cell, OutlineShape::square, context_.palette.good, value == latest_ ? 1 : 0.3,
              context_.pixels(1.4), inset_);
  }

 private:
  /// The expansion whose jumps passed over cells last.
  [[nodiscard]] std::uint64_t latest() const {
    constexpr std::size_t kFar = 4096;
    const Timeline& log = context_.run.timeline();
    for (std::size_t i = context_.cursor; i-- > (context_.cursor > kFar ? context_.cursor - kFar : 0);) {
      const Event event = log.event(i);
      if (event.kind == kind_) return context_.state.value(kind_, event.node);
    }
    return 0;
  }

  SceneContext& context_;
  EventKind kind_;
  float inset_;
  std::uint64_t latest_;
  const std::uint64_t* values_ = nullptr;
};

std::unique_ptr<CellMark> scanned_cells(SceneContext& context) {
  const Field* field = scans_of(context.run.info());
  if (field == nullptr) return nullptr;
  return std::make_unique<ScannedCells>(context, field->kind);
}

}  // namespace

OverlayKind overlay_scanned() {
  return {
      .info = {.label = "scanned",
               .help = "The cells that jumps of a jump point search passed over: strong those of the latest "
                       "expansion, faint those of earlier ones.",
               .at_first = true},
      .layer = Layer::frames,
      .each = scanned_cells};
}

}  // namespace replan
