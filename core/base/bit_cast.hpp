// The bits of one value as another: bit_cast, which the standard library of Debian's compiler for browsers lacks.
#pragma once

#include <type_traits>

namespace replan {

/// `From` and `To` are of one size, and both may be copied byte by byte.
template <class To, class From>
constexpr To bit_cast(const From& value) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  static_assert(std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, value);
}

}  // namespace replan
