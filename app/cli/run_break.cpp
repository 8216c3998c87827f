#include "app/cli/run_break.hpp"

#include <cmath>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/output.hpp"
#include "core/debug/event_words.hpp"
#include "core/plan/nth_name.hpp"
#include "core/session/lockstep.hpp"
#include "core/session/session.hpp"

namespace replan::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Where a run stopped.
struct Stop {
  std::string condition;
  std::size_t position = 0;  // events before it
  std::int64_t clock = 0;    // the robot's
  std::int64_t expansions = 0;
  int line = 0;  // as events hold it
  std::string line_name, line_text;
  std::string event;
  struct Value {
    std::string name, text;
    Json json;
  };
  std::vector<Value> values;  // that the condition reads
};

/// A condition that never came true.
struct Missed {
  std::string condition;
  bool held = false;  // before the first event: it cannot come true then
};

struct BreakReport {
  std::string planner;
  std::size_t events = 0;   // that were looked through
  std::vector<Stop> stops;  // the first of each condition that has one, in the order of their events
  std::vector<Missed> missed;
};

Json value_json(const Box& lattice, const TermValue& value) {
  if (value.type == ValueType::truth) return value.truth;
  if (value.type == ValueType::number) {
    if (std::isinf(value.number)) return "inf";
    if (std::trunc(value.number) == value.number) return static_cast<std::int64_t>(value.number);
    return value.number;
  }
  if (value.node >= lattice.node_count()) return nullptr;
  return coordinates_of(lattice.position(value.node), lattice.solid());
}

std::vector<Stop::Value> values_at(const Run& run, const Condition& condition, std::size_t position) {
  Probe probe(run.log_view(), condition, position);
  std::vector<Stop::Value> values;
  for (const Term& term : values_read(condition)) {
    const TermValue value = probe.value(term);
    values.push_back({term_text(condition, term), value_text(run.lattice(), term, value),
                      value_json(run.lattice(), value)});
  }
  return values;
}

Stop stop_of(const Session& session, const Hit& hit) {
  const Run& run = session.run();
  Stop stop;
  stop.condition = session.breakpoints().list()[hit.breakpoint].condition;
  stop.position = hit.position;
  stop.clock = static_cast<std::int64_t>(run.timeline().state_at(hit.position).scalar(Scalar::moves));
  stop.expansions = expansions_until(run, hit.position);
  stop.line = run.timeline().event(hit.position - 1).line;
  stop.line_name = "line " + std::to_string(stop.line);
  if (const auto page = read_page(run.info().id)) {
    stop.line_name = line_name(*page, stop.line);
    if (const PseudoLine* line = page->line(stop.line))
      stop.line_text = line->text.substr(std::min(line->text.find_first_not_of(' '), line->text.size()));
  }
  stop.event = event_text(run.log_view(), hit.position);
  stop.values = values_at(run, session.breakpoints().condition(hit.breakpoint), hit.position);
  return stop;
}

/// Those that are still looked for.
std::vector<Missed> missed_in(const Session& session) {
  std::vector<Missed> missed;
  const Breakpoints& breakpoints = session.breakpoints();
  for (std::size_t i = 0; i < breakpoints.list().size(); ++i)
    if (breakpoints.list()[i].enabled)
      missed.push_back({breakpoints.list()[i].condition,
                        Probe(session.run().log_view(), breakpoints.condition(i), 0).value().truth});
  return missed;
}

Result<void> look_for(Session& session, const std::vector<std::string>& conditions) {
  bool laws = false, oracle = false;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (const auto added = session.apply(AddBreakpoint{conditions[i]}); !added)
      return Error{"--break" + added.error().substr(std::string_view("breakpoint").size())};
    laws |= session.breakpoints().condition(i).uses(Happening::invariant);
    oracle |= session.breakpoints().condition(i).uses(Happening::oracle);
  }
  return laws || oracle ? session.apply(SetChecks{laws, oracle}) : Result<void>();
}

/// The first stop of those that are looked for; nothing: there is none. The session does all of it: running the mission on
/// as far as it takes, and asking the checkers.
Result<std::optional<Hit>> next_stop(Session& session, bool only_plan) {
  const auto first = [&session]() -> std::optional<Hit> {
    const auto hits = session.breakpoints().hits();
    return hits.empty() ? std::nullopt : std::optional(hits.front());
  };
  session.settle();
  if (!first() && !only_plan && session.breakpoints().wants_any()) {
    if (const auto gone = session.apply(GoToBreakpoint{1}); !gone) return Error{gone.error()};
    session.settle();
  }
  if (const std::string failure = session.failure(); !failure.empty()) return Error{failure};
  return first();
}

/// One condition after the other, in the order in which they come true: each is no longer looked for once it has.
Result<BreakReport> find_stops(Scenario world, const std::vector<std::string>& conditions, bool only_plan) {
  BreakReport report;
  world.debug = {};
  Session session(std::move(world));
  if (const auto set = look_for(session, conditions); !set) return Error{set.error()};
  for (;;) {
    const auto hit = next_stop(session, only_plan);
    if (!hit) return Error{hit.error()};
    if (!hit->has_value()) break;
    report.stops.push_back(stop_of(session, **hit));
    if (const auto off = session.apply(SwitchBreakpoint{(*hit)->breakpoint, false}); !off)
      return Error{off.error()};
  }
  report.events = session.run().timeline().size();
  report.missed = missed_in(session);
  return report;
}

/// What a stop's row in the table has no room for.
std::string details_of(const std::string& planner, const Stop& stop) {
  std::string text =
      "\n" + planner + ": " + stop.line_name + (stop.line_text.empty() ? "" : ": " + stop.line_text) + "\n";
  for (const Stop::Value& value : stop.values) text += "  " + value.name + " is " + value.text + "\n";
  return text;
}

std::string table_of(const std::vector<BreakReport>& reports) {
  using enum Table::Align;
  Table table({{"planner", left},
               {"stopped at", left},
               {"event"},
               {"clock"},
               {"expansions"},
               {"line", left},
               {"what happened", left}});
  std::string details;
  for (const BreakReport& report : reports) {
    for (const Stop& stop : report.stops) {
      table.add({report.planner, stop.condition, std::to_string(stop.position), std::to_string(stop.clock),
                 std::to_string(stop.expansions), stop.line_name, stop.event});
      details += details_of(report.planner, stop);
    }
    for (const Missed& missed : report.missed) {
      table.add({report.planner, "not reached: " + missed.condition, "", "", "", "",
                 counted(report.events, "event") + " looked through"});
      if (missed.held)
        details +=
            "\n" + report.planner + ": " + missed.condition +
            "\n  holds from the beginning, and a stop is where a condition comes true. Give each event "
            "a --break of its own.\n";
    }
  }
  return table.text() + details;
}

Json json_of(const std::string& planner, const Stop& stop) {
  Json one = {{"planner", planner},
              {"stopped", true},
              {"condition", stop.condition},
              {"event", stop.position},
              {"clock", stop.clock},
              {"expansions", stop.expansions},
              {"line", {{"number", stop.line}, {"name", stop.line_name}, {"text", stop.line_text}}},
              {"what", stop.event},
              {"values", Json::object()}};
  for (const Stop::Value& value : stop.values) one["values"][value.name] = value.json;
  return one;
}

std::string json_of(const std::vector<BreakReport>& reports) {
  Json document = {{"stops", Json::array()}};
  for (const BreakReport& report : reports) {
    for (const Stop& stop : report.stops) document["stops"].push_back(json_of(report.planner, stop));
    for (const Missed& missed : report.missed)
      document["stops"].push_back({{"planner", report.planner},
                                   {"stopped", false},
                                   {"condition", missed.condition},
                                   {"events", report.events},
                                   {"held_from_the_beginning", missed.held}});
  }
  return document.dump(2) + "\n";
}

}  // namespace

void BreakArguments::declare(CLI::App& command) {
  command
      .add_option(
          "--break", conditions,
          "Stop where this condition comes true first and tell where that is; several times for the first "
          "stop of each of several conditions")
      ->type_name("EXPR")
      ->allow_extra_args(false);
}

Result<int> BreakArguments::run(const Scenario& world, bool only_plan, bool json) const {
  std::vector<BreakReport> reports;
  bool all = true;
  std::vector<std::string> names;
  for (const PlannerChoice& choice : world.planners) names.push_back(choice.id);
  names = told_apart(names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    Scenario one = world;
    one.planners = {world.planners[i]};
    auto report = find_stops(std::move(one), conditions, only_plan);
    if (!report) return Error{report.error()};
    report->planner = names[i];
    all &= !report->stops.empty();
    reports.push_back(std::move(report.value()));
  }
  print(json ? json_of(reports) : table_of(reports));
  return all ? kDone : kFailed;
}

std::string conditions_help() {
  constexpr std::size_t kIndent = 6;
  const auto row = [](std::string_view form, std::string_view help) {
    return "  " + std::string(form) + "\n" + std::string(kIndent, ' ') + wrapped(help, kIndent) + "\n";
  };
  std::string text =
      "Conditions (--break) are made with || && ! == != < <= > >= + - * / and parentheses of numbers, inf, "
      "true, "
      "false,\nnone, cells such as (12, 40), and what follows; in a world of more than one layer cells are "
      "(12, 40, 2)\nand x, y becomes x, y, z:\n";
  for (const ConditionName& name : condition_names()) text += row(name.form, name.help);
  text += "The names of event():\n";
  for (const HappeningName& each : happening_names()) text += row(each.name, each.help);
  return text;
}

}  // namespace replan::cli
