// Lists of parts that stand in a .def file, one object of each.
#pragma once

#include <cassert>
#include <memory>
#include <string_view>
#include <vector>

namespace replan::ui {

/// A kind with its name in the list.
template <class Kind>
Kind named(Kind kind, std::string_view id) {
  kind.id = id;
  return kind;
}

/// For lists of what there is: makes the part as one of its kind.
template <class Base, class Part>
std::unique_ptr<Base> make_part() {
  return std::make_unique<Part>();
}

/// The part of a class; it is there.
template <class Part, class Base>
Part& part_of(const std::vector<std::unique_ptr<Base>>& parts) {
  for (const auto& each : parts)
    if (auto* found = dynamic_cast<Part*>(each.get())) return *found;
  assert(false);
  __builtin_unreachable();
}

}  // namespace replan::ui
