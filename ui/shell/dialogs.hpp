// The window's dialogs: one at a time, over everything else.
#pragma once

#include <optional>
#include <string>

#include "ui/shell/frame.hpp"

namespace replan::ui {

enum class DialogKind : std::uint8_t { none, open, save, new_world, unsaved, keys, film, picture };

/// What the user decided.
struct Decision {
  enum class Kind : std::uint8_t {
    none,
    open,
    save,
    new_world,
    capture,
    save_first,
    discard,
    cancel
  } kind = Kind::none;
  std::string path;  ///< for open, save and capture
  int width = 0;     ///< for new_world
  int height = 0;
  int fps = 0;  ///< for capture of a film
};

class Dialogs {
 public:
  /// Shows a dialog at the next draw. `text`: the path to begin with, or for `unsaved` the name of what is
  /// unsaved.
  void show(DialogKind kind, std::string text = {});
  void close() { kind_ = DialogKind::none; }
  /// Shows a sentence in the open path dialog: what went wrong, and what now.
  void complain(std::string sentence) { error_ = std::move(sentence); }
  [[nodiscard]] bool open() const { return kind_ != DialogKind::none; }

  /// Draws the open dialog, if any, and returns what was decided in this frame.
  Decision draw(const Look& look);

 private:
  Decision content(const Look& look);
  Decision path_dialog(const Look& look, bool saving);
  Decision capture_dialog(const Look& look, bool film);
  Decision new_world_dialog(const Look& look);
  Decision unsaved_dialog(const Look& look);
  Decision keys_dialog(const Look& look);

  DialogKind kind_ = DialogKind::none;
  bool fresh_ = false;  // to be opened by this draw
  std::string text_;
  std::string error_;
  double width_ = 48, height_ = 32, fps_ = 30;
};

}  // namespace replan::ui
