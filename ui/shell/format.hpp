// Numbers, cells and events as the window prints them.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>

#include "core/base/cell.hpp"
#include "core/base/words.hpp"
#include "core/debug/event_words.hpp"
#include "core/session/run.hpp"
#include "ui/canvas/chips.hpp"

namespace replan::ui {

/// "9 214": thousands apart, as grouped(std::int64_t).
template <std::unsigned_integral Number>
std::string grouped(Number number) {
  return grouped(static_cast<std::int64_t>(number));
}
std::string fixed(double number, int decimals);
using replan::cost_text;
/// "(31, 18)", or "none" for kNoNode.
std::string node_text(const Run& run, NodeId node);
/// "1.4 MB".
std::string bytes_text(std::uint64_t bytes);
/// When it was, in local time and as short as it is clear: "10:42" today, "3 May 10:42" this year, else
/// "2024-05-03". `seconds` since 1970.
std::string date_text(std::int64_t seconds);
/// Begins with a capital letter, unless the first word is a path or a name.
std::string as_sentence(std::string words);

/// What the event before the cursor did, as a sentence: "rhs(31, 18): 41.213 → 43.799". Empty at the
/// beginning.
std::string last_event_text(const Run& run);

}  // namespace replan::ui
