// The whole of a layer on a few texels, for a small picture of a world that is larger than its view.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/scene.hpp"

namespace replan {

/// Ground and obstacles; of an obstacle that the robot does not know a shade.
struct Overview {
  int columns = 0, rows = 0;
  std::vector<Colour> texels;
};

/// Keeps one up to date: it is made anew where the map has changed, and not otherwise.
class OverviewKeeper {
 public:
  /// Of a layer, as it is seen, at the run's cursor, on at most `most` texels a side. Whether it is another one than last
  /// time.
  bool follow(const Run& run, SceneMemory& memory, const Slice& slice, const Palette& palette, int most);
  [[nodiscard]] const Overview& picture() const { return picture_; }

 private:
  struct Key {
    std::uint64_t map = 0;  ///< MapCoverage::revision()
    SeenBox world;
    int layer = 0, most = 0;
    Colour free = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  std::optional<Key> key_;
  Overview picture_;
};

}  // namespace replan
