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

class SolidPen;

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
  /// Of a mark: what it adds to a view from outside; nullptr: it shows on slices alone. A field lies there as a picture on
  /// the slice, whichever it is.
  void (*draw_in_space)(SolidPen& pen) = nullptr;
};

#define REPLAN_FIELD(ID) OverlayKind overlay_##ID();
#define REPLAN_MARK(ID) OverlayKind overlay_##ID();
#include "core/scene/overlays.def"
#undef REPLAN_MARK
#undef REPLAN_FIELD

const OverlayKind& overlay_kind(Overlay overlay);

/// Adds the marks of a layer that are on.
void build_layer(SceneContext& context, Layer layer);
/// Adds what is on to a view from outside: the field, and the marks.
void build_in_space(SolidPen& pen);

}  // namespace replan
