// Opening and saving: what kinds of file there are and what becomes of them.
#pragma once

#include <string>

#include "core/session/session.hpp"
#include "ui/canvas.hpp"

namespace replan::ui {

/// Reads a scenario (.json), or a map (.map, .png, ...) as a world with a start and a goal far apart in its
/// largest open region, and with the planners and the robot of `current`. Errors say what now.
Result<Scenario> open_document(const std::string& path, const Scenario& current);
/// An all-free world with the planners and the robot of `current`.
Scenario empty_world(int width, int height, const Scenario& current);
/// Whether save_document() keeps everything that this file held, so that Ctrl+S may write to it without
/// asking.
bool saves_in_place(const std::string& path);
/// Writes the scenario (.json, with the overlays of the view) or the cells alone (.map), atomically.
Result<void> save_document(const Session& session, const ViewState& view, const std::string& path);
/// The file's name, else the world's own.
std::string document_name(const Session& session);
/// A path as typed by a user: without blanks around, "~" for the home folder.
std::string typed_path(const std::string& text);

}  // namespace replan::ui
