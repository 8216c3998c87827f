// What the dialogs are made of: heading, the row of buttons, and the keys that answer them.
#pragma once

#include <string>
#include <string_view>

#include "ui/look.hpp"

namespace replan::ui {

/// How many lists of choices are open over the dialog: keys are for those.
int open_lists();
/// Escape, for the dialog: while a list is open over it that is closed, and this is false.
bool escape_pressed();
bool enter_pressed();

/// The dialog's name, in the largest face.
void heading(const Look& look, std::string_view words);
/// Puts the cursor so that controls of this total width end at the right edge.
void align_right(float width);
/// How wide button() draws that label.
float button_width(const Look& look, const char* label, const char* icon = "");
/// Puts the cursor beside the last item where so much room is left there, else it stays below.
void flow(const Look& look, float width);

/// What the row of buttons at the bottom of a dialog was answered with.
enum class Answer : std::uint8_t { none, yes, no };
/// "Cancel" and the primary button at the lower right; Escape and Enter are the same.
Answer confirm(const Look& look, const char* yes, const char* no = "Cancel");

/// A fact of what is told of at the right of the file dialog: its name, and its value in the face of numbers.
void fact(const Look& look, const char* name, const std::string& value);

}  // namespace replan::ui
