// What the page does for the program: page.js, called from here.
#pragma once

#include <string>

namespace replan::app {

/// Shows a sentence in the place of the program, which has come to its end.
void tell_page(const std::string& sentence);
/// The page is loaded: what it showed until then goes.
void reveal_page();
/// The page's own address, without a link.
std::string page_address();
/// The link in the page's address, from # on; empty if there is none.
std::string page_link();
/// The mouse's shape, by ImGui's number; below 0 it is hidden.
void set_page_cursor(int cursor);
/// Opens the browser's picker; what is chosen comes as if it were dropped. `extensions` as in HTML: ".json,.map".
void pick_file(const std::string& extensions);
/// Puts a text on the clipboard.
void copy_text(const char* text);
/// What was pasted last; stays valid until the next call.
const char* pasted_text();
/// Whether Ctrl and this key make the browser's own copy, cut or paste event.
bool is_clipboard_key(const char* key);
/// A press of that key, which the browser had kept from the window, with what else is held down; done when it returns.
void press_in_page(int key);
/// A character from the keyboard on the screen; 8 takes the one before it away, 10 ends the line.
void type_in_page(unsigned code_point);
/// Whether a field of text waits for that keyboard.
void set_page_typing(bool typing);
/// Whether fingers are what this page's pointer is made of.
bool page_is_touched();
/// Has the browser keep what was written to the page's home folder.
void keep_files();

}  // namespace replan::app
