// How often the tests that try something at random try it.
#pragma once

#include <cstdlib>

namespace replan::test {

/// So many of `all`: a quarter in `./test`, which has to end in some minutes, and all of them in `./test --all`.
inline int trials(int all) {
  static const bool every = std::getenv("REPLAN_ALL_TRIALS") != nullptr;
  return every ? all : (all + 3) / 4;
}

}  // namespace replan::test
