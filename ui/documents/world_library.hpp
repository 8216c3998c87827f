// The worlds that the picker shows: found and looked at off the drawing thread, one after the other.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "core/base/background.hpp"
#include "ui/documents/file_watch.hpp"
#include "ui/documents/preview.hpp"

namespace replan::ui {

struct LibraryWorld {
  std::string path;
  FileStamp stamp;
  bool looked_at = false;
  Preview preview;
  /// Its name, else that of its file.
  [[nodiscard]] std::string title() const;
};

class WorldLibrary {
 public:
  explicit WorldLibrary(std::string folder = {}, WorkPlace place = {});

  /// Looks for new, changed and lost files; what is known of the others stays.
  void refresh();
  /// Takes over what was looked at meanwhile. True if something has come.
  bool update();
  [[nodiscard]] bool busy() const { return finder_->busy() || reader_->busy(); }

  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// By their paths. They stay where they are until the next refresh().
  [[nodiscard]] const std::vector<LibraryWorld>& worlds() const { return worlds_; }
  /// The indices of the worlds whose name, caption or file name holds all words of the text.
  [[nodiscard]] std::vector<std::size_t> found(std::string_view text) const;

 private:
  void read_next();

  struct Read {
    std::size_t index;
    Preview preview;
  };
  std::string folder_;
  std::vector<LibraryWorld> worlds_;
  std::unique_ptr<Background<std::vector<StampedFile>>> finder_;
  std::unique_ptr<Background<Read>> reader_;
};

}  // namespace replan::ui
