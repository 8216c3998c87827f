// The edits of a document: what undo takes back and redo brings back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/session/document_change.hpp"

namespace replan {

/// How far the runs of a session had come and where their cursors stood.
struct RunPositions {
  std::vector<std::size_t> lengths, cursors;
  bool follow = true;  ///< the cursors stood at the ends of the logs, and went with them
};

/// Edits in order, those that were taken back behind those that are made. Each knows where the runs stood when it was
/// left, so that undo and redo lead there again.
class History {
 public:
  /// Of a document with so many surprises that are no edits.
  explicit History(std::size_t scripted) : scripted_(scripted) {}
  /// Begins anew; `unsaved` edits came with the document.
  void begin(std::size_t scripted, std::size_t unsaved);

  /// An edit changes the scenario, the runs standing at `now`, and leaves it with `scripted` surprises that are no
  /// edits. What was taken back before is forgotten. False if it goes on with a stroke, as part of the
  /// edit before.
  bool add(const std::string& label, std::uint64_t stroke, DocumentChange change, std::size_t scripted,
           RunPositions now);
  /// Whether an edit of that stroke would be part of the last one; 0 is no stroke.
  [[nodiscard]] bool goes_on(std::uint64_t stroke) const {
    return stroke != 0 && !done_.empty() && done_.back().stroke == stroke;
  }
  /// The last edit changed only what is looked at: it can be taken back, but nothing is lost if it is not saved.
  void excuse_last() { done_.back().is_lost = false; }
  void relabel(const std::string& label) { done_.back().label = label; }

  /// Takes the last edit back, or brings the last one back that was; there must be one. `now` is where the runs
  /// stand; where they shall stand is returned.
  RunPositions undo(Scenario& scenario, RunPositions now);
  RunPositions redo(Scenario& scenario, RunPositions now);

  /// How many edits are made, of all that there are.
  [[nodiscard]] std::size_t position() const { return done_.size(); }
  [[nodiscard]] std::size_t size() const { return done_.size() + undone_.size(); }
  /// What undo() would take back and redo() bring back; empty if nothing.
  [[nodiscard]] std::string undo_text() const { return done_.empty() ? "" : done_.back().label; }
  [[nodiscard]] std::string redo_text() const { return undone_.empty() ? "" : undone_.back().label; }
  /// All of them, oldest first.
  [[nodiscard]] std::vector<std::string> labels() const;

  /// Another number after every edit, the same one where edits and undo have led back to the same document.
  [[nodiscard]] std::uint64_t document_state() const;
  [[nodiscard]] bool modified() const { return document_state() != saved_at_ || taken_up_ > 0; }
  /// How many edits lie between the document and its file; 0 if and only if it is not modified.
  [[nodiscard]] std::size_t unsaved() const;
  void saved();

  /// How many of the document's surprises came with it; the later ones are edits of the running mission.
  [[nodiscard]] std::size_t scripted() const { return scripted_; }

 private:
  struct Edit {
    std::string label;
    std::uint64_t stroke = 0;
    std::uint64_t serial = 0;  // of the document's state after it
    bool is_lost = true;       // if it is not saved
    DocumentChange change;
    std::size_t scripted_before = 0, scripted_after = 0;
    RunPositions left, undone;  // when it was made, and when it was taken back
  };

  std::vector<Edit> done_, undone_;
  std::uint64_t serials_ = 0, saved_at_ = 0;
  std::size_t taken_up_ = 0;  // unsaved edits that came with the document
  std::size_t scripted_;
};

}  // namespace replan
