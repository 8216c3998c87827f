// What goes to the clipboard and comes from it as text, and may take longer than a frame.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/background.hpp"
#include "core/base/deadline.hpp"
#include "core/export/case_text.hpp"
#include "core/session/session.hpp"
#include "core/trace/state_hash.hpp"
#include "core/world/formats/ascii_map.hpp"

namespace replan::ui {

/// The text of a moment, as that was when the copying began.
class StateCopy {
 public:
  StateCopy(const Session& session, const CaseFocus& focus);

  /// Goes on until the deadline; the whole text, once it is complete.
  std::optional<std::string> go_on(const Deadline& deadline);
  [[nodiscard]] std::size_t event() const { return draft_.event; }
  /// How much is done, 0 to 1.
  [[nodiscard]] double share() const { return hash_.share(); }

 private:
  CaseDraft draft_;
  StateHash hash_;
  Background<std::string> scenario_;
  std::optional<std::string> scenario_text_;
};

/// The text of cells that are being copied, and what to say once it is on the clipboard.
class CellsCopy {
 public:
  CellsCopy(const WorkPlace& place, MapFile world, const CellBox& region, std::string said);

  /// The text, once, when it is complete.
  std::optional<std::string> take() { return text_.take(); }
  [[nodiscard]] const std::string& said() const { return said_; }

 private:
  Background<std::string> text_;
  std::string said_;
};

/// Where cells are pasted.
struct PastePlace {
  Cell at;
  Box world;
  std::vector<Cell> keep_free;  ///< cells that no wall is put on
};

/// What a text on the clipboard was found to be.
struct PastedText {
  std::string link;                          ///< if it is one
  std::optional<Result<CaseMoment>> moment;  ///< else a moment as text, else cells
  Result<MapFile> cells = Error{""};
  PastePlace place;
  std::vector<CellChange> changes = {};  ///< of the world, if they are no world of their own
};
PastedText read_pasted(const std::string& text, const PastePlace& place);

/// The copying and the reading that go on between frames.
struct ClipboardWork {
  std::unique_ptr<StateCopy> copy;
  std::unique_ptr<CellsCopy> cells;
  std::unique_ptr<Background<PastedText>> paste;
  [[nodiscard]] bool busy() const { return copy || cells || paste; }
};

}  // namespace replan::ui
