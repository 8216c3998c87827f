// What list.cpp makes its list of.
#pragma once

#include <vector>

#include "core/world/generators/list.hpp"

namespace replan {

/// Every generator, in the order in which they are listed to a user: those of the plane, then those of layers.
std::vector<GeneratorInfo> generator_kinds();

}  // namespace replan
