// A page: work in step, the browser's picker to open files, its recorder for films.
#include "app/platform/surroundings.hpp"

#include <string>
#include <utility>
#include <vector>

#include "app/web/page.hpp"
#include "core/base/folders.hpp"
#include "core/world/library.hpp"

namespace replan::app {

ui::Surroundings surroundings(WorkPlace work) {
  const auto pick = [](const std::vector<ui::FileFilter>& filters) {
    std::string extensions;
    for (const std::string& extension : filters.front().extensions)
      extensions += (extensions.empty() ? "" : ",") + extension;
    pick_file(extensions);
  };
  return {.state_folder = state_folder(),
          .worlds_folder = library_folder(),
          .work = std::move(work),
          .files = {.pick = pick, .films = {{"Film (.webm)", {".webm"}}}}};
}

}  // namespace replan::app
