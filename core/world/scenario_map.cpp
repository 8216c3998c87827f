#include "core/world/scenario_map.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/world/formats/movingai.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/map_file.hpp"
#include "core/world/place_writer.hpp"
#include "core/world/scenario_places.hpp"

namespace replan {
namespace {

using Rows = std::vector<JsonNode>;

HeightReading read_height_reading(const JsonNode& node) {
  HeightReading reading;
  if (!node.expect_object({"layers", "low", "high", "reduce"})) return reading;
  const auto layers = node.find("layers"), low = node.find("low"), high = node.find("high"),
             reduce = node.find("reduce");
  if (layers) reading.layers = static_cast<int>(layers->whole(kLeastHeightLayers, kMostHeightLayers));
  if (low) reading.low = low->number(-kMaxHeight, kMaxHeight);
  if (high) reading.high = high->number(-kMaxHeight, kMaxHeight);
  if (reduce) reading.reduce = static_cast<int>(reduce->whole(0, kMostReduced));
  return reading;
}

Json height_reading_json(const HeightReading& reading) {
  Json json = Json::object();
  if (reading.layers != HeightReading{}.layers) json["layers"] = reading.layers;
  if (reading.low) json["low"] = plain_number(*reading.low);
  if (reading.high) json["high"] = plain_number(*reading.high);
  if (reading.reduce != 0) json["reduce"] = reading.reduce;
  return json;
}

void read_origin(const JsonNode& node, GridMap& map) {
  const auto parts = node.items(3, 3, "a pose [x, y, yaw]");
  for (std::size_t i = 0; i < parts.size(); ++i) map.origin[i] = parts[i].number(-kMaxOrigin, kMaxOrigin);
}

Rows rows_of(const JsonNode& node) {
  return node.items(1, static_cast<std::size_t>(kMaxCells), "a list of rows, one text each");
}

/// The rows of each layer; none after an error.
std::vector<Rows> layers_of(const JsonNode& node) {
  std::vector<Rows> layers;
  for (const JsonNode& item :
       node.items(1, static_cast<std::size_t>(kMaxVoxels), "a list of layers, each a list of rows")) {
    layers.push_back(rows_of(item));
    if (layers.back().empty()) return {};
    if (layers.back().size() == layers.front().size()) continue;
    item.fail("has " + std::to_string(layers.back().size()) + " rows, the first layer has " +
              std::to_string(layers.front().size()));
    return {};
  }
  return layers;
}

void read_row(const JsonNode& node, Cell first, GridMap& map) {
  const std::string row = node.text();
  if (row.size() != static_cast<std::size_t>(map.width))
    return node.fail("has " + std::to_string(row.size()) + " cells, the first row has " +
                     std::to_string(map.width));
  for (std::size_t x = 0; x < row.size(); ++x) {
    const MapLetter letter = map_letter(row[x]);
    if (letter == MapLetter::unknown && row[x] != '?')
      return node.fail("column " + std::to_string(x + 1) + ": unknown cell letter " +
                       shown_letter(std::string_view(row).substr(x)) +
                       "; known are . G S (free), @ O T W (obstacle) and ? (an obstacle that is on "
                       "nobody's map)");
    map.blocked[map.index(first) + x] = row[x] == '?'                  ? kUnmapped
                                        : letter == MapLetter::blocked ? kObstacle
                                                                       : kFree;
  }
}

/// A map of these layers, whose rows are as many in each. `most` cells are the limit for such a map.
void read_cells(const JsonNode& node, const std::vector<Rows>& layers, std::int64_t most, GridMap& map) {
  if (layers.empty() || layers.front().empty()) return;
  const JsonNode& first = layers.front().front();
  const auto width = static_cast<std::int64_t>(first.text().size());
  const auto height = static_cast<std::int64_t>(layers.front().size()),
             depth = static_cast<std::int64_t>(layers.size());
  if (width == 0) return first.fail("must have at least one cell");
  if (width > most / height || depth > most / (width * height))
    return node.fail("too large: at most " + std::to_string(most) + " cells");
  map = GridMap(static_cast<int>(width), static_cast<int>(height), static_cast<int>(depth));
  for (int z = 0; z < map.depth; ++z)
    for (int y = 0; y < map.height; ++y)
      read_row(layers[static_cast<std::size_t>(z)][static_cast<std::size_t>(y)], {0, y, z}, map);
}

void read_file_of(const JsonNode& file, const std::string& folder, Scenario& scenario) {
  scenario.map_file = file.text();
  if (scenario.map_file.empty()) return file.fail("must name a file");
  if (folder == kNoFolder)
    return file.fail("names a file, and a text from elsewhere must hold its map itself, as 'rows'");
  Result<MapFile> map =
      read_map_file((std::filesystem::path(folder) / scenario.map_file).string(), scenario.map_reading);
  if (!map) return file.fail(map.error());
  scenario.map = std::move(map->map);
  scenario.map_found = std::move(map->found);
}

/// A map of that size, free but for the listed obstacles.
void read_listed(const JsonNode& size, const JsonNode& obstacles, GridMap& map) {
  const auto sides = size.items(2, 3, "a size [width, height], or [width, height, depth]");
  if (sides.empty()) return;
  std::array<std::int64_t, 3> side{1, 1, 1};
  for (std::size_t axis = 0; axis < sides.size(); ++axis) side[axis] = sides[axis].whole(1, kMaxCells);
  const std::int64_t most = side[2] == 1 ? kMaxCells : kMaxVoxels;
  if (side[0] > most / side[1] || side[2] > most / (side[0] * side[1]))
    return size.fail("too large: at most " + std::to_string(most) + " cells");
  map = GridMap(static_cast<int>(side[0]), static_cast<int>(side[1]), static_cast<int>(side[2]));
  std::vector<CellChange> listed;
  PlaceReader(map.box()).cells(obstacles, true, listed);
  for (const CellChange& obstacle : listed)
    if (map.box().contains(obstacle.cell)) map.set(obstacle.cell, true);  // what is outside is told already
}

/// The obstacles of a large map as they are listed, if they are few boxes; else nothing.
std::optional<Json> few_boxes(const GridMap& map) {
  constexpr std::size_t kLarge = 10'000, kMostListed = 1'000'000, kMostBoxes = 1'000;
  if (map.blocked.size() <= kLarge) return std::nullopt;
  const Box box = map.box();
  std::vector<Cell> cells;
  std::size_t corners = 0;  // cells with nothing before them along any axis: there are no fewer boxes
  for (NodeId n = 0; n < map.blocked.size(); ++n) {
    if (map.blocked[n] == kFree) continue;
    const Cell at = box.position(n);
    if (map.blocked[n] != kObstacle || cells.size() == kMostListed) return std::nullopt;
    const auto taken = [&](const Cell& cell) {
      return box.contains(cell) && map.blocked[map.index(cell)] != kFree;
    };
    const bool corner =
        !taken({at.x - 1, at.y, at.z}) && !taken({at.x, at.y - 1, at.z}) && !taken({at.x, at.y, at.z - 1});
    corners += corner ? 1 : 0;
    if (corners > kMostBoxes) return std::nullopt;
    cells.push_back(at);
  }
  Json listed = PlaceWriter(box).cells(std::move(cells));
  std::size_t boxes = 0;
  for (const auto& [kind, places] : listed.items()) boxes += places.size();
  return boxes > kMostBoxes ? std::nullopt : std::optional(std::move(listed));
}

Json rows_json(const GridMap& map, int z) {
  Json rows = Json::array();
  for (int y = 0; y < map.height; ++y) {
    std::string row;
    for (int x = 0; x < map.width; ++x) row += ".@?"[map.blocked[map.index({x, y, z})]];
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

void read_map_of(const JsonNode& node, const std::string& folder, Scenario& scenario) {
  if (!node.expect_object({"file", "rows", "layers", "size", "obstacles", "resolution", "origin", "threshold",
                           "invert", "unknown", "occupied", "heights"}))
    return;
  const auto file = node.find("file"), rows = node.find("rows"), layers = node.find("layers"),
             size = node.find("size"), obstacles = node.find("obstacles");
  const auto resolution = node.find("resolution"), origin = node.find("origin");
  if (int{file.has_value()} + int{rows.has_value()} + int{layers.has_value()} + int{size.has_value()} != 1)
    return node.fail("needs exactly one of 'file', 'rows', 'layers' and 'size'");
  if (obstacles.has_value() != size.has_value()) return node.fail("'size' and 'obstacles' go together");
  GridMap& map = scenario.map;
  if (rows) read_cells(*rows, {rows_of(*rows)}, kMaxCells, map);
  if (layers) read_cells(*layers, layers_of(*layers), kMaxVoxels, map);
  if (size) read_listed(*size, *obstacles, map);
  if (!file && resolution) map.resolution = resolution->number(kMinResolution, kMaxResolution);
  if (!file && origin) read_origin(*origin, map);
  for (const char* option : {"threshold", "invert", "unknown", "occupied", "heights"})
    if (const auto given = node.find(option); given && !file) given->fail("goes with 'file'");
  const MapReading reading = read_map_reading(node);
  if (!file) return;
  if (resolution) return resolution->fail("is for a map that is held here; a map file has its own");
  if (origin) return origin->fail("is for a map that is held here; a map file has its own");
  scenario.map_reading = reading;
  read_file_of(*file, folder, scenario);
}

MapReading read_map_reading(const JsonNode& node) {
  MapReading reading;
  if (const auto heights = node.find("heights")) reading.heights = read_height_reading(*heights);
  if (const auto threshold = node.find("threshold"))
    reading.image.threshold = static_cast<int>(threshold->whole(1, 255));
  if (const auto invert = node.find("invert")) reading.image.invert = invert->toggle();
  if (const auto unknown = node.find("unknown"))
    reading.unknown = static_cast<UnknownCells>(unknown->one_of({"blocked", "free", "unmapped"}));
  if (const auto occupied = node.find("occupied"))
    reading.occupied = occupied->number(-kMaxOccupied, kMaxOccupied);
  return reading;
}

void add_map_reading(Json& map, const MapReading& reading) {
  constexpr const char* kUnknown[] = {"blocked", "free", "unmapped"};
  if (reading.image.threshold != ImageMapOptions{}.threshold) map["threshold"] = reading.image.threshold;
  if (reading.image.invert) map["invert"] = true;
  if (reading.unknown != UnknownCells::blocked)
    map["unknown"] = kUnknown[static_cast<std::size_t>(reading.unknown)];
  if (reading.occupied) map["occupied"] = plain_number(*reading.occupied);
  if (reading.heights) map["heights"] = height_reading_json(*reading.heights);
}

Json map_json(const Scenario& scenario) {
  Json map = Json::object();
  if (!scenario.map_file.empty()) {
    map["file"] = scenario.map_file;
    add_map_reading(map, scenario.map_reading);
    return map;
  }
  if (auto listed = few_boxes(scenario.map)) {
    map["size"] = {scenario.map.width, scenario.map.height};
    if (scenario.map.depth > 1) map["size"].push_back(scenario.map.depth);
    map["obstacles"] = std::move(*listed);
  } else if (scenario.map.depth == 1) {
    map["rows"] = rows_json(scenario.map, 0);
  } else {
    for (int z = 0; z < scenario.map.depth; ++z) map["layers"].push_back(rows_json(scenario.map, z));
  }
  if (scenario.map.resolution != 1) map["resolution"] = plain_number(scenario.map.resolution);
  if (scenario.map.origin != std::array<double, 3>{})
    for (const double part : scenario.map.origin) map["origin"].push_back(plain_number(part));
  return map;
}

}  // namespace replan
