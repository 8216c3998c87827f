// The generators there are, each declared once: window, command line and help are made from this list, and a
// map can be asked for by a text such as "generator:maze?width=61&height=41&corridor=2&seed=7".
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/plan/parameters.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

struct GeneratorInfo;

/// A map that is asked for.
struct GeneratorRequest {
  const GeneratorInfo& generator;
  const Settings& settings;  ///< the generator's own parameters
  Box size;
  std::uint64_t seed;
  std::span<const Cell> keep_free;

  /// The value of one of the generator's parameters.
  [[nodiscard]] double real(std::string_view key) const;
  [[nodiscard]] int whole(std::string_view key) const { return static_cast<int>(real(key)); }
};

/// A generator.
struct GeneratorInfo {
  std::string_view id;       ///< "maze"
  std::string_view name;     ///< as in the window: "Maze"
  std::string_view summary;  ///< one sentence
  std::vector<Parameter> parameters;
  Result<GridMap> (*make)(const GeneratorRequest& request) = nullptr;
  int layers = 1;      ///< how many it makes unless told otherwise
  bool solid = false;  ///< it makes worlds of several layers; else one layer alone
};

/// All generators.
std::span<const GeneratorInfo> generators();
/// The parameters of size and seed that every generator has: width, height, seed.
std::span<const Parameter> generator_size_parameters();
/// How many layers a solid generator makes.
Parameter generator_layers_parameter(const GeneratorInfo& info);
/// The generator of that id; the error suggests the nearest one.
Result<const GeneratorInfo*> require_generator(std::string_view id);

/// Makes a map. `settings` are the generator's own parameters; cells of `keep_free` come out free. The same
/// arguments give the same map on every machine. The error says what to change.
Result<GridMap> generate(std::string_view id, const Settings& settings, const Box& size, std::uint64_t seed,
                         std::span<const Cell> keep_free = {});

/// True if a text asks for a generated map rather than naming a file: it begins with "generator:".
bool is_generator_spec(std::string_view text);
/// Makes the map that "generator:ID?key=value&key=value" asks for; what is not set has its default. The error
/// names the key and the range, and suggests near names.
Result<GridMap> generate_from_spec(std::string_view spec, std::span<const Cell> keep_free = {});

/// A map out of a generator, if `source` is a spec, or else out of a file.
Result<MapFile> open_map(const std::string& source, const MapReading& reading = {},
                         std::span<const Cell> keep_free = {});

}  // namespace replan
