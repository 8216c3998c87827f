#include "ui/documents/preview.hpp"

#include <algorithm>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/experiment/experiment.hpp"
#include "core/experiment/held_results.hpp"
#include "core/world/choices.hpp"
#include "core/world/map_file.hpp"
#include "ui/documents/file_list.hpp"
#include "ui/documents/files.hpp"
#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

Cell in_pixels(Cell cell, const GridMap& map, const Thumbnail& picture) {
  return {static_cast<int>(std::int64_t{cell.x} * picture.width / map.width),
          static_cast<int>(std::int64_t{cell.y} * picture.height / map.height)};
}

/// How much of the cells of one pixel, through all layers, is blocked: 0 to 255.
std::uint8_t share(const GridMap& map, int x0, int y0, int x1, int y1) {
  std::int64_t blocked = 0;
  for (int z = 0; z < map.depth; ++z)
    for (int y = y0; y < y1; ++y) {
      const auto row = map.blocked.begin() + static_cast<std::ptrdiff_t>(map.index({0, y, z}));
      blocked += std::count_if(row + x0, row + x1, [](std::uint8_t cell) { return cell != 0; });
    }
  return static_cast<std::uint8_t>(blocked * 255 / (std::int64_t{x1 - x0} * (y1 - y0) * map.depth));
}

void describe(const GridMap& map, std::optional<Cell> start, std::optional<Cell> goal, Preview& preview) {
  preview.width = map.width;
  preview.height = map.height;
  preview.depth = map.depth;
  preview.resolution = map.resolution;
  preview.obstacles = map.blocked.size() -
                      static_cast<std::size_t>(std::count(map.blocked.begin(), map.blocked.end(), kFree));
  preview.thumbnail = thumbnail_of(map, start, goal);
}

void describe(const Scenario& scenario, Preview& preview) {
  preview.name = scenario.name;
  preview.caption = scenario.caption;
  for (const PlannerChoice& choice : scenario.planners)
    preview.planners.emplace_back(find_choice(choice.id)->name);
  describe(scenario.map, scenario.start, scenario.goal, preview);
}

/// The numbers in a file that cannot be read before somebody says which is the obstacle: any will do for
/// that.
std::vector<double> numbers_of(const std::string& path, MapReading reading) {
  const MapFormat* format = find_map_format(path);
  if (format == nullptr || !format->numbers) return {};
  reading.occupied = 1;
  Result<MapFile> file = read_map_file(path, reading);
  return file ? std::move(file->found.numbers) : std::vector<double>();
}

}  // namespace

Thumbnail thumbnail_of(const GridMap& map, std::optional<Cell> start, std::optional<Cell> goal, int side) {
  Thumbnail picture;
  const int longer = std::max(map.width, map.height);
  if (longer <= 0) return picture;
  const int cells = std::max(longer, side);  // that lie along the longer side of the picture
  const auto shrunk = [&](int length) {
    return std::max(1, static_cast<int>(std::int64_t{length} * side / cells));
  };
  picture.width = longer <= side ? map.width : shrunk(map.width);
  picture.height = longer <= side ? map.height : shrunk(map.height);
  picture.walls.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  const auto edge = [](int pixel, int pixels, int length) {
    return static_cast<int>(std::int64_t{pixel} * length / pixels);
  };
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      picture.walls.push_back(
          share(map, edge(x, picture.width, map.width), edge(y, picture.height, map.height),
                edge(x + 1, picture.width, map.width), edge(y + 1, picture.height, map.height)));
  if (start) picture.start = in_pixels(*start, map, picture);
  if (goal) picture.goal = in_pixels(*goal, map, picture);
  return picture;
}

std::vector<std::uint32_t> coloured(const Thumbnail& thumbnail, const Theme& theme) {
  std::vector<std::uint32_t> pixels;
  pixels.reserve(thumbnail.walls.size());
  for (const std::uint8_t wall : thumbnail.walls)
    pixels.push_back(mix(theme.free, theme.obstacle, static_cast<float>(wall) / 255.0f));
  return pixels;
}

Preview make_preview(const std::string& path, const MapReading& reading, const StopToken& stop) {
  Preview preview;
  std::error_code failed;
  const std::uint64_t bytes = std::filesystem::file_size(path, failed);
  const FileKind kind = kind_of(path);
  if (!failed && bytes > kMostPreviewBytes) {
    preview.error =
        "Too large to be shown beforehand: " + bytes_text(bytes) + ". It can be opened all the same.";
  } else if (kind == FileKind::scenario) {
    const Result<Scenario> scenario = read_scenario(path);
    if (!scenario)
      preview.error = scenario.error();
    else if (!stop.stop_requested())
      describe(*scenario, preview);
  } else if (kind == FileKind::map || kind == FileKind::picture) {
    const Result<MapFile> file = read_map_file(path, reading);
    if (!file)
      preview.error = file.error();
    else if (!stop.stop_requested())
      describe(file->map, file->start, file->goal, preview);
    if (file) preview.notes = file->found.notes_for_planning();
    if (file) preview.heights = file->found.heights;
    preview.numbers = file ? file->found.numbers : numbers_of(path, reading);
  } else {
    preview.error = kind == FileKind::problems
                        ? "A list of problems, not a world: open the .map that it is for."
                        : "Not a world.";
  }
  return preview;
}

Preview preview_of_batch(const std::string& path) {
  Preview preview;
  if (batch_paper(path) == BatchPaper::results) {
    const auto held = held_results(file_folder(path));
    if (!held) preview.error = held.error();
    if (!held || !*held) return preview;
    preview.name = (*held)->name;
    preview.notes.push_back("results of a batch: " + grouped(static_cast<std::size_t>((*held)->done)) +
                            " of " + count_text((*held)->runs, "run is", "runs are") +
                            " done; Open shows them in Run > Batch");
    return preview;
  }
  const auto experiment = read_experiment(path);
  if (!experiment) {
    preview.error = experiment.error();
    return preview;
  }
  preview.name = experiment->name;
  preview.notes.push_back(
      "an experiment in " +
      count_text(static_cast<std::int64_t>(experiment->worlds.size()), "world", "worlds") +
      ": Open shows it in Run > Batch");
  for (const PlannerChoice& choice : experiment->planners) {
    const std::string name(find_choice(choice.id)->name);
    if (std::find(preview.planners.begin(), preview.planners.end(), name) == preview.planners.end())
      preview.planners.push_back(name);
  }
  return preview;
}

}  // namespace replan::ui
