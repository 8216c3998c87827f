#include "core/plan/stage.hpp"

#include "core/plan/named.hpp"

#define REPLAN_STAGE_HEADERS
#include "core/stages/stages.def"
#undef REPLAN_STAGE_HEADERS

namespace replan {
namespace {

template <class Stage>
StageInfo entry(std::string_view id) {
  StageInfo info = Stage::describe();
  info.id = id;
  info.in_plane = Stage::template apply<Grid2>;
  info.in_space = Stage::template apply<Voxel3>;
  return info;
}

}  // namespace

std::span<const StageInfo> stages() {
  static const std::vector<StageInfo> all = {
#define REPLAN_STAGE(ID, CLASS) entry<CLASS>(ID),
#include "core/stages/stages.def"
#undef REPLAN_STAGE
  };
  return all;
}

const StageInfo* find_stage(std::string_view id) {
  return find_by_id(stages(), id);
}

Result<const StageInfo*> require_stage(std::string_view id) {
  return require_by_id(stages(), id, "stage");
}

Path through_stages(const Grid2& known, Path path, std::span<const StageChoice> stages) {
  for (const StageChoice& stage : stages)
    path = find_stage(stage.id)->in_plane(known, std::move(path), stage.settings);
  return path;
}

Path through_stages(const Voxel3& known, Path path, std::span<const StageChoice> stages) {
  for (const StageChoice& stage : stages)
    path = find_stage(stage.id)->in_space(known, std::move(path), stage.settings);
  return path;
}

}  // namespace replan
