// Every dialog and menu of the window by a name, with contents that are the same on every machine: for pictures.
#pragma once

#include <string_view>
#include <vector>

#include "ui/batch/batch_dialog.hpp"
#include "ui/documents/documents.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/world_dialogs.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

/// What of a window its dialogs are shown with.
struct GalleryRoom {
  const Session& session;
  Dialogs& dialogs;
  WorldDialogs& world_dialogs;
  Documents& documents;
  ViewState& view;
  PanelState& panels;
  BatchDialog& batch;
};

/// The names, in the order of the menus.
std::vector<std::string_view> gallery_names();
/// Shows that dialog from the next frame on; false if there is none of that name.
bool show_from_gallery(std::string_view name, const GalleryRoom& room);

}  // namespace replan::ui
