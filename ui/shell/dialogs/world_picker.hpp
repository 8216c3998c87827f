// The picker: the library's worlds as cards with a thumbnail, to be chosen by keyboard or mouse.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/documents/world_library.hpp"
#include "ui/shell/dialogs/file_dialog.hpp"
#include "ui/shell/dialogs/thumbnail_view.hpp"

namespace replan::ui {

class WorldPicker {
 public:
  WorldPicker(ImGuiRenderer& renderer, WorldLibrary& library);

  /// Draws into the current window, to its given height.
  FileChoice draw(const Look& look, float height);
  void complain(std::string sentence) { error_ = std::move(sentence); }
  [[nodiscard]] std::string words() const;

 private:
  struct Card {
    std::string path;
    FileStamp stamp;
    std::unique_ptr<ThumbnailView> picture;
  };

  ThumbnailView* picture_of(const LibraryWorld& world);
  void take_keys(std::size_t count, std::size_t columns);
  void draw_cards(const Look& look);
  void draw_card(const Look& look, const LibraryWorld& world, ImVec2 size, bool chosen);

  ImGuiRenderer& renderer_;
  WorldLibrary& library_;
  std::vector<Card> cards_;
  std::string text_;
  std::string error_;
  std::size_t selected_ = 0;
  bool scroll_ = false;
  FileChoice choice_;
};

}  // namespace replan::ui
