#include <algorithm>

#include "core/world/generators/list.hpp"
#include "tests/fuzz/target.hpp"

/// Whether a side could have more than three digits, or in space more than two, written out or as in 5e6: such maps take
/// too long to make thousands of them.
static bool large(std::string_view input) {
  const auto& all = replan::generators();
  const bool solid = std::any_of(all.begin(), all.end(), [&](const replan::GeneratorInfo& info) {
    return info.layers > 1 && input.starts_with(info.id);
  });
  const std::size_t most = solid || input.find("layers=") != std::string_view::npos ? 2 : 3;
  for (const std::string_view key :
       {std::string_view("width="), std::string_view("height="), std::string_view("layers=")})
    for (std::size_t at = input.find(key); at != std::string_view::npos; at = input.find(key, at + 1)) {
      const std::string_view value = input.substr(at + key.size());
      if (const std::string_view digits = value.substr(0, value.find('&'));
          digits.size() > most || digits.find_first_of("eE") != std::string_view::npos)
        return true;
    }
  return false;
}

REPLAN_FUZZ_TARGET(generator_spec) {
  if (large(input)) return;
  const Cell kept[] = {{0, 0}, {3, 2}};
  const std::string spec = "generator:" + std::string(input.substr(0, input.find('\n')));
  const auto map = generate_from_spec(spec, kept);
  require_good_error(map, spec + ": ");
  if (!map) return;
  for (const Cell cell : kept) require(!map->contains(cell) || !map->at(cell), "kept cells are free");
  require(*generate_from_spec(spec, kept) == *map, "the same text gives the same map");
}
