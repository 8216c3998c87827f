// Everything that can be done, found by a few letters of its name.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/fuzzy.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

class WorldLibrary;

/// One thing to do, or a word to look up.
struct PaletteEntry {
  std::string id;     ///< tells it from all others, for what was used last
  std::string label;  ///< "Planner: DLD* Lite"
  std::string place;  ///< where else it is found: "View"
  std::string keys;
  std::string teach;
  const char* icon = "";
  bool enabled = true;
  std::string reason;  ///< why it is not enabled
  std::function<void(Frame&)> effect;
};
/// All that can be done now, in the order of the menus. `library` may be nullptr.
std::vector<PaletteEntry> palette_entries(Frame& frame, const WorldLibrary* library);

struct PaletteHit {
  std::size_t entry = 0;
  FuzzyMatch match;
};
/// The entries that what was typed can mean, the likeliest first: by the match, and those used last (the
/// latest first) before others that match about as well. Nothing typed: the ones used last, then all.
std::vector<PaletteHit> palette_hits(std::span<const PaletteEntry> entries, std::string_view typed,
                                     std::span<const std::string> used);

class CommandPalette {
 public:
  void show();
  [[nodiscard]] bool open() const { return open_; }
  /// Draws it if it is open, over everything but dialogs.
  void draw(Frame& frame, WorldLibrary* library);

 private:
  void choose_by_keys(std::size_t count);
  void draw_hits(Frame& frame, std::span<const PaletteEntry> entries, std::span<const PaletteHit> hits);
  void carry_out(Frame& frame, const PaletteEntry& entry);

  bool open_ = false, fresh_ = false;
  bool focus_ = false;  // what is typed next goes into the field
  std::string typed_;
  std::size_t chosen_ = 0;
  bool reveal_ = false;            // the chosen row is to be scrolled to
  std::vector<std::string> used_;  // ids, the latest first
};

}  // namespace replan::ui
