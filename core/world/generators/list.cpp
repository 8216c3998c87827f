#include "core/world/generators/list.hpp"

#include <algorithm>

#include "core/world/generators/kinds.hpp"
#include "core/world/map_file.hpp"

namespace replan {
namespace {

using enum ParameterType;

constexpr std::string_view kPrefix = "generator:";
// As wide as a map one cell high may be at most. Seeds are whole numbers that a double holds exactly.
constexpr double kLongestSide = static_cast<double>(kMaxCells), kMaxSeed = 0x1p53;
constexpr double kMostLayers = 8192;

std::vector<Parameter> size_parameters(const GeneratorInfo& info) {
  std::vector<Parameter> list(generator_size_parameters().begin(), generator_size_parameters().end());
  if (info.solid) list.push_back(generator_layers_parameter(info));
  return list;
}

/// Takes "key=value&key=value" apart into the generator's own settings and size and seed.
Result<void> read_pairs(std::string_view pairs, const GeneratorInfo& info, Settings& own, Settings& size) {
  std::vector<Parameter> all(info.parameters.begin(), info.parameters.end());
  const std::vector<Parameter> of_sizes = size_parameters(info);
  all.insert(all.end(), of_sizes.begin(), of_sizes.end());
  while (!pairs.empty()) {
    const std::string_view pair = pairs.substr(0, pairs.find('&'));
    pairs.remove_prefix(std::min(pair.size() + 1, pairs.size()));
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos)
      return Error{"'" + std::string(pair) + "' is no setting: give key=value, parted by &"};
    const std::string_view key = pair.substr(0, equals);
    if (own.has(key) || size.has(key)) return Error{"'" + std::string(key) + "' is set twice"};
    const bool of_size = find_parameter(of_sizes, key) != nullptr;
    if (auto set = set_from_text(of_size ? size : own, all, key, pair.substr(equals + 1)); !set) return set;
  }
  return {};
}

}  // namespace

std::span<const GeneratorInfo> generators() {
  static const std::vector<GeneratorInfo> list = generator_kinds();
  return list;
}

std::span<const Parameter> generator_size_parameters() {
  static const std::vector<Parameter> list = {
      {.key = "width",
       .label = "Width",
       .type = whole,
       .initial = 100,
       .low = 1,
       .high = kLongestSide,
       .unit = "cells",
       .help = "Columns of the map; a map has at most 67108864 cells."},
      {.key = "height",
       .label = "Height",
       .type = whole,
       .initial = 100,
       .low = 1,
       .high = kLongestSide,
       .unit = "cells",
       .help = "Rows of the map."},
      {.key = "seed",
       .label = "Seed",
       .type = whole,
       .initial = 1,
       .high = kMaxSeed,
       .help = "The same seed gives the same map on every machine."}};
  return list;
}

Parameter generator_layers_parameter(const GeneratorInfo& info) {
  return {.key = "layers",
          .label = "Layers",
          .type = whole,
          .initial = static_cast<double>(info.layers),
          .low = 1,
          .high = kMostLayers,
          .unit = "cells",
          .help = "Layers of the world; with more than one it has at most 134217728 cells."};
}

Result<const GeneratorInfo*> require_generator(std::string_view id) {
  std::vector<std::string_view> ids;
  std::string list;
  for (const GeneratorInfo& info : generators()) {
    if (info.id == id) return &info;
    ids.push_back(info.id);
    list += (list.empty() ? "" : ", ") + std::string(info.id);
  }
  const std::string_view nearest = nearest_name(id, ids);
  return Error{"unknown generator '" + std::string(id) + "'" +
               (nearest.empty() ? "; known: " + list : "; did you mean '" + std::string(nearest) + "'?")};
}

double GeneratorRequest::real(std::string_view key) const {
  return settings.get(*find_parameter(generator.parameters, key));
}

Result<GridMap> generate(std::string_view id, const Settings& settings, const Box& size, std::uint64_t seed,
                         std::span<const Cell> keep_free) {
  const Result<const GeneratorInfo*> info = require_generator(id);
  if (!info) return Error{info.error()};
  if (size.depth() != 1 && !(*info)->solid)
    return Error{"the generator '" + std::string(id) + "' makes one layer, not " +
                 std::to_string(size.depth())};
  return (*info)->make({**info, settings, size, seed, keep_free});
}

bool is_generator_spec(std::string_view text) {
  return text.starts_with(kPrefix);
}

Result<GridMap> generate_from_spec(std::string_view spec, std::span<const Cell> keep_free) {
  const std::string place = std::string(spec) + ": ";
  if (!is_generator_spec(spec)) return Error{place + "not a generator: it must begin with 'generator:'"};
  const std::string_view rest = spec.substr(kPrefix.size()), id = rest.substr(0, rest.find('?'));
  const Result<const GeneratorInfo*> info = require_generator(id);
  if (!info) return Error{place + info.error()};
  Settings own, size;
  const std::string_view pairs = rest.substr(std::min(id.size() + 1, rest.size()));
  if (const auto read = read_pairs(pairs, **info, own, size); !read) return Error{place + read.error()};
  const auto sized = [&](std::string_view key) {
    return size.get(*find_parameter(generator_size_parameters(), key));
  };
  const double layers = (*info)->solid ? size.get(generator_layers_parameter(**info)) : 1;
  const Box box(static_cast<int>(sized("width")), static_cast<int>(sized("height")),
                static_cast<int>(layers));
  Result<GridMap> map = generate(id, own, box, static_cast<std::uint64_t>(sized("seed")), keep_free);
  if (!map) return Error{place + map.error()};
  return map;
}

Result<MapFile> open_map(const std::string& source, const MapReading& reading,
                         std::span<const Cell> keep_free) {
  if (!is_generator_spec(source)) return read_map_file(source, reading);
  Result<GridMap> map = generate_from_spec(source, keep_free);
  if (!map) return Error{map.error()};
  return MapFile{std::move(map.value())};
}

}  // namespace replan
