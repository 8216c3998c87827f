// What a file dialog shows of a folder, and how it is typed and walked through: all of it but the drawing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace replan::ui {

enum class FileKind : std::uint8_t { folder, scenario, map, picture, problems, experiment, results, other };

struct FileEntry {
  std::string name;
  FileKind kind = FileKind::other;
  std::uint64_t size = 0;     ///< bytes; 0 for folders
  std::int64_t modified = 0;  ///< seconds since 1970
  friend bool operator==(const FileEntry&, const FileEntry&) = default;
};

/// What the dialog offers to choose from: "Worlds", with the extensions that belong to it.
struct FileFilter {
  std::string label;
  std::vector<std::string> extensions;  ///< in lower case, with their dots; empty: all files
};

enum class FileOrder : std::uint8_t { name, size, date };

/// What kind of document a file name promises.
FileKind kind_of(std::string_view name);
/// "Scenario", "MovingAI map", "picture": for a list.
std::string kind_text(const FileEntry& entry);

/// Whether `a` comes before `b` as people count: letters without their case, runs of digits as numbers, so
/// that "map 2" comes before "map 10".
bool natural_less(std::string_view a, std::string_view b);
/// Whether `text` holds `part`, whatever the case of Latin letters; an empty part is in all.
bool holds(std::string_view text, std::string_view part);

/// All that is in a folder, unsorted, or why it cannot be read: it is gone, it is no folder, its owner
/// forbids it. Of a file that vanishes meanwhile nothing is said. A folder of more than kMostFiles is cut off
/// there.
inline constexpr std::size_t kMostFiles = 50000;
Result<std::vector<FileEntry>> read_folder(const std::string& folder);

/// Which of a folder's entries are shown, in which order, and which one is chosen.
class FileList {
 public:
  void take(std::vector<FileEntry> entries);
  void set_filter(const FileFilter& filter);
  /// Shows only names that hold this.
  void set_search(std::string_view text);
  void set_hidden(bool shown);
  /// Folders come first in any order. The same order again turns it around.
  void sort_by(FileOrder order);

  [[nodiscard]] std::span<const FileEntry> entries() const { return shown_; }
  [[nodiscard]] FileOrder order() const { return order_; }
  [[nodiscard]] bool descending() const { return descending_; }
  [[nodiscard]] bool hidden() const { return hidden_; }
  /// How many entries the filter, the search and the switch for hidden files keep out of sight.
  [[nodiscard]] std::size_t left_out() const { return all_.size() - shown_.size(); }

  /// The chosen entry, or nullptr.
  [[nodiscard]] const FileEntry* selected() const;
  [[nodiscard]] std::size_t selected_index() const { return selected_; }
  void select(std::size_t index) { selected_ = index; }
  /// Chooses the entry of that name; false if it is not shown.
  bool select(std::string_view name);
  /// Chooses the first entry whose name begins with this, whatever the case.
  void jump_to(std::string_view beginning);
  /// Goes up or down the list, and stays at its ends.
  void move(int by);
  void deselect() { selected_ = kNone; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  [[nodiscard]] bool is_shown(const FileEntry& entry) const;
  void refresh();

  std::vector<FileEntry> all_, shown_;
  FileFilter filter_;
  std::string search_;
  bool hidden_ = false;
  FileOrder order_ = FileOrder::name;
  bool descending_ = false;
  std::size_t selected_ = kNone;
};

/// A part of a path, and the path up to it.
struct Crumb {
  std::string name;
  std::string path;
};
/// "/home/ann/maps": "/", "home", "ann", "maps".
std::vector<Crumb> crumbs(const std::string& folder);

/// What was typed, seen from `folder`: absolute, "~" for the home folder, without ".." and blanks around it.
std::string typed_from(const std::string& folder, std::string_view typed);
/// What the Tab key makes of a typed path: as many letters more as all files and folders that begin so have
/// in common; a folder that stands alone gets its slash.
std::string completed(const std::string& folder, const std::string& typed);

}  // namespace replan::ui
