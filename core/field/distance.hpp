// Distance transforms of whole maps: how far each cell is from the nearest obstacle, centre to centre.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/cost.hpp"

namespace replan {

/// Squared distance where there is no obstacle at all.
inline constexpr std::int32_t kNoObstacle = 1 << 30;

/// Squared Euclidean distances, exact, in cells; 0 for obstacles, kNoObstacle everywhere if there is none.
/// `blocked` is row-major, nonzero = obstacle; sides up to 2^14 cells.
///
/// Column distances first, then along each row the lower envelope of the parabolas (x - i)^2 + column(i)^2:
/// Meijster, Roerdink & Hesselink, "A general algorithm for computing distance transforms in linear time",
/// 2000, doi 10.1007/0-306-47025-X_36. Rows in which every obstacle is near are scanned instead of enveloped,
/// many cells at a time: the numbers are the same.
std::vector<std::int32_t> squared_distances(int width, int height, std::span<const std::uint8_t> blocked);
/// The same in space, layers behind each other: within each layer, then across the layers in the same way.
std::vector<std::int32_t> squared_distances(int width, int height, int depth,
                                            std::span<const std::uint8_t> blocked);

/// Chamfer distances with weights 1 and sqrt 2 by two passes, as the DLD* Lite paper computes them (Huang &
/// Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, section 2.2.1): 0 for obstacles, infinite everywhere if there
/// is none.
std::vector<Cost> chamfer_distances(int width, int height, std::span<const std::uint8_t> blocked);

}  // namespace replan
