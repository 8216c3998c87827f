// What tests of several panes share.
#pragma once

#include <algorithm>
#include <thread>

#include "core/session/session.hpp"

namespace replan::test {

/// Until nothing works in the background and all panes stand where they belong.
inline void settle_panes(Session& session) {
  const auto busy = [&] {
    return std::any_of(session.runs().begin(), session.runs().end(),
                       [](const auto& run) { return run->busy(); });
  };
  do {
    while (busy()) {
      session.update(0);
      std::this_thread::yield();
    }
    session.update(0);
  } while (busy());
}

}  // namespace replan::test
