// Conditions on random logs: scanning forwards, scanning backwards and reading every position by itself find
// the same stops.
#include <cmath>
#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

#include "core/base/words.hpp"
#include "core/debug/probe.hpp"
#include "core/plan/tree_values.hpp"
#include "core/sim/mission.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::condition_property_test {
namespace {

constexpr int kLogs = 330;
constexpr int kConditionsPerLog = 40;

Cell random_cell(Random& random, const Box& box) {
  return box.position(random.below(static_cast<std::uint32_t>(box.node_count())));
}

/// Writes random expressions. Numbers are such as the logs hold.
struct Writer {
  Random& random;
  Box world;
  std::vector<Cell> cells;  // a few, so that several terms read the same vertex

  std::string cell() {
    return cell_text(cells[random.below(static_cast<std::uint32_t>(cells.size()))], world.solid());
  }
  std::string pick(std::initializer_list<const char*> of) {
    return of.begin()[random.below(static_cast<std::uint32_t>(of.size()))];
  }
  std::string value_number() {
    if (random.chance(0.7)) return pick({"g", "rhs", "dist", "k1", "k2", "order", "times"}) + cell();
    if (random.chance(0.3))
      return pick({"vertex_x", "vertex_cost", "vertex_parent", "vertex_side"}) + vertex();
    return pick({"km", "size(U)", "moves", "replans", "expansions", "samples", "admissible", "score(winner)",
                 "best", "vertices", "generation"});
  }
  std::string vertex() { return "(" + std::to_string(random.below(6)) + ")"; }
  std::string value_cell() {
    return random.chance(0.6) ? pick({"lp", "rp"}) + cell()
                              : pick({"robot", "start", "goal", "last", "sub_goal"});
  }
  std::string value_truth() { return pick({"queued", "known", "wall", "consistent"}) + cell(); }
  std::string number(int depth) {
    const std::uint32_t kind = depth <= 0 ? random.below(6) : random.below(9);
    if (kind < 4) return value_number();
    if (kind == 4)
      return random.chance(0.1) ? "inf" : std::to_string(random.below(40)) + pick({"", ".5", ".25"});
    if (kind == 5) return random.chance(0.3) ? "line" : value_number();
    if (kind == 6) return "-" + number(depth - 1);
    return "(" + number(depth - 1) + pick({"+", "-", "*", "/"}) + number(depth - 1) + ")";
  }
  std::string pulse() {
    const std::uint32_t kind = random.below(7);
    if (kind == 6) return "rewired" + vertex();
    if (kind == 0) return "taken";
    if (kind == 1) return "taken" + cell();
    if (kind < 4) {
      const std::string value = random.chance(0.6)   ? value_number()
                                : random.chance(0.5) ? value_cell()
                                                     : value_truth();
      return "changed(" + value + ")";
    }
    return "event(" +
           pick({"plan", "replan", "underconsistent", "sight_failed", "first_path", "rewired", "no_path",
                 "blocked", "surprise", "move", "arrival", "invariant", "oracle"}) +
           ")";
  }
  std::string truth(int depth) {
    const std::uint32_t kind = depth <= 0 ? random.below(7) : random.below(11);
    if (kind < 2) return pulse();
    if (kind == 2) return value_truth();
    if (kind == 3) return "line(" + std::to_string(random.below(65)) + ")";
    if (kind == 4)
      return "(" + value_cell() + pick({"==", "!="}) + (random.chance(0.5) ? cell() : value_cell()) + ")";
    if (kind < 7)
      return "(" + number(depth - 1) + pick({"==", "!=", "<", "<=", ">", ">="}) + number(depth - 1) + ")";
    if (kind == 7) return "!" + truth(depth - 1);
    if (kind == 8) return "(" + truth(depth - 1) + pick({"==", "!="}) + truth(depth - 1) + ")";
    return "(" + truth(depth - 1) + pick({"&&", "||"}) + truth(depth - 1) + ")";
  }
};

/// The run of a random scenario, and what checkers might have said of it.
struct RandomLog {
  PlannerChoice choice;
  const PlannerInfo* info = nullptr;
  Box lattice;
  Timeline log;
  std::vector<std::size_t> breaches, disagreements;

  [[nodiscard]] LogView view() const { return {log, lattice, *info, choice.settings}; }
};

/// A quick one: its cells are a metre wide.
void let_drive(Random& random, RobotSetup& robot) {
  robot.kind = "dwa";
  robot.radius = random.chance(0.5) ? 0 : 0.3;
  robot.settings.set("v_max", 2);
  robot.settings.set("w_max", 1.5);
  robot.settings.set("acceleration", 2);
  robot.settings.set("brake", 2);
  robot.settings.set("speeds", 4);
  robot.settings.set("turns", 7);
  robot.settings.set("horizon", 1.5);
}

RandomLog random_log(Random& random, const PlannerInfo& info) {
  Scenario scenario;
  if (!info.planar && random.chance(0.3)) {
    const auto size = random_size<3>(random, {3, 3, 2}, {7, 6, 5});
    scenario.map = GridMap(size[0], size[1], size[2]);
    scenario.map.blocked = random_cells<3>(random, size);
  } else {
    const auto size = random_size<2>(random, {6, 5}, {16, 14});
    scenario.map = GridMap(size[0], size[1]);
    scenario.map.blocked = random_cells<2>(random, size);
  }
  const Box world = scenario.map.box();
  scenario.start = random_cell(random, world);
  scenario.goal = random_cell(random, world);
  scenario.map.set(scenario.start, false);
  scenario.map.set(scenario.goal, false);
  scenario.robot.knowledge = static_cast<Knowledge>(random.below(3));
  if (!world.solid() && random.chance(0.3)) let_drive(random, scenario.robot);
  for (int n = random.between(0, 4); n > 0; --n) {
    Surprise surprise;
    surprise.at.move = random.between(0, 12);
    surprise.announced = random.chance(0.5);
    surprise.cells.push_back({random_cell(random, world), random.chance(0.6)});
    if (random.chance(0.25)) surprise.goal = random_cell(random, world);
    scenario.surprises.push_back(surprise);
  }
  if (random.chance(0.3))
    scenario.movers.push_back({.way = {random_cell(random, world), random_cell(random, world)}});
  RandomLog result;
  result.info = &info;
  result.choice = {std::string(info.id), random_settings(random, info)};
  result.lattice = world;
  result.log = Timeline(initial_state(scenario, result.choice));
  Recorder recorder;
  const auto mission = make_mission(scenario, result.choice, &recorder);
  while (mission->advance(100) && recorder.buffer().size() < 6000) {
  }
  result.log.append(recorder.take());
  for (std::size_t p = 1; p <= result.log.size(); ++p) {
    if (random.chance(0.003)) result.breaches.push_back(p);
    if (random.chance(0.001)) result.disagreements.push_back(p);
  }
  return result;
}

/// The plain way: everything is read out of a state that is walked along whole.
class Plain {
 public:
  Plain(const RandomLog& log, const Condition& condition) : log_(log), condition_(condition) {}

  std::vector<std::size_t> stops() {
    std::vector<std::size_t> found;
    SearchState state = log_.log.state_at(0), before = state;
    bool held = false;
    bool popped = false;
    std::int64_t expansions = 0, expansions_before = 0;
    for (std::size_t p = 0; p <= log_.log.size(); ++p) {
      const Event latest = p == 0 ? Event{} : log_.log.event(p - 1);
      const Event* event = p == 0 ? nullptr : &latest;
      if (event != nullptr) {
        before = state;
        state.apply(*event);
        expansions_before = expansions;
        if (event->kind == EventKind::plan_begin) popped = false;
        if (event->kind == EventKind::pop) popped = true;
        if (event->kind == EventKind::visit && popped) ++expansions;
      }
      now_ = {&state, expansions};
      then_ = {&before, expansions_before};
      position_ = p;
      event_ = event;
      line_ = event == nullptr ? 0 : event->line;
      const bool holds = truth(condition_.root(), now_);
      event_ = nullptr;
      const bool lasting = truth(condition_.root(), now_);
      if (p > 0 && holds && (!held || !lasting)) found.push_back(p);
      held = holds;
    }
    return found;
  }

 private:
  struct Moment {
    const SearchState* state = nullptr;
    std::int64_t expansions = 0;
  };
  const Term& part(std::uint16_t index) const { return condition_.terms[index]; }
  NodeId node(const Term& term) const { return log_.lattice.node(term.cell); }

  bool changed(const Term& term) {
    if (term.type == ValueType::truth) return truth(term, now_) != truth(term, then_);
    if (term.type == ValueType::cell) return cell(term, now_) != cell(term, then_);
    return number(term, now_) != number(term, then_);
  }
  bool event(const Term& term, const Moment& at) {
    if (event_ == nullptr) return false;
    const Event& e = *event_;
    const SearchState& state = *at.state;
    const auto told = [&](const std::vector<std::size_t>& list) {
      return std::find(list.begin(), list.end(), position_) != list.end();
    };
    switch (term.happening) {
      case Happening::plan:
        return e.kind == EventKind::plan_begin && e.delta == 0;
      case Happening::replan:
        return e.kind == EventKind::plan_begin && e.delta > 0;
      case Happening::underconsistent:
        return log_.info->values.lookahead() && e.kind == EventKind::pop &&
               state.g(e.node) < state.rhs(e.node);
      case Happening::sight_failed:
        return e.kind == EventKind::sight && (e.delta >> 32) == 0;
      case Happening::first_path:
        return e.kind == EventKind::scalar && static_cast<Scalar>(e.node) == Scalar::best &&
               state.scalar(Scalar::best) != 0 && (state.scalar(Scalar::best) ^ e.delta) == 0;
      case Happening::rewired:
        return e.kind == EventKind::rewired;
      case Happening::no_path:
        return e.kind == EventKind::plan_end && !has_path(static_cast<PlanStatus>(e.delta));
      case Happening::blocked:
        return e.kind == EventKind::collision || e.kind == EventKind::gave_up ||
               (e.kind == EventKind::waiting && e.node != state.wanted_goal());
      case Happening::surprise:
        return e.kind == EventKind::surprise;
      case Happening::move:
        return e.kind == EventKind::move;
      case Happening::arrival:
        return e.kind == EventKind::arrival;
      case Happening::invariant:
        return told(log_.breaches);
      case Happening::oracle:
        return told(log_.disagreements);
    }
    return false;
  }
  bool truth(const Term& term, const Moment& at) {
    const SearchState& state = *at.state;
    const auto l = [&] { return truth(part(term.left), at); };
    const auto r = [&] { return truth(part(term.right), at); };
    switch (term.op) {
      case Op::truth_literal:
        return term.truth;
      case Op::queued:
        return state.queued(node(term));
      case Op::known:
        return state.known_blocked(node(term));
      case Op::wall:
        return state.wall(node(term));
      case Op::consistent:
        return !log_.info->values.lookahead() || state.g(node(term)) == state.rhs(node(term));
      case Op::on_line:
        return line_ == static_cast<int>(term.number);
      case Op::taken:
        return event_ != nullptr && event_->kind == EventKind::pop && event_->node == node(term);
      case Op::taken_any:
        return event_ != nullptr && event_->kind == EventKind::pop;
      case Op::rewired:
        return event_ != nullptr && event_->kind == EventKind::rewired && event_->node == term.number;
      case Op::changed:
        return event_ != nullptr && changed(part(term.left));
      case Op::event:
        return event(term, at);
      case Op::either:
        return l() || r();
      case Op::both:
        return l() && r();
      case Op::negated:
        return !l();
      default:
        return compared(term, at);
    }
  }
  bool compared(const Term& term, const Moment& at) {
    const Term &a = part(term.left), &b = part(term.right);
    const bool equal = term.op == Op::equal;
    if (a.type == ValueType::truth) return (truth(a, at) == truth(b, at)) == equal;
    if (a.type == ValueType::cell) return (cell(a, at) == cell(b, at)) == equal;
    // Costs of such small worlds are held by doubles exactly.
    const double x = number(a, at), y = number(b, at);
    switch (term.op) {
      case Op::equal:
        return x == y;
      case Op::unequal:
        return x != y;
      case Op::less:
        return x < y;
      case Op::at_most:
        return x <= y;
      case Op::more:
        return x > y;
      default:
        return x >= y;
    }
  }
  NodeId cell(const Term& term, const Moment& at) {
    const SearchState& state = *at.state;
    switch (term.op) {
      case Op::lp:
        return state.lp(node(term));
      case Op::rp:
        return state.rp(node(term));
      case Op::robot:
        return state.node(Scalar::robot);
      case Op::start:
        return state.node(Scalar::start);
      case Op::goal:
        return state.node(Scalar::goal);
      case Op::last:
        return state.node(Scalar::last);
      case Op::sub_goal:
        return state.node(Scalar::sub_goal);
      default:
        return term.cell == kNowhere ? kNoNode : node(term);
    }
  }
  double of_tree(const Term& term, const SearchState& state) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const auto vertex = static_cast<std::uint32_t>(term.number);
    const bool none = !log_.info->sampling;
    if (term.field == "vertex_cost") return none ? kNone : vertex_cost(state, vertex).to_double();
    if (term.field == "vertex_side") return none ? 0 : static_cast<double>(vertex_side(state, vertex));
    if (term.field == "vertex_x") return none ? kNone : point_of(vertex_place(state, vertex, false)).x;
    const std::uint32_t parent = none ? 0 : vertex_parent(state, vertex);
    return parent == kNoNode ? kNone : parent;
  }
  double number(const Term& term, const Moment& at) {
    const SearchState& state = *at.state;
    const auto l = [&] { return number(part(term.left), at); };
    const auto r = [&] { return number(part(term.right), at); };
    switch (term.op) {
      case Op::number_literal:
        return term.number;
      case Op::tree_cost:
      case Op::tree_count:
        return of_tree(term, state);
      case Op::g:
        return state.g(node(term)).to_double();
      case Op::rhs:
        return state.rhs(node(term)).to_double();
      case Op::dist:
        return state.dist(node(term)).to_double();
      case Op::k1:
        return state.queued(node(term)) ? state.k1(node(term)).to_double() : HUGE_VAL;
      case Op::k2:
        return state.queued(node(term)) ? state.k2(node(term)).to_double() : HUGE_VAL;
      case Op::order:
        return state.order(node(term));
      case Op::times:
        return state.times_expanded(node(term));
      case Op::km:
        return state.km().to_double();
      case Op::queue_size: {
        int count = 0;
        for (NodeId n = 0; n < state.node_count(); ++n) count += state.queued(n) ? 1 : 0;
        return count;
      }
      case Op::moves:
        return static_cast<double>(state.scalar(Scalar::moves));
      case Op::replans:
        return static_cast<double>(state.scalar(Scalar::replans));
      case Op::best:
        return state.scalar(Scalar::best) == 0
                   ? HUGE_VAL
                   : Cost{static_cast<std::int64_t>(state.scalar(Scalar::best))}.to_double();
      case Op::vertices:
        return static_cast<double>(state.scalar(Scalar::vertices));
      case Op::generation:
        return static_cast<double>(state.scalar(Scalar::generation));
      case Op::admissible: {
        const std::uint64_t held = state.scalar(Scalar::admissible);
        return held == 0 ? HUGE_VAL : static_cast<double>(held - 1);
      }
      case Op::score:
        return state.scalar(Scalar::score) == 0 ? HUGE_VAL : score_of(state.scalar(Scalar::score));
      case Op::expansions:
        return static_cast<double>(at.expansions);
      case Op::samples:
        return log_.info->sampling ? static_cast<double>(at.expansions) : 0;
      case Op::line:
        return line_;
      case Op::opposite:
        return -l();
      case Op::plus:
        return l() + r();
      case Op::minus:
        return l() - r();
      case Op::product:
        return l() * r();
      default:
        return l() / r();
    }
  }

  const RandomLog& log_;
  const Condition& condition_;
  Moment now_, then_;
  std::size_t position_ = 0;
  const Event* event_ = nullptr;
  int line_ = 0;
};

/// All stops, found piecewise in pieces of random length.
std::vector<std::size_t> forwards(Random& random, const RandomLog& log, const Condition& condition,
                                  std::size_t from) {
  Probe probe(log.view(), condition, from, {log.breaches, log.disagreements});
  std::vector<std::size_t> found;
  while (probe.position() < log.log.size()) {
    const std::size_t piece = random.chance(0.5) ? log.log.size() : 1 + random.below(300);
    if (const auto stop = probe.forwards(std::min(log.log.size(), probe.position() + piece)))
      found.push_back(*stop);
  }
  return found;
}

std::vector<std::size_t> backwards(Random& random, const RandomLog& log, const Condition& condition,
                                   std::size_t from) {
  Probe probe(log.view(), condition, from, {log.breaches, log.disagreements});
  std::vector<std::size_t> found;
  while (probe.position() > 0) {
    const std::size_t piece = random.chance(0.5) ? log.log.size() : 1 + random.below(300);
    if (const auto stop = probe.backwards(probe.position() - std::min(piece, probe.position())))
      found.push_back(*stop);
  }
  std::reverse(found.begin(), found.end());
  return found;
}

TEST(Conditions, stopWhereReadingEveryPositionSaysSo) {
  Random random(20260101);
  std::int64_t conditions = 0, stops = 0, silent = 0, events = 0;
  for (int i = 0; i < kLogs; ++i) {
    const PlannerInfo& info = planners()[static_cast<std::size_t>(i) % planners().size()];
    const RandomLog log = random_log(random, info);
    events += static_cast<std::int64_t>(log.log.size());
    Writer writer{random, log.lattice, {}};
    for (int n = 0; n < 3; ++n) writer.cells.push_back(random_cell(random, log.lattice));
    for (int k = 0; k < kConditionsPerLog; ++k) {
      const std::string text = writer.truth(3);
      const auto condition = parse_condition(text, log.lattice);
      ASSERT_TRUE(condition.ok()) << text << ": " << condition.error();
      const auto again = parse_condition(expression_text(*condition), log.lattice);
      ASSERT_TRUE(again.ok() && *again == *condition) << text << " as " << expression_text(*condition);
      const std::vector<std::size_t> right = Plain(log, *condition).stops();
      ASSERT_EQ(forwards(random, log, *condition, 0), right) << info.id << " " << text;
      ASSERT_EQ(backwards(random, log, *condition, log.log.size()),
                [&] {  // the end itself is not before the end
                  auto all = right;
                  if (!all.empty() && all.back() == log.log.size()) all.pop_back();
                  return all;
                }())
          << info.id << " " << text;
      const std::size_t middle = random.below(static_cast<std::uint32_t>(log.log.size()));
      const std::vector<std::size_t> later(std::upper_bound(right.begin(), right.end(), middle), right.end());
      ASSERT_EQ(forwards(random, log, *condition, middle), later)
          << info.id << " " << text << " from " << middle;
      ++conditions;
      stops += static_cast<std::int64_t>(right.size());
      silent += right.empty();
    }
  }
  std::printf("%lld conditions on %lld events, %lld stops, %lld never stop\n",
              static_cast<long long>(conditions), static_cast<long long>(events),
              static_cast<long long>(stops), static_cast<long long>(silent));
  EXPECT_GT(conditions - silent, 3000) << "most conditions never stop: the test says little";
}

/// Values along the log, as a watch sees them, and at positions taken by chance.
TEST(Conditions, quantitiesAreRightEverywhere) {
  Random random(77);
  for (int i = 0; i < 60; ++i) {
    const RandomLog log = random_log(random, planners()[static_cast<std::size_t>(i) % planners().size()]);
    Writer writer{random, log.lattice, {random_cell(random, log.lattice), random_cell(random, log.lattice)}};
    for (int k = 0; k < 20; ++k) {
      const std::string text = writer.number(2);
      const auto quantity = parse_quantity(text, log.lattice);
      ASSERT_TRUE(quantity.ok()) << text << ": " << quantity.error();
      Probe walking(log.view(), *quantity, 0);
      double value = walking.value().number;
      std::size_t known = 0;
      const auto check = [&](std::size_t until) {  // the value is `value` from `known` to before `until`
        if (known >= until) return;
        const std::size_t p = known + random.below(static_cast<std::uint32_t>(until - known));
        const double fresh = Probe(log.view(), *quantity, p).value().number;
        ASSERT_TRUE(fresh == value || (std::isnan(fresh) && std::isnan(value)))
            << text << " at " << p << ": " << fresh << " instead of " << value;
        known = until;
      };
      for (int changes = 0; changes < 400 && walking.next_change(log.log.size()); ++changes) {
        check(walking.position());
        value = walking.value().number;
      }
    }
  }
}

}  // namespace
}  // namespace replan::test::condition_property_test
