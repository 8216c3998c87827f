// One fuzz target for each reader. Built with clang as a libFuzzer program (preset "fuzz"), and into the unit
// tests, where every file of the corpus is put through its target.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace replan::fuzz {

/// A target by the name of its folder in tests/fuzz/corpus.
struct Target {
  std::string name;
  void (*run)(std::string_view input);
};

/// All targets that are linked in.
inline std::vector<Target>& targets() {
  static std::vector<Target> list;
  return list;
}

struct Registration {
  Registration(const char* name, void (*run)(std::string_view input)) { targets().push_back({name, run}); }
};

/// A law that the reader broke: a crash for libFuzzer, a failure for the unit tests.
inline void require(bool holds, const std::string& law) {
  if (!holds) throw std::logic_error(law);
}

/// What every error of a reader is: one line that begins with the place.
template <class T>
void require_good_error(const Result<T>& result, const std::string& place) {
  if (result.ok()) return;
  require(result.error().starts_with(place), "an error names the place: " + result.error());
  require(result.error().find('\n') == std::string::npos, "an error is one line: " + result.error());
}

}  // namespace replan::fuzz

#ifdef REPLAN_LIBFUZZER
#define REPLAN_FUZZ_ENTRY(NAME)                                                       \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    replan::fuzz::NAME({reinterpret_cast<const char*>(data), size});                  \
    return 0;                                                                         \
  }
#else
#define REPLAN_FUZZ_ENTRY(NAME)
#endif

/// Begins the body of a target: `REPLAN_FUZZ_TARGET(pnm) { ... input ... }`.
#define REPLAN_FUZZ_TARGET(NAME)                              \
  namespace replan::fuzz {                                    \
  static void NAME(std::string_view input);                   \
  static const Registration NAME##_registration(#NAME, NAME); \
  }                                                           \
  REPLAN_FUZZ_ENTRY(NAME)                                     \
  void replan::fuzz::NAME(std::string_view input)
