// What a browser calls keys, as numbers of ui/keys.hpp.
#pragma once

#include <optional>
#include <string_view>

namespace replan::app {

/// `key` is what the key means on its owner's keyboard (KeyboardEvent.key), `code` where it stands (KeyboardEvent.code).
/// 0 if the program listens to none such.
int key_number(std::string_view key, std::string_view code);
/// The character that a press of it types; nothing for a key that types none.
std::optional<unsigned> typed_character(std::string_view key);

}  // namespace replan::app
