// The map of a scenario file: named by its file, or written out in rows, or in layers of rows. Only for the scenario's
// reader and writer: it shows JSON types.
#pragma once

#include <string>

#include "core/world/json_reader.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// Reads the value of "map" into the scenario. A file is looked for in `folder`. Errors are kept in the JsonReader;
/// after one the map may have no cells.
void read_map_of(const JsonNode& node, const std::string& folder, Scenario& scenario);

/// Reads how a map file is to be read: the keys "threshold", "invert", "unknown", "occupied" and "heights".
MapReading read_map_reading(const JsonNode& node);
/// Adds what of it differs from the default.
void add_map_reading(Json& map, const MapReading& reading);

/// What read_map_of() reads back.
Json map_json(const Scenario& scenario);

}  // namespace replan
