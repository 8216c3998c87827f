// What the file dialog does. file_dialog_draw.cpp draws it.
#include "ui/shell/dialogs/file_dialog.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>

#include "core/base/file.hpp"
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

bool knows(const FileFilter& filter, const std::string& extension) {
  return std::find(filter.extensions.begin(), filter.extensions.end(), extension) != filter.extensions.end();
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
    if (spec_.saving && knows(spec_.filters[i], file_extension(name))) kind = static_cast<int>(i);
  set_kind(kind);
  if (spec_.saving) set_text(name);
  came_from_ = name;
  go(folder ? path : is_folder(file_folder(path)) ? file_folder(path) : here);
}

void FileDialog::go(const std::string& folder) {
  folder_ = folder;
  error_.clear();
  if (!spec_.saving) set_text("");
  read();
}

void FileDialog::go_up() {
  const std::string above = fs::path(folder_).parent_path().string();
  if (above == folder_ || above.empty()) return;
  came_from_ = file_name(folder_);
  go(above);
}

void FileDialog::read() {
  reader_.start([folder = folder_](const std::stop_token&) { return read_folder(folder); });
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
  if (!spec_.saving) list_.set_search(is_path(text_) ? "" : text_);
}

void FileDialog::open_entry(const FileEntry& entry) {
  const std::string path = typed_from(folder_, entry.name);
  if (entry.kind == FileKind::folder)
    go(path);
  else
    choose(path);
}

/// What Enter and the primary button do.
void FileDialog::accept() {
  const std::string typed = typed_path(text_);
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
  } else {
    error_ = is_path(typed) ? "There is no file '" + path + "'; Tab completes what is there."
                            : "No file here has '" + typed + "' in its name.";
  }
}

void FileDialog::choose(const std::string& path) {
  error_.clear();
  std::error_code failed;
  if (spec_.saving && !fs::is_directory(file_folder(path), failed)) {
    error_ = "There is no folder '" + file_folder(path) + "'; make it first, or choose another.";
  } else if (spec_.saving && is_there(path)) {
    pending_ = path;
    mode_ = Mode::replace;
  } else {
    choice_ = {Answer::yes, path, preview_.reading()};
  }
}

/// The path with the extension of the chosen kind, unless it has that of another kind.
std::string FileDialog::with_extension(std::string path) const {
  const std::string extension = file_extension(path);
  for (const FileFilter& filter : spec_.filters)
    if (knows(filter, extension)) return path;
  return path + spec_.filters[static_cast<std::size_t>(filter_)].extensions.front();
}

void FileDialog::make_folder() {
  const std::string path = typed_from(folder_, text_);
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
