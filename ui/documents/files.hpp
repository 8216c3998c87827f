// Opening and saving: what kinds of file there are and what becomes of them.
#pragma once

#include <string>
#include <vector>

#include "core/base/stop.hpp"
#include "core/session/session.hpp"
#include "core/world/map_reading.hpp"
#include "ui/canvas/canvas.hpp"

namespace replan::ui {

/// Reads a scenario (.json), or a map (.map, .png, ...) as a world with the start and goal of the file, else
/// with ones far apart in its largest open region, and with those planners and the robot of `current` that such a world
/// can have. Errors say what now. Slow for a large map: not for the drawing thread.
Result<Scenario> open_document(const std::string& path, const Scenario& current,
                               const MapReading& reading = {}, const StopToken& stop = {});
/// An all-free world with the planners and the robot of `current`.
Scenario empty_world(const Box& size, const Scenario& current);
/// Whether save_document() keeps everything that this file held, so that Ctrl+S may write to it without
/// asking; of a map file only as long as nothing but its cells was edited.
bool saves_in_place(const std::string& path);
bool saves_in_place(const Session& session);
/// Writes the scenario (.json, with the overlays of the view) or what a map format holds of it, atomically.
Result<void> save_document(const Session& session, const ViewState& view, const std::string& path);
/// The file's name, else the world's own.
std::string document_name(const Session& session);
/// What the window is about: "maze.json", with a mark if there are unsaved edits.
std::string document_title(const Session& session);
/// The session's own words if they need characters that the fonts do not hold at first: for Stage::set_language().
std::string uncommon_words(const Session& session, const std::string& also = {});
/// What is to be done with things that were dropped onto the window.
struct Dropped {
  std::string path;      ///< to be opened; empty: nothing
  bool folder = false;   ///< it is a folder to look into
  std::string sentence;  ///< what the user should be told; empty: nothing
};
/// Of several files one can be opened: a scenario rather than a map, and a map rather than a picture, which
/// may be a ROS map's own.
Dropped sort_out(const std::vector<std::string>& paths);
/// A path as typed by a user: without blanks around, "~" for the home folder.
std::string typed_path(const std::string& text);

}  // namespace replan::ui
