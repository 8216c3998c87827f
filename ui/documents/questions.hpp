// What is asked about documents before something of them is lost.
#pragma once

#include <cstddef>
#include <string>

#include "ui/shell/dialogs.hpp"

namespace replan::ui {

/// Before another document takes the place of one with edits that are in no file. `since`: the time of the first of
/// them, if it is known.
Question unsaved_question(const std::string& name, std::size_t edits, const std::string& since);
/// Another program has written `file`, the document's own or its map's, while it was open.
Question changed_question(const std::string& file, const std::string& document, bool map, std::size_t edits);
/// Saving would put this version in the place of another program's.
Question overwrite_question(const std::string& file);
/// The program is to end while a film or a trace is being made.
Question unfinished_question();

}  // namespace replan::ui
