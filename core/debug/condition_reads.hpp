// Which events the names of the condition language are about.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/debug/condition.hpp"
#include "core/trace/event.hpp"

namespace replan {

/// The kinds of events that write what a value of a vertex, or of all of them, is made of.
KindSet kinds_of(Op op);
/// The same of a term that may be about a value of a planner's own.
KindSet kinds_of(const Term& term, const SearchValues& values);
/// The value of the run that a term names.
std::optional<Scalar> scalar_of(Op op);
/// The kinds of events that event(NAME) is about; none for what checkers say.
KindSet kinds_of(Happening happening);

/// The last of ascending positions that is not greater; 0 if there is none.
std::size_t last_until(std::span<const std::size_t> positions, std::size_t position);

}  // namespace replan
