// Unsaved work that outlives its program: written every few seconds, found again at the next start.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/background.hpp"
#include "core/base/lock_file.hpp"
#include "core/session/session.hpp"

namespace replan {

/// What is known of an autosave without reading its world.
struct AutosaveNote {
  std::string file;            ///< that it was opened from; empty for a world without one
  std::string name;            ///< of the world
  std::size_t edits = 0;       ///< that are not in the file
  std::int64_t edited_at = 0;  ///< seconds since 1970
  std::size_t scripted = 0;    ///< as Session::scripted()
  std::string map_file;        ///< as Scenario::map_file: the autosave itself holds all cells
  friend bool operator==(const AutosaveNote&, const AutosaveNote&) = default;
};

/// The note and the world as JSON; the first line alone tells the note.
std::string autosave_text(const AutosaveNote& note, const Scenario& scenario);
Result<AutosaveNote> read_autosave_note(const std::string& path);
/// The whole of it, ready to be taken up: the same world, script and settings as when it was written.
Result<ReplaceScenario> read_autosave(const std::string& path);

/// An autosave whose program no longer lives. Holding it keeps other programs from offering it too.
struct Orphan {
  AutosaveNote note;
  std::string path;
  LockFile lock;
};
/// All of them, the latest first. What cannot be read is left where it is.
std::vector<Orphan> find_orphans(const std::string& folder);
/// Removes an autosave for good.
void discard(Orphan orphan);

/// Writes the autosaves of one session. tick() is cheap; the writing is done off the caller's thread.
class Autosaver {
 public:
  /// Seconds after the last edit, and after the first one that was not written while edits go on.
  static constexpr double kQuietSeconds = 5, kLongestSeconds = 30;

  /// No folder: never writes.
  explicit Autosaver(std::string folder = {}, WorkPlace place = {});
  ~Autosaver();

  /// Looks whether something is to be done. `seconds` is any clock that runs on; while `in_stroke` (a mouse
  /// button is down) nothing is begun.
  void tick(const Session& session, double seconds, bool in_stroke);
  /// Goes on in the place of one whose work was taken up: it is kept until the session is saved.
  void adopt(Orphan orphan, const Session& session);
  /// The work is safe, or not wanted: removes the autosave. For a clean end.
  void remove();
  /// Why the last autosave failed, once.
  std::string take_failure() { return std::exchange(failure_, {}); }
  /// Where the autosave lies; empty if there is none.
  [[nodiscard]] std::string path() const { return written_ ? path_ : ""; }

 private:
  void write(const Session& session);
  void take_result();

  std::string folder_, path_;
  std::optional<LockFile> lock_;
  std::optional<Background<Result<void>>> job_;
  std::optional<std::uint64_t> seen_, written_;  // states of the document
  double last_edit_ = 0, first_edit_ = 0;
  std::int64_t edited_at_ = 0;
  std::string failure_;
};

}  // namespace replan
