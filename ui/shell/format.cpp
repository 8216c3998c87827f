#include "ui/shell/format.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace replan::ui {
namespace {

constexpr const char* kInfinity = "∞";

const char* scalar_name(NodeId scalar) {
  static constexpr std::array<const char*, static_cast<std::size_t>(Scalar::count)> kNames = {
      "km", "s_start", "s_last", "s_goal", "the robot", "moves", "replans"};
  return scalar < kNames.size() ? kNames[scalar] : "a value";
}

/// A raw value of a kind as text.
std::string value_text(const Run& run, EventKind kind, std::uint64_t raw) {
  switch (kind) {
    case EventKind::g:
    case EventKind::rhs:
    case EventKind::dist:
      return cost_text(Cost{static_cast<std::int64_t>(raw)});
    case EventKind::queue:
      return raw == 0 ? "not in U" : cost_text(Cost{static_cast<std::int64_t>(raw) - 1});
    case EventKind::lp:
    case EventKind::rp:
      return node_text(run, static_cast<NodeId>(raw) - 1u);
    case EventKind::visit:
      return std::to_string(raw & 0xFFFFFFFFu);
    case EventKind::known:
    case EventKind::truth:
      return raw != 0 ? "obstacle" : "free";
    default:
      return std::to_string(raw);
  }
}

std::string change_text(const Run& run, const Event& event) {
  static constexpr std::array<const char*, 9> kNames = {
      "g", "rhs", "k1", "lp", "rp", "dist", "expansion", "the robot's map", "the world"};
  if (event.kind == EventKind::scalar) {
    const std::uint64_t after = run.timeline().state().scalar(static_cast<Scalar>(event.node));
    const std::string name = scalar_name(event.node);
    const auto which = static_cast<Scalar>(event.node);
    if (which == Scalar::km) return name + " = " + cost_text(Cost{static_cast<std::int64_t>(after)});
    const bool place =
        which == Scalar::start || which == Scalar::last || which == Scalar::goal || which == Scalar::robot;
    return name + " = " + (place ? node_text(run, static_cast<NodeId>(after) - 1u) : std::to_string(after));
  }
  const std::uint64_t after = run.timeline().state().value(event.kind, event.node);
  const std::string name = kNames[static_cast<std::size_t>(event.kind)];
  return name + node_text(run, event.node) + ": " + value_text(run, event.kind, after ^ event.delta) + " → " +
         value_text(run, event.kind, after);
}

std::string happening_text(const Run& run, const Event& event) {
  const std::string at = node_text(run, event.node);
  const std::string target = node_text(run, static_cast<NodeId>(event.delta & 0xFFFFFFFFu));
  switch (event.kind) {
    case EventKind::line:
      return "passed, nothing changed";
    case EventKind::pop:
      return "took " + at + " from the open list";
    case EventKind::sight:
      return (event.delta >> 32 != 0 ? at + " sees " : at + " does not see ") + target;
    case EventKind::plan_begin:
      return event.delta == 0 ? "the first plan begins" : "replan " + std::to_string(event.delta) + " begins";
    case EventKind::plan_end:
      return status_sentence(static_cast<PlanStatus>(event.delta));
    case EventKind::move:
      return "the robot enters " + at;
    case EventKind::sensed:
      return "the robot sees " + at + (event.delta != 0 ? " blocked" : " free");
    case EventKind::surprise:
      return "a surprise: the world changes";
    case EventKind::unchecked:
      return at + " trusts its remote parent " + target;
    case EventKind::collision:
      return "the plan leads into an obstacle at " + at;
    case EventKind::waiting:
      return "no path: the robot waits at " + at;
    case EventKind::arrival:
      return "the robot arrives at " + at;
    case EventKind::gave_up:
      return "the mission ends at " + at;
    case EventKind::new_goal:
      return "the goal is " + at + " now: a plan from scratch";
    case EventKind::put_down:
      return "the robot is put down at " + at;
    case EventKind::forgotten:
      return "the robot forgets what it saw moving at " + at;
    default:
      return "";
  }
}

}  // namespace

std::string grouped(std::size_t number) {
  return grouped(static_cast<std::int64_t>(number));
}

std::string fixed(double number, int decimals) {
  if (std::isinf(number)) return kInfinity;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
  return text.data();
}

std::string cost_text(Cost cost, int decimals) {
  return cost.is_infinite() ? kInfinity : fixed(cost.to_double(), decimals);
}

std::string node_text(const Run& run, NodeId node) {
  return node == kNoNode || node >= run.lattice().node_count() ? "none"
                                                               : cell_text(run.lattice().position(node));
}

std::string bytes_text(std::size_t bytes) {
  const double size = static_cast<double>(bytes);
  if (size < 1e3) return std::to_string(bytes) + " B";
  if (size < 1e6) return fixed(size / 1e3, 1) + " kB";
  if (size < 1e9) return fixed(size / 1e6, 1) + " MB";
  return fixed(size / 1e9, 2) + " GB";
}

std::string date_text(std::int64_t seconds) {
  constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                     "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const std::time_t then = static_cast<std::time_t>(seconds), now = std::time(nullptr);
  std::tm at{}, today{};
  if (::localtime_r(&then, &at) == nullptr || ::localtime_r(&now, &today) == nullptr) return "";
  std::array<char, 64> text{};
  if (at.tm_year != today.tm_year)
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &at);
  else
    std::strftime(text.data(), text.size(), "%H:%M", &at);
  if (at.tm_year != today.tm_year || at.tm_yday == today.tm_yday) return text.data();
  return std::to_string(at.tm_mday) + " " + kMonths[at.tm_mon] + " " + text.data();
}

std::string count_text(std::int64_t count, const char* one, const char* many) {
  return grouped(count) + " " + (count == 1 ? one : many);
}

std::string as_sentence(std::string words) {
  const std::size_t end = words.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
  const bool plain_word = end != 0 && !words.empty() && (end == std::string::npos || words[end] == ' ');
  if (plain_word) words.front() = static_cast<char>(words.front() - 'a' + 'A');
  return words;
}

std::string last_event_text(const Run& run) {
  const std::size_t cursor = run.timeline().cursor();
  if (cursor == 0) return "";
  const Event& event = run.timeline().event(cursor - 1);
  return event.changes_value() ? change_text(run, event) : happening_text(run, event);
}

}  // namespace replan::ui
