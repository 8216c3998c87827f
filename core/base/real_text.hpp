// Numbers as text and back: exact, and the same in every language of the system.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace replan {

/// With as few digits as tell it from all other numbers, as std::to_chars() writes it: "0.1", "1e+22", "-0", "inf".
std::string real_text(double number);

/// Takes a number off the front of a text, as std::from_chars() reads it: no "+" and no blanks before it, "inf" and "nan"
/// as words. Nothing, and the text as it was, if there is none or if it is too large or too small for a double.
std::optional<double> take_real(std::string_view& text);

/// The number that a whole text spells, or nothing.
std::optional<double> real_from(std::string_view text);

/// The same by means of C alone, for standard libraries that cannot do this for doubles; there they are those above.
namespace plain {
std::string real_text(double number);
std::optional<double> take_real(std::string_view& text);
}  // namespace plain

}  // namespace replan
