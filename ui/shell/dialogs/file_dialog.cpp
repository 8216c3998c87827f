// What the file dialog does. file_dialog_draw.cpp draws it.
#include "ui/shell/dialogs/file_dialog.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>

#include "core/base/file.hpp"
#include "core/link/link.hpp"
#include "ui/documents/files.hpp"
#include "ui/keys.hpp"

namespace replan::ui {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
  std::error_code failed;
  return fs::is_directory(path, failed);
}

bool is_there(const std::string& path) {
  std::error_code failed;
  return fs::exists(path, failed);
}

bool is_path(const std::string& typed) {
  return typed.find('/') != std::string::npos || typed == "~" || typed == "..";
}

/// The extension of that kind that a name ends in, if it does.
std::string_view extension_of(const FileFilter& filter, std::string_view name) {
  for (const std::string& each : filter.extensions)
    if (name.ends_with(each)) return each;
  return {};
}

}  // namespace

FileDialog::FileDialog(ImGuiRenderer& renderer, const WorkPlace& place, FileDialogSpec spec)
    : spec_(std::move(spec)), reader_(place), preview_(renderer, place) {
  std::error_code failed;
  const std::string here = fs::current_path(failed).string();
  const std::string path = spec_.path.empty() ? here : typed_from(here, spec_.path);
  const bool folder = is_folder(path);
  const std::string name = folder ? "" : file_name(path);
  int kind = 0;
  for (std::size_t i = 0; i < spec_.filters.size(); ++i)
    if (spec_.saving && !extension_of(spec_.filters[i], name).empty()) kind = static_cast<int>(i);
  set_kind(kind);
  if (spec_.saving) set_text(name);
  came_from_ = name;
  go(spec_.fixed                    ? spec_.fixed->path
     : folder                       ? path
     : is_folder(file_folder(path)) ? file_folder(path)
                                    : here);
}

void FileDialog::go(const std::string& folder) {
  folder_ = shown_ = folder;
  error_.clear();
  if (!spec_.saving) set_text("");
  read();
}

void FileDialog::go_up() {
  const std::string above = fs::path(shown_).parent_path().string();
  if (above == shown_ || above.empty()) return;
  came_from_ = file_name(shown_);
  go(above);
}

void FileDialog::read() {
  if (spec_.fixed)
    return reader_.start([entries = spec_.fixed->entries](const StopToken&) { return entries; });
  reader_.start([folder = shown_](const StopToken&) { return read_folder(folder); });
}

/// Shows the folder of a path that is being typed, with what is called as its last part begins.
void FileDialog::follow_text() {
  std::string folder = folder_, rest = text_;
  if (!spec_.saving && is_link(text_)) {
    rest.clear();  // no name of a file
  } else if (is_path(text_)) {
    const std::string path = typed_from(folder_, typed_path(text_));
    const bool whole = is_folder(path);
    folder = whole ? path : file_folder(path);
    rest = whole ? "" : file_name(path);
  }
  const bool there = is_folder(folder);
  if (there && folder != shown_) {
    shown_ = folder;
    came_from_ = rest;
    read();
  }
  if (spec_.saving)
    list_.jump_to(rest);
  else
    list_.set_search(there ? rest : "");
  scroll_ = true;
}

void FileDialog::set_kind(int filter) {
  filter_ = filter;
  const FileFilter& kind = spec_.filters[static_cast<std::size_t>(filter)];
  list_.set_filter(kind);
  if (spec_.saving && spec_.losses) lost_ = spec_.losses(kind.extensions.front());
}

/// Puts text into the field, also while it is being typed in.
void FileDialog::set_text(std::string text) {
  text_ = std::move(text);
  ++generation_;
  if (!spec_.saving) follow_text();
}

void FileDialog::open_entry(const FileEntry& entry) {
  const std::string path = typed_from(shown_, entry.name);
  if (entry.kind == FileKind::folder)
    go(path);
  else
    choose(path);
}

/// What Enter and the primary button do.
void FileDialog::accept() {
  const std::string typed = typed_path(text_);
  if (!spec_.saving && is_link(typed)) {
    choice_ = {Answer::yes, typed, {}};
    return;
  }
  const FileEntry* entry = list_.selected();
  if (typed.empty() || (!spec_.saving && !is_path(typed) && entry != nullptr)) {
    if (entry != nullptr) open_entry(*entry);
    if (entry == nullptr && typed.empty())
      error_ = spec_.saving ? "Type a name for the file." : "Choose a file, or type its path.";
    return;
  }
  const std::string path = typed_from(folder_, typed);
  if (is_folder(path)) {
    if (spec_.saving) set_text("");
    go(path);
  } else if (spec_.saving) {
    choose(with_extension(path));
  } else if (is_there(path)) {
    choose(path);
  } else if (entry != nullptr) {
    open_entry(*entry);  // the one that is called so, as far as it was typed
  } else {
    error_ = is_path(typed) ? "There is no file '" + path + "'; Tab completes what is there."
                            : "No file here has '" + typed + "' in its name.";
  }
}

/// What is typed, else the folder that is chosen in the list, else the one on show.
std::string FileDialog::chosen_folder() const {
  const FileEntry* entry = list_.selected();
  const std::string typed = typed_path(text_);
  if (!typed.empty() && (is_path(typed) || entry == nullptr)) return typed_from(folder_, typed);
  return entry != nullptr ? typed_from(shown_, entry->name) : shown_;
}

/// Enter goes into the folder that is chosen in the list, as in every file dialog; the button takes it.
void FileDialog::accept_folder(bool by_key) {
  const std::string folder = chosen_folder();
  const FileEntry* entry = list_.selected();
  if (by_key && entry != nullptr && !is_path(typed_path(text_))) return go(folder);
  std::error_code failed;
  if (is_there(folder) && !is_folder(folder))
    error_ = "'" + file_name(folder) + "' is a file: choose a folder.";
  else
    choice_ = {Answer::yes, folder, {}};
}

void FileDialog::choose(const std::string& path) {
  error_.clear();
  std::error_code failed;
  const std::string place = file_folder(path.ends_with('/') ? path.substr(0, path.size() - 1) : path);
  if (spec_.saving && !fs::is_directory(place, failed)) {
    error_ = "There is no folder '" + place + "'; make it first, or choose another.";
  } else if (spec_.saving && is_there(path)) {
    pending_ = path;
    mode_ = Mode::replace;
  } else {
    choice_ = {Answer::yes, path, preview_.reading()};
  }
}

/// The path with the extension of the chosen kind, unless it has that of another kind.
std::string FileDialog::with_extension(std::string path) const {
  for (const FileFilter& filter : spec_.filters)
    if (!extension_of(filter, path).empty()) return path;
  return path + spec_.filters[static_cast<std::size_t>(filter_)].extensions.front();
}

/// What is typed with the extension of the chosen kind in place of its own.
std::string FileDialog::with_chosen_extension() const {
  std::string stem = text_;
  for (const FileFilter& filter : spec_.filters)
    if (const auto extension = extension_of(filter, text_); !extension.empty())
      stem.resize(text_.size() - extension.size());
  if (stem == text_) stem = file_stem(text_);
  return stem + spec_.filters[static_cast<std::size_t>(filter_)].extensions.front();
}

void FileDialog::make_folder() {
  const std::string path = typed_from(shown_, text_);
  if (typed_path(text_).empty()) {
    error_ = "Type a name for the folder.";
    return;
  }
  if (::mkdir(path.c_str(), 0777) != 0) {
    error_ = "Cannot make '" + path + "': " + std::generic_category().message(errno) + ".";
    return;
  }
  mode_ = Mode::browse;
  set_text(pending_);
  go(path);
}

void FileDialog::take_keys() {
  const auto pressed = [](int key, bool repeats) { return ImGui::IsKeyPressed(key, repeats); };
  const int page = 12;
  const int by = (pressed(key::kDown, true) ? 1 : 0) -
                 (pressed(key::kUp, true) && !ImGui::GetIO().KeyAlt ? 1 : 0) +
                 (pressed(key::kPageDown, true) ? page : 0) - (pressed(key::kPageUp, true) ? page : 0);
  if (by != 0) {
    list_.move(by);
    scroll_ = true;
    const FileEntry* entry = list_.selected();
    if (spec_.saving && entry != nullptr) set_text(entry->kind == FileKind::folder ? "" : entry->name);
  }
  if (pressed(key::kUp, false) && ImGui::GetIO().KeyAlt) go_up();
  if (ImGui::GetIO().KeyCtrl && pressed('H', false)) list_.set_hidden(!list_.hidden());
}

}  // namespace replan::ui
