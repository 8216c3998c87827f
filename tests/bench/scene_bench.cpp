// What a frame costs in core: building the scene of a huge map, near and far, standing still and playing.
#include <benchmark/benchmark.h>

#include "core/scene/coverage.hpp"
#include "core/scene/scene.hpp"
#include "core/session/session.hpp"
#include "core/world/generators/generators.hpp"

namespace replan {
namespace {

constexpr Viewport kView{1390, 760};

/// A planned world of 4096 x 4096 cells, made once.
Session& huge() {
  static Session session = [] {
    Scenario scenario;
    const Cell start{40, 40}, goal{4050, 4050};
    const Cell ends[] = {start, goal};
    scenario.map = *random_rectangles(4096, 4096, 0.17, 5, 60, 1, ends);
    scenario.start = start;
    scenario.goal = goal;
    scenario.planners = {{"dstar-lite", {}}};
    return Session(std::move(scenario));
  }();
  static const bool settled = [] {
    session.settle();
    return true;
  }();
  benchmark::DoNotOptimize(settled);
  return session;
}

OverlaySet everything() {
  OverlaySet set = default_overlays();
  for (const OverlayInfo& info : overlays())
    if (!info.is_field()) set.set(info.overlay, true);
  return set;
}

Palette some_palette() {
  Palette palette;
  palette.free = 0xFF1A1310;
  palette.obstacle = 0xFF4D4139;
  for (std::size_t i = 0; i < palette.field.size(); ++i)
    palette.field[i] = 0xFF000000u | static_cast<Colour>(i) << 8;
  return palette;
}

/// How much of each block is obstacle, as a new world is first drawn from afar.
void BM_coverage(benchmark::State& state) {
  const Run& run = huge().run();
  for (auto _ : state) {
    const Coverage coverage(SeenBox(run.lattice(), Axis::z), 0, run.timeline().state(), EventKind::truth);
    benchmark::DoNotOptimize(coverage.levels());
  }
}
BENCHMARK(BM_coverage)->Unit(benchmark::kMillisecond);

/// All overlays; the argument is the zoom in hundredths of a pixel per cell, 0 = the whole world.
void BM_scene_standing(benchmark::State& state) {
  Session& session = huge();
  View view;
  view.overlays = everything();
  view.camera = {2048, 2048, static_cast<double>(state.range(0)) / 100};
  SceneMemory memory;
  const Palette palette = some_palette();
  build_scene(session.run(), view, kView, palette, memory);
  std::size_t shapes = 0;
  for (auto _ : state) {
    const Scene scene = build_scene(session.run(), view, kView, palette, memory);
    shapes = scene.shapes.size();
    benchmark::DoNotOptimize(scene.raster.texels.data());
  }
  state.counters["shapes"] = static_cast<double>(shapes);
}
BENCHMARK(BM_scene_standing)
    ->Arg(0)
    ->Arg(50)
    ->Arg(100)
    ->Arg(400)
    ->Arg(1000)
    ->Arg(1400)
    ->Arg(5000)
    ->Arg(8000)
    ->Unit(benchmark::kMillisecond);

/// As above while playing: the cursor moves on by 4000 events a frame.
void BM_scene_playing(benchmark::State& state) {
  Session& session = huge();
  View view;
  view.overlays = everything();
  view.camera = {2048, 2048, static_cast<double>(state.range(0)) / 100};
  SceneMemory memory;
  const Palette palette = some_palette();
  std::size_t position = session.run().timeline().size() / 2;
  for (auto _ : state) {
    state.PauseTiming();
    position = position + 4000 < session.run().timeline().size() ? position + 4000 : position / 2;
    (void)session.apply(Seek{position});
    if (memory.expansions(session.run(), 0) < 0) state.SkipWithError("no log");
    state.ResumeTiming();
    const Scene scene = build_scene(session.run(), view, kView, palette, memory);
    benchmark::DoNotOptimize(scene.raster.texels.data());
  }
}
BENCHMARK(BM_scene_playing)->Arg(0)->Arg(1400)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace replan
