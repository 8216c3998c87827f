#include "core/scene/overlay.hpp"

#include <vector>

#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

OverlayKind named(OverlayKind kind, Overlay overlay, std::string_view id) {
  kind.info.overlay = overlay;
  kind.info.id = id;
  return kind;
}

std::vector<OverlayKind> make_kinds() {
  return {
#define REPLAN_FIELD(ID) named(overlay_##ID(), Overlay::ID, #ID),
#define REPLAN_MARK(ID) named(overlay_##ID(), Overlay::ID, #ID),
#include "core/scene/overlays.def"
#undef REPLAN_MARK
#undef REPLAN_FIELD
  };
}

const std::vector<OverlayKind>& kinds() {
  static const std::vector<OverlayKind> kKinds = make_kinds();
  return kKinds;
}

}  // namespace

const OverlayKind& overlay_kind(Overlay overlay) {
  return kinds()[static_cast<std::size_t>(overlay)];
}

std::span<const OverlayInfo> overlays() {
  static const std::vector<OverlayInfo> kInfos = [] {
    std::vector<OverlayInfo> infos;
    for (const OverlayKind& kind : kinds()) infos.push_back(kind.info);
    return infos;
  }();
  return kInfos;
}

/// From the last in the list to the first. Cell by cell goes what follows upon one another in this way.
void build_layer(SceneContext& context, Layer layer) {
  std::vector<std::unique_ptr<CellMark>> pass;
  const auto add_pass = [&] {
    if (!pass.empty()) add_cell_marks(context, pass);
    pass.clear();
  };
  for (auto kind = kinds().rbegin(); kind != kinds().rend(); ++kind) {
    if (kind->field || kind->layer != layer || !context.has(kind->info.overlay)) continue;
    if (kind->each != nullptr)
      if (auto mark = kind->each(context)) pass.push_back(std::move(mark));
    if (kind->draw == nullptr) continue;
    add_pass();
    kind->draw(context);
  }
  add_pass();
}

void build_in_space(SolidPen& pen) {
  if (const auto field = pen.context().view.overlays.field()) pen.field(*field);
  for (auto kind = kinds().rbegin(); kind != kinds().rend(); ++kind)
    if (kind->draw_in_space != nullptr && pen.context().has(kind->info.overlay)) kind->draw_in_space(pen);
}

}  // namespace replan
