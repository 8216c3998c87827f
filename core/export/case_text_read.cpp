#include <algorithm>
#include <charconv>

#include "core/export/case_text.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

/// The rest of the first line that begins so, past what mail puts before a line; nothing if there is none.
std::optional<std::string_view> find_line(std::string_view text, std::string_view beginning) {
  text = without_byte_order_mark(text);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t>"), line.size()));
    if (line.starts_with(beginning)) return line.substr(beginning.size());
  }
  return std::nullopt;
}

Error missing_line(const std::string& origin, std::string_view beginning) {
  beginning.remove_suffix(1);  // the blank
  return Error{origin + ": the line that begins with '" + std::string(beginning) +
               "' is missing: copy the text whole, from 'Replan case' to the end of the scenario"};
}

}  // namespace

bool is_case_text(std::string_view text) {
  return find_line(text, kCaseTitle).has_value();
}

Result<CaseMoment> parse_case_text(std::string_view text, const std::string& origin) {
  const auto at_line = find_line(text, kCaseAt), scenario_line = find_line(text, kCaseScenario);
  if (!at_line || !scenario_line) return missing_line(origin, at_line ? kCaseScenario : kCaseAt);
  CaseMoment moment;
  JsonReader reader(origin + ", line 'at'");
  if (reader.parse(*at_line)) {
    const JsonNode at = reader.root();
    at.expect_object({"pane", "event", "state"});
    if (const auto pane = at.require("pane")) moment.pane = static_cast<std::size_t>(pane->whole(0, 1000));
    if (const auto event = at.require("event"))
      moment.event = static_cast<std::size_t>(event->whole(0, std::int64_t{1} << 40));
    if (const auto state = at.require("state")) {
      const std::string digits = state->text();
      const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), moment.state, 16);
      if (digits.size() != 16 || read.ptr != digits.data() + digits.size())
        state->fail("must be 16 digits of a hash");
    }
  }
  if (!reader.ok()) return Error{reader.error()};
  const std::string where = origin + ", line 'scenario'";
  Result<Scenario> scenario = parse_scenario(std::string(*scenario_line), where, kNoFolder);
  if (!scenario) return Error{scenario.error()};
  moment.scenario = std::move(scenario.value());
  if (moment.pane >= moment.scenario.planners.size())
    return Error{origin + ", line 'at': the scenario has no planner number " + std::to_string(moment.pane)};
  return moment;
}

}  // namespace replan
