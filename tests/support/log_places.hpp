// Places in the log of a run, for tests that go there.
#pragma once

#include <cstddef>

#include "core/session/run.hpp"

namespace replan::test {

/// The position after the n-th event of a kind, from 0 on; 0 if there are not so many.
inline std::size_t after(const Run& run, EventKind kind, std::size_t n = 0) {
  for (std::size_t p = 0; p < run.timeline().size(); ++p)
    if (run.timeline().event(p).kind == kind && n-- == 0) return p + 1;
  return 0;
}

}  // namespace replan::test
