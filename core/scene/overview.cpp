#include "core/scene/overview.hpp"

#include <algorithm>

#include "core/scene/context.hpp"

namespace replan {
namespace {

/// The level of coverage whose blocks are few enough; 0: the cells themselves are.
int level_for(const SeenBox& world, int most) {
  int level = 0;
  while ((std::max(world.width(), world.height()) - 1) >> level >= most) ++level;
  return level;
}

/// Of 255: how much of a texel's block the robot's map and the world have as obstacle.
struct Shares {
  unsigned known = 0, truth = 0;
};

Shares shares_at(const Run& run, const SeenBox& world, const MapCoverage& coverage, int level, Cell at) {
  if (level == 0) {
    const SearchState& state = run.timeline().state();
    const NodeId node = world.node(at);
    return {state.known_blocked(node) ? 255u : 0u, state.truly_blocked(node) ? 255u : 0u};
  }
  return {coverage.known().level(level).row(at.y)[at.x], coverage.truth().level(level).row(at.y)[at.x]};
}

}  // namespace

bool OverviewKeeper::follow(const Run& run, SceneMemory& memory, const Slice& slice, const Palette& palette,
                            int most) {
  SceneMemory::Parts& parts = memory.of(run);
  const SeenBox world(run.lattice(), slice.along);
  const int layer = std::clamp(slice.layer, 0, world.depth() - 1);
  parts.coverage.follow(run, parts.digest, world, layer);
  const Key now{parts.coverage.revision(), world, layer, most, palette.free};
  if (key_ == now) return false;
  key_ = now;
  const int level = level_for(world, most);
  picture_.columns = ((world.width() - 1) >> level) + 1;
  picture_.rows = ((world.height() - 1) >> level) + 1;
  picture_.texels.clear();
  const Colour unknown = mix(palette.free, palette.obstacle, 0.5f);
  for (int y = 0; y < picture_.rows; ++y)
    for (int x = 0; x < picture_.columns; ++x) {
      const Shares shares = shares_at(run, world, parts.coverage, level, {x, y, layer});
      const Colour ground = mix(palette.free, unknown, static_cast<float>(shares.truth) / 255);
      picture_.texels.push_back(mix(ground, palette.obstacle, static_cast<float>(shares.known) / 255) |
                                0xFF000000u);
    }
  return true;
}

}  // namespace replan
