// One decision of the dynamic window approach: 200 samples of 3 s on a map of 512 x 512 cells, with all its reasons.
#include <benchmark/benchmark.h>

#include "core/base/random.hpp"
#include "core/drive/dynamic_window.hpp"

namespace replan {
namespace {

/// A map at random, and places on it where a robot as wide as three cells, or of 0.18 m, touches nothing.
struct Ground {
  CellFrame frame;
  std::vector<std::uint8_t> cells;
  DriveSettings settings;
  std::vector<DriveState> states;

  Ground(double side, double share) : frame{Box(512, 512), side}, cells(frame.box.node_count()) {
    Random random(1);
    for (auto& cell : cells) cell = random.chance(share) ? 1 : 0;
    Settings values;
    values.set("radius", std::min(0.18, 1.5 * side));
    values.set("w_max", 1.5);
    for (const char* key : {"acceleration", "brake"}) values.set(key, 1);
    for (const char* key : {"angular_acceleration", "angular_brake"}) values.set(key, 4);
    settings = drive_settings(values);
    while (states.size() < 200) {
      DriveState state;
      state.pose.x = side * (50 + 400 * random.unit());
      state.pose.y = side * (50 + 400 * random.unit());
      state.pose.heading = 6 * random.unit() - 3;
      state.motion = {0.3, 0.1};
      const double gap = obstacles(state.pose.spot()).to_still(state.pose.spot(), 1) - settings.limits.radius;
      if (gap > settings.margin) states.push_back(state);
    }
  }
  [[nodiscard]] LocalObstacles obstacles(Spot at) const {
    const double reach = settings.limits.v_max * settings.horizon + settings.limits.radius + settings.reach;
    LocalObstacles made;
    made.known =
        ObstacleSet({frame.side / 2, 0},
                    cells_around(frame, at, reach, true, [this](NodeId node) { return cells[node] != 0; }));
    return made;
  }
};

/// The side of a cell in centimetres, and how many in a hundred are obstacles.
void grounds(benchmark::internal::Benchmark* bench) {
  for (const int side : {100, 15, 5})
    for (const int percent : {5, 20}) bench->Args({side, percent});
  bench->Unit(benchmark::kMicrosecond);
}

void dwa_tick(benchmark::State& state) {
  const Ground ground(static_cast<double>(state.range(0)) / 100, static_cast<double>(state.range(1)) / 100);
  std::size_t i = 0;
  for (auto _ : state) {
    const DriveState& at = ground.states[i++ % ground.states.size()];
    const Spot goal = {at.pose.x + 3, at.pose.y + 2};
    benchmark::DoNotOptimize(explain(at, ground.obstacles(at.pose.spot()), goal, ground.settings));
  }
}
BENCHMARK(dwa_tick)->Apply(grounds);

}  // namespace
}  // namespace replan
