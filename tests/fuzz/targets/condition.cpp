#include "core/debug/condition.hpp"

#include "core/debug/probe.hpp"
#include "tests/fuzz/target.hpp"

namespace {

using namespace replan;

const Box kWorld{8, 6};

/// A log of every kind of event, made up: what an expression reads must not depend on its making sense.
const Timeline& some_log() {
  static const Timeline log = [] {
    Timeline made{SearchState(kWorld.node_count())};
    std::vector<Event> events;
    for (std::uint32_t i = 0; i < 300; ++i) {
      const auto kind = static_cast<EventKind>(i % static_cast<std::uint32_t>(kEventKinds));
      const NodeId node = i * 7 % (kind == EventKind::scalar ? static_cast<NodeId>(Scalar::count) : 48);
      // What a cell is takes one bit; a log never holds more of it.
      const bool bit = kind == EventKind::known || kind == EventKind::truth;
      events.push_back(
          {bit ? i % 2 : std::uint64_t{i} << (i % 50), node, kind, static_cast<std::uint8_t>(i / 3), 0});
    }
    made.append(events);
    return made;
  }();
  return log;
}

/// Counts the stops in both directions; they are the same ones.
void walk(const Condition& condition) {
  static const Settings settings;
  const Timeline& log = some_log();
  const LogView view{log, kWorld, planners().front(), settings};
  const std::size_t breaches[] = {3, 200};
  std::size_t there = 0, back = 0;
  Probe forwards(view, condition, 0, {breaches, breaches});
  while (forwards.forwards(log.size())) there += forwards.position() < log.size() ? 1 : 0;
  Probe backwards(view, condition, log.size(), {breaches, breaches});
  while (backwards.backwards(0)) ++back;
  fuzz::require(there == back, "as many stops forwards as backwards");
}

}  // namespace

REPLAN_FUZZ_TARGET(condition) {
  const auto read = parse_expression(input, kWorld);
  if (!read) {
    require(read.error().find('\n') == std::string::npos, "an error is one line: " + read.error());
    require(read.error().starts_with("character ") || read.error().starts_with("the expression is too long"),
            "an error names the place: " + read.error());
    return;
  }
  const std::string text = expression_text(*read);
  const auto again = parse_expression(text, kWorld);
  require(again.ok(), "what was printed is read back: " + text + (again.ok() ? "" : ": " + again.error()));
  require(*again == *read, "what was printed is read back equal: " + text);
  require(expression_text(*again) == text, "there is one spelling: " + text);
  if (read->root().type == ValueType::truth) walk(*read);
}
