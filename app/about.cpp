#include "app/about.hpp"

#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <nlohmann/json.hpp>

namespace replan::app {
namespace {

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return __VERSION__;
#endif
}

}  // namespace

std::vector<ui::AboutLine> about_lines() {
  int major = 0, minor = 0, patch = 0;
  glfwGetVersion(&major, &minor, &patch);
  return {{"Replan", REPLAN_VERSION},
          {"Dear ImGui", IMGUI_VERSION},
          {"GLFW", dotted(major, minor, patch)},
          {"JSON for Modern C++",
           dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
          {"Compiler", compiler()}};
}

}  // namespace replan::app
