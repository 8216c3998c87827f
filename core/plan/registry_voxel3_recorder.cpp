#include "core/plan/registry_make.hpp"

namespace replan {
template std::unique_ptr<Planner<Voxel3>> make_planner(const PlannerInfo&, const Voxel3&, const Settings&,
                                                       Recorder&);
}  // namespace replan
