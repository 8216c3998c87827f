#include "app/platform/surroundings.hpp"

#include "app/platform/window.hpp"
#include "core/base/folders.hpp"
#include "core/world/library.hpp"

namespace replan::app {

ui::Surroundings surroundings() {
  return {.state_folder = state_folder(), .worlds_folder = library_folder(), .work = {false, [] {
                                                                                        Window::wake();
                                                                                      }}};
}

}  // namespace replan::app
