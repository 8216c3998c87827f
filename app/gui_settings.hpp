// What the window remembers from one start to the next: a JSON file in the user's configuration folder.
#pragma once

#include <string>

#include "app/platform/window.hpp"
#include "ui/shell/shell.hpp"

namespace replan::app {

/// $XDG_CONFIG_HOME/replan/window.json, else ~/.config/replan/window.json; empty if there is no home.
std::string settings_path();

/// Reads what was remembered. What is missing, unreadable or out of range keeps its default: this file is
/// never a reason not to start.
struct Remembered {
  bool first_start = true;  ///< nothing was remembered yet
  WindowSettings window;
  int size_step = 0;  ///< of words, buttons and panels
  bool large_targets = false;
  bool dark = true, panels = true, legend = true;
  bool colours_so_far = false;  ///< FieldSpan::so_far
  bool metres = true;
  bool minimap = true;
  ui::FieldColours colours = ui::FieldColours::viridis;
  int brush = 1;
  bool round_brush = false;
  std::string tab;  ///< its id; empty: the one that shows at first
  float side_width = 372;
  float side_share = 0.34f;  ///< of the height, where the side stands under the world
  bool caption = true;
  StepUnit unit = StepUnit::expansion;
  double speed = Playback{}.expansions_per_second;
  std::string link_address;  ///< of the page that links lead to; empty: the usual one
};
Remembered read_settings(const std::string& path);
/// Writes it atomically; makes the folder if need be.
Result<void> write_settings(const Remembered& settings, const std::string& path);

}  // namespace replan::app
