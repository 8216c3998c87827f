// What a window opens with.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/link/link.hpp"
#include "core/world/scenario.hpp"

namespace replan::app {

struct FirstDocument {
  Scenario scenario;
  std::string file;        ///< empty: nobody's yet
  std::string batch = {};  ///< an experiment, or results of one, to be shown over the scenario; empty: none
  bool asked_for = true;   ///< somebody wants to see this one
  std::optional<Link> link = {};  ///< that the scenario came with
};
/// That file or link, else the demo; where the program was copied without its files, a small world in code.
Result<FirstDocument> first_document(const std::optional<std::string>& file);

}  // namespace replan::app
