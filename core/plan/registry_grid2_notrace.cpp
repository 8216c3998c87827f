#include "core/plan/registry_make.hpp"

namespace replan {
template std::unique_ptr<Planner<Grid2>> make_planner(const PlannerInfo&, const Grid2&, const Settings&,
                                                      NoTrace&);
}  // namespace replan
