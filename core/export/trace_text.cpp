#include "core/export/trace_text.hpp"

#include <array>
#include <string_view>

#include "core/base/real_text.hpp"

namespace replan {

std::string_view event_name(const SearchValues& values, EventKind kind) {
  if (is_own_field(kind)) return values.field(kind).name;
  static constexpr std::array<std::string_view, kEventKinds> kNames = {
      "g",        "rhs",       "queue",     "lp",        "rp",        "dist",       "visit",    "known",
      "truth",    "scalar",    "turn",      "pop",       "sight",     "plan_begin", "plan_end", "move",
      "sensed",   "surprise",  "unchecked", "collision", "waiting",   "arrival",    "gave_up",  "new_goal",
      "put_down", "forgotten", "aim",       "epoch",     "candidate", "rewired",    "rejected", "tried"};
  static_assert(kNames.size() == static_cast<std::size_t>(kEventKinds));
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view scalar_name(Scalar scalar) {
  static constexpr std::array<std::string_view, static_cast<std::size_t>(Scalar::count)> kNames = {
      "km",          "start",        "last",        "goal",   "robot",    "moves",   "replans",
      "wanted",      "weight",       "share",       "x",      "y",        "heading", "speed",
      "turning",     "sub_goal",     "admissible",  "score",  "vertices", "root",    "goal_vertex",
      "sample_x",    "sample_y",     "sample_z",    "new_x",  "new_y",    "new_z",   "nearest",
      "best",        "plan_sample",  "gain_sample", "ball",   "paths",    "child",   "leader",
      "leader_cost", "mean_cost",    "generation",  "mother", "father",   "taken",   "joined",
      "crossed_at",  "changed_from", "changed_to"};
  return kNames[static_cast<std::size_t>(scalar)];
}

std::string_view fault_name(SampleFault why) {
  static constexpr std::array<std::string_view, 6> kNames = {"blocked",  "taken", "longer",
                                                             "path_end", "twin",  "unfit"};
  return kNames[static_cast<std::size_t>(why)];
}

void append_real(std::string& out, double number) {
  out += real_text(number);
}

void append_cost(std::string& out, Cost cost) {
  constexpr std::uint64_t kDecimals = 10'000'000'000;  // 10^10 > 2^30: finer than the fixed point
  const auto raw = static_cast<std::uint64_t>(cost.raw);
  constexpr auto kScale = static_cast<std::uint64_t>(Cost::kScale);
  append_whole(out, raw / kScale);
  // Rounded to the nearest; at most 10^10 - 9, so that it never carries into the whole cells.
  std::uint64_t fraction = (raw % kScale * kDecimals + kScale / 2) / kScale;
  if (fraction == 0) return;
  std::array<char, 10> digits{};
  for (std::size_t i = digits.size(); i-- > 0; fraction /= 10)
    digits[i] = static_cast<char>('0' + fraction % 10);
  std::string_view shown(digits.data(), digits.size());
  shown = shown.substr(0, shown.find_last_not_of('0') + 1);
  (out += '.') += shown;
}

}  // namespace replan
