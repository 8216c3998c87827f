#include "ui/documents/questions.hpp"

#include "ui/shell/format.hpp"

namespace replan::ui {

Question unsaved_question(const std::string& name, std::size_t edits, const std::string& since) {
  const std::string has =
      "'" + name + "' has " + count_text(static_cast<std::int64_t>(edits), "unsaved edit", "unsaved edits");
  const std::string dated = since.empty() ? has + "." : has + " since " + since + ".";
  const std::string words =
      dated + (edits == 1 ? " It is lost unless you save it." : " They are lost unless you save them.");
  return {.title = "Save the changes?",
          .words = words,
          .primary = {"Save", DialogDecision::Kind::save_first},
          .danger = Question::Choice{"Discard", DialogDecision::Kind::discard}};
}

Question changed_question(const std::string& file, const std::string& document, bool map, std::size_t edits) {
  std::string words = map ? "The map of " + document : "It";
  words += " was written by another program since it was opened here.";
  if (edits > 0)
    words += " Your " + count_text(static_cast<std::int64_t>(edits), "unsaved edit is", "unsaved edits are") +
             " lost by reading it again.";
  const Question::Choice reload{"Reload", DialogDecision::Kind::reload},
      keep{"Keep mine", DialogDecision::Kind::keep_mine};
  Question question{.title = file + " has changed on disk", .words = words, .primary = reload, .quiet = keep};
  if (edits > 0) {
    question.primary = {"Save as…", DialogDecision::Kind::save_elsewhere};
    question.danger = reload;
  }
  return question;
}

Question overwrite_question(const std::string& file) {
  return {
      .title = "Write over the other version?",
      .words = file +
               " was written by another program since it was opened here. Saving puts your version in its "
               "place.",
      .primary = {"Save as…", DialogDecision::Kind::save_elsewhere},
      .danger = Question::Choice{"Overwrite", DialogDecision::Kind::overwrite}};
}

Question unfinished_question() {
  return {
      .title = "Quit before the file is done?",
      .words = "A film or a trace is still being made. If you quit now, it is given up and no file is left.",
      .primary = {"Go on with it", DialogDecision::Kind::cancel},
      .quiet = {""},
      .danger = Question::Choice{"Quit", DialogDecision::Kind::discard}};
}

}  // namespace replan::ui
