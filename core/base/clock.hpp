// How fine the clock is that times are measured by.
#pragma once

namespace replan {

/// Milliseconds; 0: finer than anything that is measured. Browsers make theirs coarse, so that a page cannot learn of others
/// by it: a tenth of a millisecond in Chrome, a whole one in Firefox.
#ifdef __EMSCRIPTEN__
inline constexpr double kFinestMs = 0.1;
#else
inline constexpr double kFinestMs = 0;
#endif

/// What is written in the place of fewer milliseconds than that.
inline constexpr const char* kUnderFinestMs = "under 0.1";

}  // namespace replan
