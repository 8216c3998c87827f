// The right side of the file dialog: the chosen world from afar, its facts, and how it is to be read.
#pragma once

#include <optional>
#include <string>

#include "core/base/background.hpp"
#include "ui/documents/file_list.hpp"
#include "ui/shell/dialogs/thumbnail_view.hpp"

namespace replan::ui {

class PreviewPane {
 public:
  PreviewPane(ImGuiRenderer& renderer, const WorkPlace& place) : job_(place), picture_(renderer) {}

  /// Turns to another file; nullptr: none is chosen.
  void show(const std::string& folder, const FileEntry* entry);
  void draw(const Look& look);
  /// How the file that is shown is to be read, as chosen in the pane.
  [[nodiscard]] const MapReading& reading() const { return reading_; }

 private:
  void begin();
  void draw_facts(const Look& look);
  void draw_reading(const Look& look);
  void draw_numbers(const Look& look);
  void draw_picture(const Look& look);
  void draw_heights(const Look& look);

  Background<Preview> job_;
  ThumbnailView picture_;
  std::string path_;
  FileEntry entry_;
  MapReading reading_;
  Preview preview_;
  std::optional<HeightRange> heights_;  // of the file, while one is chosen: they outlive a reading that fails
};

}  // namespace replan::ui
