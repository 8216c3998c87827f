#include "ui/gl/gl.hpp"

#include <string>
#include <string_view>

namespace replan::ui {
namespace {

Error missing(const char* name) {
  return Error{
      std::string("The OpenGL driver has no function ") + name +
      "; Replan needs OpenGL 3.3 or OpenGL ES 3.0. Update the driver, or set LIBGL_ALWAYS_SOFTWARE=1."};
}

}  // namespace

Result<void> Gl::load(GlLoader loader) {
#define REPLAN_GL_LOAD(type, name)                                \
  name = reinterpret_cast<PFNGL##type##PROC>(loader("gl" #name)); \
  if (name == nullptr) return missing("gl" #name);
  REPLAN_GL_FUNCTIONS(REPLAN_GL_LOAD)
#undef REPLAN_GL_LOAD
  const auto* version = reinterpret_cast<const char*>(GetString(GL_VERSION));
  es = version != nullptr && std::string_view(version).starts_with("OpenGL ES");
  return {};
}

}  // namespace replan::ui
