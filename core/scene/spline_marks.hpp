// What there is to see of a path that is a curve besides itself. The path owns it (core/plan/path.hpp).
#pragma once

#include "core/plan/path.hpp"
#include "core/scene/view.hpp"
#include "core/session/run.hpp"

namespace replan {

/// What the path at the run's cursor was drawn from; nullptr if that is no curve.
const Spline* spline_at_cursor(const Run& run);
/// Where it was pulled in, in a cell or on account of the obstacle there; nullptr if nowhere, or if that is not shown.
const PullIn* pull_in_at(const Run& run, const View& view, Cell cell);

}  // namespace replan
