// The file dialog: a folder's files to walk through by keyboard or mouse, one to be chosen or named. It needs
// no help of the desktop.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/dialogs/preview_pane.hpp"

namespace replan::ui {

/// A folder at the left of the dialog.
struct Place {
  const char* icon;
  std::string label;
  std::string path;
};

/// A folder that is not looked for on the disk: pictures of the dialog are the same on every machine.
struct FixedFolder {
  std::string path;  ///< as it is shown
  std::vector<FileEntry> entries;
  std::string files;  ///< the folder where previews find those files
};

struct FileDialogSpec {
  bool saving = false;
  bool folders = false;             ///< a folder is chosen: the one on show, one in it, or one that is typed
  std::string title;                ///< "Open"
  std::string action;               ///< on the button: "Open"
  std::vector<FileFilter> filters;  ///< at least one; the first that knows the path's extension is chosen
  std::string path;                 ///< to begin with: a folder, or a file in one
  std::vector<Place> places;
  /// When saving: what a file with that extension cannot hold, a sentence each.
  std::function<std::vector<std::string>(const std::string& extension)> losses;
  /// What else there is to choose, drawn above the buttons for the name as it stands, and how high that is in the design.
  std::function<void(const Look& look, const std::string& name)> options = {};
  float options_height = 0;
  /// What stands at the right in place of a look at the chosen file, for the name as it stands, or the folder that would
  /// be chosen; when saving without it, nothing does.
  std::function<void(const Look& look, const std::string& name)> aside = {};
  std::optional<FixedFolder> fixed = {};  ///< in place of the disk
};

struct FileChoice {
  Answer answer = Answer::none;
  std::string path;
  MapReading reading;
};

class FileDialog {
 public:
  FileDialog(ImGuiRenderer& renderer, const WorkPlace& place, FileDialogSpec spec);

  /// Draws into the current window, to its given height.
  FileChoice draw(const Look& look, float height);
  /// Says what went wrong with the chosen file.
  void complain(std::string sentence) { error_ = std::move(sentence); }
  /// Where the dialog stands: the next one begins there.
  [[nodiscard]] const std::string& folder() const { return shown_; }
  [[nodiscard]] bool saving() const { return spec_.saving; }
  /// All names of the folder, for the fonts: the same ones while the user types.
  [[nodiscard]] std::string words() const { return shown_ + names_; }

 private:
  enum class Mode : std::uint8_t { browse, replace, new_folder };

  void go(const std::string& folder);
  void go_up();
  void read();
  void follow_text();
  void set_kind(int filter);
  void set_text(std::string text);
  void open_entry(const FileEntry& entry);
  void accept();
  void accept_folder(bool by_key);
  [[nodiscard]] std::string chosen_folder() const;
  void choose(const std::string& path);
  void make_folder();
  [[nodiscard]] std::string with_extension(std::string path) const;
  [[nodiscard]] std::string with_chosen_extension() const;
  void take_keys();
  void draw_head(const Look& look);
  void draw_crumbs(const Look& look);
  void draw_field(const Look& look);
  void draw_places(const Look& look);
  void draw_list(const Look& look);
  void draw_row(const Look& look, std::size_t index);
  void draw_header(const Look& look);
  void draw_losses(const Look& look);
  void draw_foot(const Look& look);
  void draw_question(const Look& look);

  FileDialogSpec spec_;
  Background<Result<std::vector<FileEntry>>> reader_;
  PreviewPane preview_;
  FileList list_;
  std::string folder_;             // where the user has gone to: what is typed counts from there
  std::string shown_;              // that, or the folder of a path that is being typed
  std::string came_from_;          // the entry to choose once the folder is read
  std::string text_;               // what stands in the field
  std::string names_;              // all that were found
  std::string error_;              // of the chosen file
  std::string unreadable_;         // why the folder is not shown
  std::vector<std::string> lost_;  // of a document in the chosen kind of file
  int filter_ = 0;
  Mode mode_ = Mode::browse;
  std::string pending_;   // the path that the question is about
  int generation_ = 0;    // of the field: ImGui keeps the text of a field that is being typed in
  bool scroll_ = false;   // to the chosen row
  bool replaces_ = true;  // the next key takes the place of the name that was proposed
  FileChoice choice_;
};

}  // namespace replan::ui
