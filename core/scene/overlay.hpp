// What an overlay is made of: its words, and what it draws. Each has a file in core/scene/overlays that defines its
// OverlayKind, and a line in overlays.def.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/scene/cell_mark.hpp"
#include "core/scene/context.hpp"
#include "core/scene/view.hpp"

namespace replan {

/// Where a mark lies, from the lowest up.
enum class Layer : std::uint8_t { lines, hatches, arrows, frames, script, routes, hand };

struct OverlayKind {
  OverlayInfo info = {};
  /// Of a field: where its values are found.
  std::optional<FieldReader> field = {};
  /// What they are of a planner, for a legend; nullptr: the label says it.
  std::string (*words)(const PlannerInfo& planner) = nullptr;
  // Of a mark: where it lies, and what adds its shapes. `each` makes what is asked for every cell in sight; nullptr
  // where cells are too small for it.
  Layer layer = Layer::lines;
  void (*draw)(SceneContext& context) = nullptr;
  std::unique_ptr<CellMark> (*each)(SceneContext& context) = nullptr;
};

#define REPLAN_FIELD(ID) OverlayKind overlay_##ID();
#define REPLAN_MARK(ID) OverlayKind overlay_##ID();
#include "core/scene/overlays.def"
#undef REPLAN_MARK
#undef REPLAN_FIELD

const OverlayKind& overlay_kind(Overlay overlay);

/// Adds the marks of a layer that are on.
void build_layer(SceneContext& context, Layer layer);

}  // namespace replan
