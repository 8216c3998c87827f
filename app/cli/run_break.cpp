#include "app/cli/run_break.hpp"

#include <cmath>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/output.hpp"
#include "core/debug/event_words.hpp"
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

struct BreakReport {
  std::string planner;
  std::size_t events = 0;  // that were looked through
  std::optional<Stop> stop;
  std::vector<std::string> held;  // conditions that hold before the first event: they cannot come true then
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

std::vector<std::string> held_from_the_beginning(const Session& session) {
  std::vector<std::string> held;
  const Breakpoints& breakpoints = session.breakpoints();
  for (std::size_t i = 0; i < breakpoints.list().size(); ++i)
    if (Probe(session.run().log_view(), breakpoints.condition(i), 0).value().truth)
      held.push_back(breakpoints.list()[i].condition);
  return held;
}

/// The session does all of it: running the mission on as far as it takes, and asking the checkers.
Result<BreakReport> find_stop(Scenario world, const std::vector<std::string>& conditions, bool only_plan) {
  BreakReport report{.planner = world.planners.front().id, .events = 0, .stop = {}, .held = {}};
  world.debug = {};
  Session session(std::move(world));
  bool laws = false, oracle = false;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (const auto added = session.apply(AddBreakpoint{conditions[i]}); !added)
      return Error{"--break" + added.error().substr(std::string_view("breakpoint").size())};
    laws |= session.breakpoints().condition(i).uses(Happening::invariant);
    oracle |= session.breakpoints().condition(i).uses(Happening::oracle);
  }
  if (laws || oracle)
    if (const auto set = session.apply(SetChecks{laws, oracle}); !set) return Error{set.error()};
  session.settle();
  const auto& hits = session.breakpoints().hits();
  if (hits.empty() && !only_plan) {
    if (const auto gone = session.apply(GoToBreakpoint{1}); !gone) return Error{gone.error()};
    session.settle();
  }
  if (const std::string failure = session.failure(); !failure.empty()) return Error{failure};
  report.events = session.run().timeline().size();
  if (!session.breakpoints().hits().empty())
    report.stop = stop_of(session, session.breakpoints().hits().front());
  else
    report.held = held_from_the_beginning(session);
  return report;
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
    if (!report.stop) {
      table.add({report.planner, "not reached", "", "", "", "",
                 counted(report.events, "event") + " looked through"});
      for (const std::string& condition : report.held)
        details +=
            "\n" + report.planner + ": " + condition +
            "\n  holds from the beginning, and a stop is where a condition comes true. Give each event "
            "a --break of its own.\n";
      continue;
    }
    const Stop& stop = *report.stop;
    table.add({report.planner, stop.condition, std::to_string(stop.position), std::to_string(stop.clock),
               std::to_string(stop.expansions), stop.line_name, stop.event});
    details += "\n" + report.planner + ": " + stop.line_name +
               (stop.line_text.empty() ? "" : ": " + stop.line_text) + "\n";
    for (const Stop::Value& value : stop.values) details += "  " + value.name + " is " + value.text + "\n";
  }
  return table.text() + details;
}

std::string json_of(const std::vector<BreakReport>& reports) {
  Json document = {{"stops", Json::array()}};
  for (const BreakReport& report : reports) {
    Json one = {{"planner", report.planner}, {"stopped", report.stop.has_value()}};
    if (report.stop) {
      const Stop& stop = *report.stop;
      one["condition"] = stop.condition;
      one["event"] = stop.position;
      one["clock"] = stop.clock;
      one["expansions"] = stop.expansions;
      one["line"] = {{"number", stop.line}, {"name", stop.line_name}, {"text", stop.line_text}};
      one["what"] = stop.event;
      one["values"] = Json::object();
      for (const Stop::Value& value : stop.values) one["values"][value.name] = value.json;
    } else {
      one["events"] = report.events;
      one["held_from_the_beginning"] = report.held;
    }
    document["stops"].push_back(std::move(one));
  }
  return document.dump(2) + "\n";
}

}  // namespace

void BreakArguments::declare(CLI::App& command) {
  command
      .add_option(
          "--break", conditions,
          "Stop where this condition comes true first and tell where that is; several times for several "
          "conditions")
      ->type_name("EXPR")
      ->allow_extra_args(false);
}

Result<int> BreakArguments::run(const Scenario& world, bool only_plan, bool json) const {
  std::vector<BreakReport> reports;
  bool all = true;
  for (const PlannerChoice& choice : world.planners) {
    Scenario one = world;
    one.planners = {choice};
    auto report = find_stop(std::move(one), conditions, only_plan);
    if (!report) return Error{report.error()};
    all &= report->stop.has_value();
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
