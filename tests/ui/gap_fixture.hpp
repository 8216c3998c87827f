// A small world with a gap in its wall that a surprise shuts, two planners, and a clipboard that nobody else has.
#pragma once

#include <chrono>
#include <string>
#include <thread>

#include "tests/ui/shell_fixture.hpp"

namespace replan::ui {

inline constexpr const char* kGapWorld = R"({"replan": 1, "name": "Gap",
  "map": {"rows": ["........", "...@....", "...@....", "...@....", "........"]},
  "start": [0, 2], "goal": [7, 2],
  "planners": [{"id": "astar"}, {"id": "dstar-lite"}],
  "robot": {"knowledge": "map", "sensor_radius": 2},
  "surprises": [{"at": {"move": 1}, "add": {"cells": [[3, 0]]}}]})";

class GapTest : public ShellTest {
 protected:
  void begin(const char* world) {
    open("gap.json", world);
    static std::string held;
    held.clear();
    ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { held = text; };
    ImGui::GetIO().GetClipboardTextFn = [](void*) { return held.c_str(); };
  }
  /// Until nothing is under way any more.
  void rest() {
    for (int i = 0; i < 500 && shell_->wants_frames(*session_); ++i) {
      frames(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
};

}  // namespace replan::ui
