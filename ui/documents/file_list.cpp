#include "ui/documents/file_list.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>

#include "core/base/file.hpp"
#include "core/world/map_file.hpp"
#include "ui/documents/files.hpp"

namespace replan::ui {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The run of digits at the beginning, without zeros before it.
std::string_view number_at(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  std::size_t begin = 0;
  while (begin + 1 < end && text[begin] == '0') ++begin;
  return text.substr(begin, end - begin);
}

std::size_t digits(std::string_view text) {
  std::size_t count = 0;
  while (count < text.size() && is_digit(text[count])) ++count;
  return count;
}

/// -1, 0, 1; equal only if the two differ in nothing but case and zeros before numbers.
int natural_compare(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view x = number_at(a), y = number_at(b);
      if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
      if (const int order = x.compare(y); order != 0) return order;
      a.remove_prefix(digits(a));
      b.remove_prefix(digits(b));
      continue;
    }
    const auto x = static_cast<unsigned char>(lower(a.front())),
               y = static_cast<unsigned char>(lower(b.front()));
    if (x != y) return x < y ? -1 : 1;
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  return a.empty() ? (b.empty() ? 0 : -1) : 1;
}

bool begins(std::string_view text, std::string_view beginning) {
  return text.size() >= beginning.size() && std::equal(beginning.begin(), beginning.end(), text.begin(),
                                                       [](char x, char y) { return lower(x) == lower(y); });
}

/// Of files whose extension other programs use too, or several of our own: what they are by their beginning.
FileKind kind_inside(const fs::path& path, FileKind promised) {
  const std::string extension = file_extension(path.filename().string());
  const bool json = extension == ".json", yaml = extension == ".yaml" || extension == ".yml";
  if (!json && !yaml) return promised;
  constexpr std::size_t kBeginning = 64 << 10;
  std::ifstream file(path, std::ios::binary);
  std::string text(kBeginning, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  const auto has = [&text](const char* word) { return text.find(word) != std::string::npos; };
  if (yaml) return has("image") && has("resolution") ? promised : FileKind::other;
  // A folder's batch.json holds its experiment.
  if (has("\"replan batch\"") || has("\"replan results\"")) return FileKind::results;
  if (has("\"replan experiment\"")) return FileKind::experiment;
  return has("\"replan\"") ? promised : FileKind::other;
}

/// The entry with what the system tells of it; links are followed. False if it is gone.
bool look_up(const fs::path& path, FileEntry& entry) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0 && ::lstat(path.c_str(), &info) != 0) return false;
  const bool folder = S_ISDIR(info.st_mode);
  entry.kind = folder ? FileKind::folder : kind_of(entry.name);
  if (!folder && S_ISREG(info.st_mode)) entry.kind = kind_inside(path, entry.kind);
  entry.size = folder ? 0 : static_cast<std::uint64_t>(info.st_size);
  entry.modified = static_cast<std::int64_t>(info.st_mtime);
  return true;
}

}  // namespace

FileKind kind_of(std::string_view name) {
  const std::string extension = file_extension(name);
  if (extension == ".json") return FileKind::scenario;
  if (extension == ".scen") return FileKind::problems;
  const MapFormat* format = find_map_format(name);
  if (format == nullptr) return FileKind::other;
  return format->picture ? FileKind::picture : FileKind::map;
}

std::string kind_text(const FileEntry& entry) {
  switch (entry.kind) {
    case FileKind::folder:
      return "folder";
    case FileKind::scenario:
      return "scenario";
    case FileKind::problems:
      return "problems";
    case FileKind::experiment:
      return "experiment";
    case FileKind::results:
      return "results of a batch";
    case FileKind::map:
    case FileKind::picture:
      return std::string(find_map_format(entry.name)->name);
    case FileKind::other:
      break;
  }
  const std::string extension = file_extension(entry.name);
  return extension.size() > 1 ? extension.substr(1) + " file" : "file";
}

bool natural_less(std::string_view a, std::string_view b) {
  const int order = natural_compare(a, b);
  return order != 0 ? order < 0 : a < b;
}

bool holds(std::string_view text, std::string_view part) {
  return std::search(text.begin(), text.end(), part.begin(), part.end(),
                     [](char x, char y) { return lower(x) == lower(y); }) != text.end() ||
         part.empty();
}

Result<std::vector<FileEntry>> read_folder(const std::string& folder) {
  std::error_code failed;
  if (!fs::is_directory(folder, failed))
    return Error{"'" + folder + "' " +
                 (fs::exists(folder, failed) ? "is not a folder" : "is not there any more") +
                 "; go up, or choose a place at the left"};
  fs::directory_iterator each(folder, failed);
  if (failed) return Error{"cannot look into '" + folder + "': " + failed.message()};
  std::vector<FileEntry> entries;
  for (; each != fs::directory_iterator() && entries.size() < kMostFiles; each.increment(failed)) {
    if (failed) return Error{"cannot read on in '" + folder + "': " + failed.message()};
    FileEntry entry;
    entry.name = each->path().filename().string();
    if (look_up(each->path(), entry)) entries.push_back(std::move(entry));
  }
  return entries;
}

void FileList::take(std::vector<FileEntry> entries) {
  all_ = std::move(entries);
  refresh();
}

void FileList::set_filter(const FileFilter& filter) {
  filter_ = filter;
  refresh();
}

void FileList::set_search(std::string_view text) {
  if (text == search_) return;
  search_ = text;
  refresh();
  if (!search_.empty() && selected() == nullptr && !shown_.empty()) selected_ = 0;
}

void FileList::set_hidden(bool shown) {
  hidden_ = shown;
  refresh();
}

void FileList::sort_by(FileOrder order) {
  // What is newest or largest is what one looks for; names are read from A.
  descending_ = order == order_ ? !descending_ : order != FileOrder::name;
  order_ = order;
  refresh();
}

bool FileList::is_shown(const FileEntry& entry) const {
  if (!hidden_ && entry.name.starts_with('.')) return false;
  if (!holds(entry.name, search_)) return false;
  if (entry.kind == FileKind::folder || filter_.extensions.empty()) return true;
  return std::find(filter_.extensions.begin(), filter_.extensions.end(), file_extension(entry.name)) !=
         filter_.extensions.end();
}

void FileList::refresh() {
  const FileEntry* old = selected();
  const std::string name = old == nullptr ? "" : old->name;
  shown_.clear();
  for (const FileEntry& entry : all_)
    if (is_shown(entry)) shown_.push_back(entry);
  const auto before = [this](const FileEntry& a, const FileEntry& b) {
    if (order_ == FileOrder::size && a.size != b.size) return a.size < b.size;
    if (order_ == FileOrder::date && a.modified != b.modified) return a.modified < b.modified;
    return natural_less(a.name, b.name);
  };
  std::sort(shown_.begin(), shown_.end(), [&](const FileEntry& a, const FileEntry& b) {
    const bool folder = a.kind == FileKind::folder;
    if (folder != (b.kind == FileKind::folder)) return folder;
    return descending_ ? before(b, a) : before(a, b);
  });
  if (name.empty() || !select(name)) deselect();
}

const FileEntry* FileList::selected() const {
  return selected_ < shown_.size() ? &shown_[selected_] : nullptr;
}

bool FileList::select(std::string_view name) {
  const auto found =
      std::find_if(shown_.begin(), shown_.end(), [&](const FileEntry& entry) { return entry.name == name; });
  if (found == shown_.end()) return false;
  selected_ = static_cast<std::size_t>(found - shown_.begin());
  return true;
}

void FileList::jump_to(std::string_view beginning) {
  const auto found = std::find_if(shown_.begin(), shown_.end(),
                                  [&](const FileEntry& entry) { return begins(entry.name, beginning); });
  if (beginning.empty() || found == shown_.end())
    deselect();
  else
    selected_ = static_cast<std::size_t>(found - shown_.begin());
}

void FileList::move(int by) {
  if (shown_.empty()) return;
  const auto last = static_cast<std::ptrdiff_t>(shown_.size()) - 1;
  const std::ptrdiff_t from =
      selected() == nullptr ? (by > 0 ? -1 : last + 1) : static_cast<std::ptrdiff_t>(selected_);
  selected_ = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(from + by, 0, last));
}

std::vector<Crumb> crumbs(const std::string& folder) {
  std::vector<Crumb> result;
  fs::path path;
  for (const fs::path& part : fs::path(folder)) {
    path /= part;
    if (!part.empty()) result.push_back({part.string(), path.string()});
  }
  return result;
}

std::string typed_from(const std::string& folder, std::string_view typed) {
  const std::string path = typed_path(std::string(typed));
  if (path.empty()) return folder;
  std::string normal = (fs::path(folder) / path).lexically_normal().string();
  if (normal.size() > 1 && normal.ends_with('/')) normal.pop_back();
  return normal;
}

std::string completed(const std::string& folder, const std::string& typed) {
  const std::size_t slash = typed.rfind('/');
  const std::string stem = slash == std::string::npos ? "" : typed.substr(0, slash + 1);
  const std::string begun = typed.substr(stem.size());
  const Result<std::vector<FileEntry>> entries =
      read_folder(stem.empty() ? folder : typed_from(folder, stem));
  if (!entries) return typed;
  std::string common;
  const FileEntry* only = nullptr;
  std::size_t found = 0;
  for (const FileEntry& entry : *entries) {
    if (!begins(entry.name, begun) || (begun.empty() && entry.name.starts_with('.'))) continue;
    only = &entry;
    if (found++ == 0) {
      common = entry.name;
      continue;
    }
    std::size_t same = 0;
    while (same < common.size() && same < entry.name.size() && common[same] == entry.name[same]) ++same;
    // No letter is cut in two: bytes that go on one (UTF-8) begin with the bits 10.
    while (same > 0 && same < common.size() && (static_cast<unsigned char>(common[same]) & 0xC0) == 0x80)
      --same;
    common.resize(same);
  }
  // Names that agree only without their case have less in common than was typed.
  if (found == 0 || common.size() < begun.size()) return typed;
  return stem + common + (found == 1 && only->kind == FileKind::folder ? "/" : "");
}

}  // namespace replan::ui
