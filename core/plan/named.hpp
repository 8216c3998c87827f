// Finding something in a registry by its id.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/plan/parameters.hpp"

namespace replan {

/// The one of that id, or nullptr.
template <class Info>
const Info* find_by_id(std::span<const Info> all, std::string_view id) {
  for (const Info& info : all)
    if (info.id == id) return &info;
  return nullptr;
}

/// As find_by_id(), with an error that suggests the nearest id. `noun` is what they are: "planner".
template <class Info>
Result<const Info*> require_by_id(std::span<const Info> all, std::string_view id, const std::string& noun) {
  if (const Info* info = find_by_id(all, id)) return info;
  std::vector<std::string_view> ids;
  for (const Info& info : all) ids.push_back(info.id);
  const std::string_view nearest = nearest_name(id, ids);
  return Error{"unknown " + noun + " '" + std::string(id) + "'" +
               (nearest.empty() ? "; 'replan list " + noun + "s' shows those there are"
                                : "; did you mean '" + std::string(nearest) + "'?")};
}

}  // namespace replan
