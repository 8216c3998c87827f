#include "core/scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/numbers.hpp"
#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// Sets which cells are in sight.
void clip(SceneContext& context) {
  const Scene& scene = context.scene;
  const double half_width = scene.width / 2.0 / context.zoom, half_height = scene.height / 2.0 / context.zoom;
  const auto bound = [](double at, int limit) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(limit)));
  };
  context.left = bound(std::floor(scene.camera.x - half_width), context.lattice.width());
  context.right = bound(std::ceil(scene.camera.x + half_width), context.lattice.width());
  context.top = bound(std::floor(scene.camera.y - half_height), context.lattice.height());
  context.bottom = bound(std::ceil(scene.camera.y + half_height), context.lattice.height());
}

}  // namespace

/// A fitted world leaves this share of itself free around it, so that what stands at its edge is whole.
constexpr double kFitMargin = 1.06;

Camera resolve(const Camera& camera, int columns, int rows, Viewport viewport) {
  Camera resolved = camera;
  if (camera.zoom <= 0) {
    const int height = std::max(viewport.height - viewport.above - viewport.below, 1);
    resolved = {columns / 2.0, rows / 2.0,
                std::min(viewport.width / std::max(columns + 2.0, columns * kFitMargin),
                         height / std::max(rows + 2.0, rows * kFitMargin))};
    // Whole pixels where that costs little: cells of one size, and sharp lines between them.
    if (resolved.zoom >= 8) resolved.zoom = std::floor(resolved.zoom);
    resolved.zoom = std::max(resolved.zoom, 1e-3);
    resolved.y += (viewport.below - viewport.above) / 2.0 / resolved.zoom;
  }
  // The world's corner lies on a whole pixel, so that nothing shimmers while the view is moved.
  const auto snap = [zoom = resolved.zoom](double middle, int pixels) {
    return (pixels / 2.0 - std::round(pixels / 2.0 - middle * zoom)) / zoom;
  };
  resolved.x = snap(resolved.x, viewport.width);
  resolved.y = snap(resolved.y, viewport.height);
  return resolved;
}

double label_width(std::string_view words) {
  // Of UTF-8, each byte that begins a character.
  return kDigitWidth * static_cast<double>(std::count_if(words.begin(), words.end(),
                                                         [](char c) { return (c & 0xC0) != 0x80; }));
}

SceneMemory::SceneMemory() : parts_(std::make_unique<Parts>()) {}
SceneMemory::~SceneMemory() = default;
SceneMemory::SceneMemory(SceneMemory&&) noexcept = default;
SceneMemory& SceneMemory::operator=(SceneMemory&&) noexcept = default;

SceneMemory::Parts& SceneMemory::of(const Run& run) {
  parts_->digest.read(run);
  return *parts_;
}

std::int64_t SceneMemory::expansions(const Run& run, std::size_t position) {
  return of(run).digest.expansions(run, position);
}

std::optional<std::size_t> SceneMemory::searching_since(const Run& run, std::size_t position) {
  const RunDigest& digest = of(run).digest;
  const std::size_t count = digest.plans_before(position);
  if (count == 0) return position == 0 ? std::optional<std::size_t>(0) : std::nullopt;
  const PlanSpan& plan = digest.plans()[count - 1];
  if (plan.end <= position) return std::nullopt;
  return plan.begin;
}

const KeptInReplan* SceneMemory::Parts::kept_by_replan(const Run& run, std::size_t position) {
  const SearchValues& values = run.info().values;
  const std::size_t count = digest.plans_before(position);
  if (count < 2 || (!values.grows() && !values.breeds())) return nullptr;
  const PlanSpan& plan = digest.plans()[count - 1];
  kept.follow(run.log_view(), run.log_id(), plan.begin, std::min(plan.end, run.timeline().size()));
  return &kept;
}

RepairFigures SceneMemory::repair(const Run& run, std::size_t position) {
  Parts& parts = of(run);
  const RunDigest& digest = parts.digest;
  const std::size_t count = digest.plans_before(position);
  if (count < 2) return {};
  RepairFigures figures;
  figures.number = static_cast<std::int64_t>(count) - 1;
  const PlanSpan& plan = digest.plans()[count - 1];
  figures.touched = static_cast<std::int64_t>(digest.touches_before(plan, position).size());
  if (const KeptInReplan* kept = parts.kept_by_replan(run, position))
    figures.kept = kept->counts_before(position);
  figures.steps = digest.expansions(run, std::min(position, plan.end)) - digest.expansions(run, plan.begin);
  figures.cause = plan.cause;
  const Decision *before = run.decision_at(plan.begin), *after = run.decision_at(position);
  if (before != nullptr) figures.clock = before->clock;
  if (plan.end <= position && before != nullptr && after != nullptr)
    figures.ms = after->figures.replan_ms - before->figures.replan_ms;
  return figures;
}

Scene build_scene(const Run& run, const View& view, Viewport viewport, const Palette& palette,
                  SceneMemory& memory) {
  Scene scene;
  scene.width = viewport.width;
  scene.height = viewport.height;
  const SeenBox seen(run.lattice(), view.slice.along);
  scene.columns = seen.width();
  scene.rows = seen.height();
  scene.scale = view.scale;
  scene.background = palette.surround;
  scene.camera = resolve(view.camera, scene.columns, scene.rows, viewport);
  SceneContext context{run, view, palette, memory.of(run), scene};
  clip(context);
  build_raster(context);
  build_rim(context);
  for (const Layer layer : {Layer::lines, Layer::hatches, Layer::arrows, Layer::frames, Layer::script})
    build_layer(context, layer);
  build_routes(context);
  build_layer(context, Layer::routes);
  build_things(context);
  build_layer(context, Layer::hand);
  build_numbers(context);
  build_notes(context, viewport);
  return scene;
}

Scene build_scene(const Run& run, const View& view, Viewport viewport, const Palette& palette) {
  SceneMemory memory;
  return build_scene(run, view, viewport, palette, memory);
}

}  // namespace replan
