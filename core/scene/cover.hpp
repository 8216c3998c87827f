// What a box over a scene would hide: for words and panels that are put where they hide least.
#pragma once

#include <vector>

#include "core/scene/pixel_box.hpp"
#include "core/scene/scene.hpp"

namespace replan {

class Cover {
 public:
  explicit Cover(const Scene& scene);

  /// How much a box would hide: square pixels, of numbers and of start, goal and robot many times over, of the plain world
  /// a little.
  [[nodiscard]] double hidden(const PixelBox& box) const;
  /// Something more that is not to be hidden.
  void add(const PixelBox& box, double weight) { things_.push_back({box, weight}); }
  /// Of all that it knows what meets the box.
  [[nodiscard]] Cover within(const PixelBox& box) const;

  /// Where a cell of the scene lies.
  [[nodiscard]] static PixelBox cell(const Scene& scene, Cell cell);
  /// Where the world lies.
  [[nodiscard]] static PixelBox world(const Scene& scene);

  /// Where a box of that size hides least and is not far from what it is about, which it leaves free, with a gap: within
  /// `room`, and `reach` away at most. A pixel of the way is as bad as `farther` hidden ones.
  [[nodiscard]] PixelBox best_beside(const PixelBox& size, const PixelBox& about, const PixelBox& room,
                                     double gap, double reach, double farther) const;

  static constexpr double kWords = 4;  ///< how much more words weigh than their area

 private:
  struct Thing {
    PixelBox box;
    double weight;
  };
  struct Way {
    double x0, y0, x1, y1, width;
  };

  Cover() = default;

  PixelBox world_;
  std::vector<Thing> things_;
  std::vector<Way> ways_;  // stretches of lines
};

}  // namespace replan
