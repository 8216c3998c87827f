// Which OpenGL draws.
#pragma once

#include "core/base/result.hpp"

namespace replan::app {

enum class GlChoice {
  any,   ///< OpenGL 3.3 core, and where there is none OpenGL ES 3.0
  core,  ///< OpenGL 3.3 core alone
  es,    ///< OpenGL ES 3.0 alone
};

/// What the environment's REPLAN_GL asks for: "core" or "es"; any, if it is not set.
Result<GlChoice> gl_choice();

}  // namespace replan::app
