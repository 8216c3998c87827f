// What a view from outside costs in core: the faces of all obstacles, a stroke, and a scene with a long open list.
#include <memory>

#include <benchmark/benchmark.h>

#include "core/base/random.hpp"
#include "core/scene/context.hpp"
#include "core/scene/open_cells.hpp"
#include "core/scene/solid_mesh.hpp"
#include "core/scene/solid_scene.hpp"
#include "core/session/session.hpp"

namespace replan {
namespace {

constexpr int kSolidSide = 256;

/// 256^3 cells with boxes in them, and a search without an estimate, whose open list is a sphere.
Session& solid_world() {
  static const std::unique_ptr<Session> session = [] {
    Random random(2);
    Scenario scenario;
    scenario.map = GridMap(kSolidSide, kSolidSide, kSolidSide);
    for (int i = 0; i < 4000; ++i) {
      const Cell low{random.between(0, kSolidSide - 12), random.between(0, kSolidSide - 12),
                     random.between(0, kSolidSide - 12)};
      const int side = random.between(2, 12);
      for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
          for (int x = 0; x < side; ++x) scenario.map.set({low.x + x, low.y + y, low.z + z}, true);
    }
    scenario.start = {128, 128, 128};
    scenario.goal = {160, 150, 140};
    scenario.map.set(scenario.start, false);
    scenario.map.set(scenario.goal, false);
    scenario.planners = {{"dijkstra", {}, {}}};
    auto made = std::make_unique<Session>(std::move(scenario));
    made->settle();
    return made;
  }();
  return *session;
}

Palette solid_palette() {
  Palette palette;
  palette.free = 0xFFFFFFFF;
  palette.obstacle = 0xFF445566;
  palette.mover = 0xFFAA00AA;
  palette.surprise = 0xFF0080FF;
  return palette;
}

/// All blocks of a world that was just opened.
void BM_solid_mesh(benchmark::State& state) {
  const Run& run = solid_world().run();
  SceneMemory memory;
  const RunDigest& digest = memory.of(run).digest;
  std::size_t faces = 0;
  for (auto _ : state) {
    SolidMesh mesh;
    mesh.follow(run, digest, solid_palette());
    mesh.make(run, {}, Deadline::never());
    faces = mesh.face_count();
  }
  state.counters["faces"] = static_cast<double>(faces);
}
BENCHMARK(BM_solid_mesh)->Unit(benchmark::kMillisecond);

/// The longest that one block keeps a frame: the mean of all.
void BM_solid_mesh_block(benchmark::State& state) {
  const Run& run = solid_world().run();
  SceneMemory memory;
  const RunDigest& digest = memory.of(run).digest;
  SolidMesh mesh;
  for (auto _ : state) {
    if (mesh.waiting() == 0) {
      state.PauseTiming();
      mesh = {};
      mesh.follow(run, digest, solid_palette());
      state.ResumeTiming();
    }
    mesh.make(run, {128, 400, 200}, Deadline(0));
  }
}
BENCHMARK(BM_solid_mesh_block)->Unit(benchmark::kMicrosecond);

/// A frame while a run plays: the argument is by how many events it goes on. With the open list as small cubes, the field on
/// the slice and the path.
void BM_solid_scene_playing(benchmark::State& state) {
  Session& session = solid_world();
  SceneMemory memory;
  View view;
  view.slice = {Axis::z, 128};
  const auto by = static_cast<std::size_t>(state.range(0));
  const std::size_t end = session.run().timeline().size();
  std::size_t at = end / 2, boxes = 0;
  for (auto _ : state) {
    state.PauseTiming();
    at = at + by < end ? at + by : end / 2;
    benchmark::DoNotOptimize(session.apply(Seek{at}).ok());
    state.ResumeTiming();
    const SolidScene scene =
        build_solid_scene(session.run(), view, {}, {128, 400, 200}, solid_palette(), memory);
    boxes = scene.boxes.size();
  }
  state.counters["cubes"] = static_cast<double>(boxes);
}
BENCHMARK(BM_solid_scene_playing)->Arg(100)->Arg(5'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace replan
