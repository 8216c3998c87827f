#include "ui/documents/world_library.hpp"

#include <algorithm>
#include <sstream>

#include "core/base/file.hpp"
#include "core/world/library.hpp"
#include "ui/documents/file_list.hpp"

namespace replan::ui {

std::string LibraryWorld::title() const {
  return preview.name.empty() ? file_stem(path) : preview.name;
}

WorldLibrary::WorldLibrary(std::string folder, WorkPlace place)
    : folder_(std::move(folder)),
      finder_(std::make_unique<Background<std::vector<StampedFile>>>(place)),
      reader_(std::make_unique<Background<Read>>(place)) {}

void WorldLibrary::refresh() {
  if (folder_.empty()) return;
  reader_->cancel();
  finder_->start([folder = folder_](const StopToken&) {
    std::vector<StampedFile> files;
    for (const std::string& path : library_files(folder)) files.push_back(stamped(path));
    return files;
  });
}

bool WorldLibrary::update() {
  bool changed = false;
  if (std::optional<std::vector<StampedFile>> files = finder_->take()) {
    std::vector<LibraryWorld> old = std::move(worlds_);
    worlds_.clear();
    for (StampedFile& file : *files) {
      const auto known = std::find_if(old.begin(), old.end(), [&](const LibraryWorld& world) {
        return world.path == file.path && world.stamp == file.stamp;
      });
      if (known != old.end())
        worlds_.push_back(std::move(*known));
      else
        worlds_.push_back({std::move(file.path), file.stamp, false, {}});
    }
    read_next();
    changed = true;
  }
  while (std::optional<Read> read = reader_->take()) {
    worlds_[read->index].preview = std::move(read->preview);
    worlds_[read->index].looked_at = true;
    read_next();
    changed = true;
  }
  return changed;
}

void WorldLibrary::read_next() {
  const auto next = std::find_if(worlds_.begin(), worlds_.end(),
                                 [](const LibraryWorld& world) { return !world.looked_at; });
  if (next == worlds_.end()) return;
  const auto index = static_cast<std::size_t>(next - worlds_.begin());
  // One file at a time; none can be cut up.
  reader_->start([index, path = next->path](const StopToken& stop) {
    return Read{index, make_preview(path, {}, stop)};
  });
}

std::vector<std::size_t> WorldLibrary::found(std::string_view text) const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < worlds_.size(); ++i) {
    const LibraryWorld& world = worlds_[i];
    // A file that is no world (a JSON file of something else) has no place among them.
    if (world.looked_at && !world.preview.error.empty()) continue;
    const std::string all = world.title() + "\n" + world.preview.caption + "\n" + file_name(world.path);
    std::istringstream words{std::string(text)};
    std::string word;
    bool all_there = true;
    while (words >> word) all_there = all_there && holds(all, word);
    if (all_there) result.push_back(i);
  }
  return result;
}

}  // namespace replan::ui
