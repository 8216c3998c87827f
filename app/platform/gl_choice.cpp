#include "app/platform/gl_choice.hpp"

#include <cstdlib>
#include <string>
#include <string_view>

namespace replan::app {

Result<GlChoice> gl_choice() {
  const char* text = std::getenv("REPLAN_GL");
  const std::string_view asked = text != nullptr ? text : "";
  if (asked.empty()) return GlChoice::any;
  if (asked == "core") return GlChoice::core;
  if (asked == "es") return GlChoice::es;
  return Error{"REPLAN_GL is '" + std::string(asked) +
               "'; it must be 'core' for OpenGL 3.3 or 'es' for OpenGL ES 3.0, or not be set"};
}

}  // namespace replan::app
