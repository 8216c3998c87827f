#include "app/platform/surroundings.hpp"

#include <utility>

#include "core/base/folders.hpp"
#include "core/world/library.hpp"

namespace replan::app {

ui::Surroundings surroundings(WorkPlace work) {
  return {.state_folder = state_folder(), .worlds_folder = library_folder(), .work = std::move(work)};
}

}  // namespace replan::app
