#include "tests/support/law_oracle.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "tests/support/worlds.hpp"

namespace replan::oracle {
namespace {

/// A run's values in plain arrays, and the laws as functions of them.
class Bench {
 public:
  explicit Bench(const LogView& view)
      : view_(view), rules_(view.rules()), state_(view.log.state_at(0)), f_(view.info.key.f(view.settings)) {
    world_.size = {view.lattice.width(), view.lattice.height(), 1};
    world_.blocked.resize(state_.node_count());
    if (view.radius > 0) rules_.corners = CornerRule::none;  // with a size it cuts no corners
    map_changed();
  }

  std::optional<Fault> run(std::span<const Event> events) {
    for (std::size_t i = 0; i < events.size(); ++i) {
      const Event& event = events[i];
      const bool stands = event.kind == EventKind::plan_end;
      if (stands || event.kind == EventKind::pop) {
        if (const auto wrong = step_faults(); !wrong.empty()) return Fault{i, wrong};
        written_.clear();
        g_before_.clear();
        taken_.reset();
        disturbed_ = false;
      }
      if (event.kind == EventKind::epoch)
        for (NodeId n = 0; n < world_.blocked.size(); ++n) g_before_.try_emplace(n, state_.g(n).raw);
      if (event.kind == EventKind::pop) taken_ = state_.value(EventKind::queue, event.node);
      if (event.kind == EventKind::g) g_before_.try_emplace(event.node, state_.g(event.node).raw);
      state_.apply(event);
      if (event.kind == EventKind::queue) written_.insert(event.node);
      if (event.kind == EventKind::known) map_stale_ = true;
      disturbed_ |= event.kind == EventKind::known ||
                    (event.kind == EventKind::scalar && event.node == static_cast<NodeId>(Scalar::start));
      if (event.kind == EventKind::sight && event.line == 106 && event.delta >> 32 != 0)
        seen_[event.node] = static_cast<NodeId>(event.delta);
      if (!stands) continue;
      if (const auto wrong = plan_fault(static_cast<PlanStatus>(event.delta))) return Fault{i + 1, {*wrong}};
      seen_.clear();
    }
    return std::nullopt;
  }

 private:
  struct Move {
    NodeId to;
    Raw cost;
  };

  void map_changed() {
    for (NodeId n = 0; n < world_.blocked.size(); ++n) world_.blocked[n] = state_.known_blocked(n) ? 1 : 0;
    if (view_.radius > 0) world_.blocked = grown(world_, view_.radius);
    successors_.clear();
    for (NodeId n = 0; n < world_.blocked.size(); ++n) {
      successors_.emplace_back();
      for (const std::size_t other : neighbours(world_, rules_, n))
        successors_.back().push_back({static_cast<NodeId>(other), step_between(world_, n, other)});
    }
    penalty_ = test::expected_penalties(view_.info, view_.settings, world_);
    map_stale_ = false;
  }

  std::vector<NodeId> step_faults() {
    if (map_stale_) map_changed();
    costs_.clear();
    for (NodeId n = 0; n < world_.blocked.size(); ++n) costs_.push_back(state_.g(n).raw);
    std::vector<NodeId> wrong;
    for (NodeId n = 0; n < world_.blocked.size(); ++n) {
      const bool holds = any_angle()                         ? any_angle_holds(n)
                         : view_.info.values.waves           ? wave_holds(n)
                         : view_.info.values.interpolated    ? interpolated_holds(n)
                         : view_.info.values.lookahead()     ? lookahead_holds(n)
                         : view_.info.values.laws == "jumps" ? jump_holds(n)
                                                             : best_first_holds(n);
      if (!holds) wrong.push_back(n);
    }
    return wrong;
  }

  [[nodiscard]] bool on_map(NodeId n) const { return n < world_.blocked.size(); }
  [[nodiscard]] Raw penalty(NodeId n) const { return penalty_.empty() ? 0 : penalty_[n]; }
  [[nodiscard]] Raw sum(Raw a, Raw b) const { return std::min(a + b, kNever); }
  [[nodiscard]] Raw h(NodeId a, NodeId b) const {
    const Parameter* parameter = find_parameter(view_.info.parameters, "heuristic");
    if (parameter == nullptr) return 0;
    static const std::map<std::string_view, Heuristic> kByName = {{"octile", Heuristic::octile},
                                                                  {"euclidean", Heuristic::euclidean},
                                                                  {"chebyshev", Heuristic::chebyshev},
                                                                  {"manhattan", Heuristic::manhattan},
                                                                  {"zero", Heuristic::zero}};
    const auto choice = static_cast<std::size_t>(view_.settings.get(*parameter));
    return estimate(world_, rules_, kByName.at(parameter->choices[choice]), a, b);
  }

  bool lookahead_holds(NodeId s) {
    const Raw g = state_.g(s).raw, rhs = state_.rhs(s).raw;
    const bool from_goal = view_.info.from_goal;
    const NodeId root = state_.node(from_goal ? Scalar::goal : Scalar::start);
    const NodeId target = state_.node(from_goal ? Scalar::start : Scalar::goal);
    Raw best = kNever;
    NodeId parent = kNoNode;
    for (const Move& move : successors_[s]) {
      const Raw offer = sum(move.cost, sum(state_.g(move.to).raw, state_.dist(move.to).raw));
      if (offer < best) best = offer, parent = move.to;
    }
    if (s == root) best = 0, parent = root;
    if (rhs != best || state_.lp(s) != parent) return false;
    if (state_.queued(s) != (g != rhs)) return false;
    if (state_.dist(s).raw != penalty(s)) return false;
    if (!state_.queued(s) || !on_map(target)) return true;
    const Raw key = sum(sum(std::min(g, rhs), h(target, s)), state_.km().raw);
    return written_.contains(s) ? state_.k1(s).raw == key : state_.k1(s).raw <= key;
  }

  /// By all moves, then all ways across squares, with their ends; equal ones are told apart by the first end, then by the
  /// second, none before any.
  bool interpolated_holds(NodeId s) {
    const Raw g = state_.g(s).raw, rhs = state_.rhs(s).raw;
    const NodeId goal = state_.node(Scalar::goal), start = state_.node(Scalar::start);
    std::tuple<Raw, NodeId, NodeId> best{kNever, 0, 0};  // nodes + 1
    for (const Move& move : successors_[s])
      if (const Raw sum = costs_[move.to] + move.cost; sum < kNever)
        best = std::min(best, {sum, move.to + 1u, NodeId{0}});
    const Place p = world_.place(s);
    for (const int y : {-1, 1})
      for (const int x : {-1, 1})
        for (const int axis : {0, 1}) {
          const Raw sum = way_across(world_, costs_, p, {x, y, 0}, axis);
          if (sum >= kNever) continue;
          const Place straight{p[0] + (axis == 0 ? x : 0), p[1] + (axis == 1 ? y : 0), 0};
          const auto end = static_cast<NodeId>(world_.index(straight)),
                     other = static_cast<NodeId>(world_.index({p[0] + x, p[1] + y, 0}));
          best = std::min(best, {sum, end + 1u, other + 1u});
        }
    if (s == goal) best = {0, goal + 1u, 0};
    const auto side = static_cast<NodeId>(state_.value(fields::kSide.kind, s));
    if (std::tuple(rhs, state_.lp(s) + 1u, side) != best) return false;
    if (state_.queued(s) != (g != rhs)) return false;
    if (!state_.queued(s) || !on_map(start)) return true;
    __extension__ using Wide = __int128;
    const auto share = static_cast<Raw>(static_cast<Wide>(h(start, s)) * 759'250'124 >> 30);
    const Raw key = sum(sum(std::min(g, rhs), share), state_.km().raw);
    return written_.contains(s) ? state_.k1(s).raw == key : state_.k1(s).raw <= key;
  }

  // Of searches in waves. NEW, OPEN and CLOSED are 0, 1 and 2.
  [[nodiscard]] std::uint64_t tag(NodeId s) const { return state_.value(own_field(0), s); }
  [[nodiscard]] Raw own_cost(int field, NodeId s) const {
    return static_cast<Raw>(state_.value(own_field(field), s));
  }
  [[nodiscard]] Raw penalty_in_key(NodeId s) const {
    return state_.dist(s).raw >= kNever ? 0 : state_.dist(s).raw;
  }
  [[nodiscard]] bool focused() const { return view_.info.values.declares(own_field(2)); }

  bool wave_holds(NodeId s) {
    const Raw g = state_.g(s).raw;
    const bool queued = state_.queued(s);
    if (queued != (tag(s) == 1) || (tag(s) == 0 && g < kNever)) return false;
    if (state_.dist(s).raw != (penalty_.empty() ? 0 : penalty_[s])) return false;
    return wave_key_holds(s) && wave_way_holds(s) && wave_spread_holds(s);
  }
  bool wave_key_holds(NodeId s) {
    if (!state_.queued(s)) return true;
    const Raw k = own_cost(1, s), key = state_.k1(s).raw;
    if (k > sum(state_.g(s).raw, penalty_in_key(s)) || k >= kNever) return false;
    const NodeId start = state_.node(Scalar::start);
    const bool written = written_.contains(s);
    if (written && taken_ && !disturbed_ && *taken_ > static_cast<std::uint64_t>(key) + 1) return false;
    if (focused() && !on_map(start)) return true;
    const Raw f = sum(k, focused() ? h(start, s) : 0), right = sum(f, focused() ? state_.km().raw : 0);
    if (!written) return key <= right;
    return key == right && (!focused() || own_cost(2, s) == f);
  }
  bool wave_way_holds(NodeId s) {
    const Raw g = state_.g(s).raw;
    const NodeId back = state_.lp(s);
    if (s == state_.node(Scalar::goal)) return g == 0 && back == kNoNode;
    if (back == kNoNode) return g >= kNever;
    if (g >= kNever && tag(s) != 1) return false;
    if (!on_map(back) || back == s || step_squared(s, back) > 2) return false;
    if (tag(back) == 1) return true;
    const Raw way = is_move(s, back) ? step_between(world_, s, back) : kNever;
    return g == sum(way, sum(state_.g(back).raw, state_.dist(back).raw));
  }
  bool wave_spread_holds(NodeId s) {
    const Raw g = state_.g(s).raw;
    if (tag(s) != 2 || g >= kNever) return true;
    return std::all_of(successors_[s].begin(), successors_[s].end(), [&](const Move& move) {
      return tag(move.to) == 1 || state_.g(move.to).raw <= sum(move.cost, sum(g, state_.dist(s).raw));
    });
  }
  std::optional<NodeId> wave_plan_fault(PlanStatus status) {
    const NodeId goal = state_.node(Scalar::goal), start = state_.node(Scalar::start);
    if (!on_map(start) || !on_map(goal)) return std::nullopt;
    const bool free = world_.blocked[start] == 0 && world_.blocked[goal] == 0;
    const Raw promised = state_.g(start).raw;
    if (has_path(status) != (free && promised < kNever)) return start;
    const Raw end = sum(sum(promised, penalty_in_key(start)), focused() ? state_.km().raw : 0);
    for (NodeId n = 0; free && n < world_.blocked.size(); ++n)
      if (state_.queued(n) && state_.k1(n).raw < end) return n;
    for (NodeId s = start; has_path(status) && s != goal; s = state_.lp(s)) {
      const NodeId back = state_.lp(s);
      if (!is_move(s, back)) return s;
      const Raw way = sum(step_between(world_, s, back), state_.dist(back).raw);
      if (state_.g(s).raw != sum(way, state_.g(back).raw)) return s;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool any_angle() const { return view_.info.values.laws == "any-angle"; }

  bool any_angle_holds(NodeId s) {
    const NodeId rp = state_.rp(s);
    const Raw g = state_.g(s).raw;
    if (!spread_and_key_hold(s)) return false;
    if (s == state_.node(Scalar::start)) return g == 0 && state_.lp(s) == kNoNode;
    if (g >= kNever) return state_.lp(s) == kNoNode && !state_.queued(s);
    if (state_.lp(s) == kNoNode || rp == kNoNode) return false;
    const auto before = g_before_.find(s);
    if (before == g_before_.end() || before->second == g || !on_map(rp)) return true;
    const Raw down = segment(rp, s);
    const bool whole = down % kUnit == 0 && step_squared(rp, s) == (down / kUnit) * (down / kUnit);
    return g == sum(state_.g(rp).raw, down + (whole ? 0 : 1));
  }

  bool best_first_holds(NodeId s) {
    if (!spread_and_key_hold(s) || state_.dist(s).raw != penalty(s)) return false;
    const NodeId start = state_.node(Scalar::start), parent = state_.lp(s);
    const Raw g = state_.g(s).raw;
    if (s == start) return g == 0 && parent == kNoNode;
    if (g >= kNever) return parent == kNoNode && !state_.queued(s);
    if (!is_move(s, parent)) return false;
    const Raw through = sum(sum(state_.g(parent).raw, step_between(world_, s, parent)), penalty(s));
    return g == through || (g > through && state_.queued(parent));
  }

  bool spread_and_key_hold(NodeId s) {
    const NodeId goal = state_.node(Scalar::goal);
    const Raw g = state_.g(s).raw;
    const Cost weight{static_cast<std::int64_t>(state_.scalar(Scalar::weight))};
    if (state_.queued(s) && on_map(goal) && state_.k1(s) != f_({g}, {h(s, goal)}, weight)) return false;
    if (g < kNever && !state_.queued(s))
      for (const Move& move : successors_[s])
        if (state_.g(move.to).raw > sum(sum(g, move.cost), penalty(move.to)) &&
            !(view_.info.key.once && taken(move.to)))
          return false;
    return true;
  }

  [[nodiscard]] bool taken(NodeId s) const { return !state_.queued(s) && state_.g(s).raw < kNever; }

  /// As a best-first search, but for what it offers, and with parents a jump away.
  bool jump_holds(NodeId s) {
    const NodeId goal = state_.node(Scalar::goal), start = state_.node(Scalar::start);
    const Raw g = state_.g(s).raw;
    const NodeId parent = state_.lp(s);
    if (state_.queued(s) && on_map(goal) && state_.k1(s) != f_({g}, {h(s, goal)}, Cost{})) return false;
    if (s == start) return g == 0 && parent == kNoNode;
    if (g >= kNever) return parent == kNoNode && !state_.queued(s);
    const Raw way = on_map(parent) ? jump(s, parent) : kNever;
    if (way == kNever) return false;
    const Raw through = sum(state_.g(parent).raw, way);
    return g == through || (g > through && state_.queued(parent));
  }

  /// The cost of a straight way of moves from a to b, by trying all eight; kNever if there is none.
  [[nodiscard]] Raw jump(NodeId a, NodeId b) const {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        Place at = world_.place(a);
        Raw way = 0;
        while ((dx != 0 || dy != 0) && may_move(world_, rules_, at, {dx, dy, 0})) {
          at = {at[0] + dx, at[1] + dy, 0};
          way += step(std::abs(dx) + std::abs(dy));
          if (world_.index(at) == b) return way;
        }
      }
    return kNever;
  }

  [[nodiscard]] bool is_move(NodeId a, NodeId b) const {
    const auto leads_there = [b](const Move& move) { return move.to == b; };
    return std::any_of(successors_[a].begin(), successors_[a].end(), leads_there);
  }

  std::optional<NodeId> plan_fault(PlanStatus status) {
    if (view_.info.values.waves) return wave_plan_fault(status);
    const NodeId goal = state_.node(Scalar::goal), start = state_.node(Scalar::start);
    const bool lookahead = view_.info.values.lookahead();
    const NodeId end = view_.info.from_goal ? start : goal;
    if (!on_map(end)) return std::nullopt;
    const auto rule = static_cast<SightRule>(static_cast<int>(view_.settings.get("sight", 0)));
    const bool free =
        on_map(start) && on_map(goal) && world_.blocked[start] == 0 && world_.blocked[goal] == 0;
    const Raw promised = lookahead ? state_.rhs(end).raw : state_.g(end).raw;
    if (has_path(status) != (free && promised < kNever)) return end;
    if (!has_path(status)) return std::nullopt;
    for (NodeId s = end; any_angle() && s != start; s = state_.rp(s))
      if (!on_map(state_.rp(s)) || !in_sight(rule, state_.rp(s), s) || state_.g(state_.rp(s)) >= state_.g(s))
        return s;
    if (any_angle()) return std::nullopt;
    const NodeId other_end = view_.info.from_goal ? goal : start;
    Raw way = 0;
    for (NodeId s = end; s != other_end; s = state_.lp(s)) {
      const NodeId next = state_.lp(s);
      const bool leads =
          view_.info.values.laws == "jumps" ? on_map(next) && jump(s, next) != kNever : is_move(s, next);
      if (!leads || state_.g(next) >= state_.g(s)) return s;
      if (view_.info.sight) way += step_between(world_, s, next);
    }
    return view_.info.sight ? path_fault(way) : std::nullopt;
  }

  std::optional<NodeId> path_fault(Raw way) {
    const bool along_path = view_.settings.get("sight_checks", 0) != 0;
    const bool printed = view_.settings.get("remote_parents", 0) != 0 && !along_path;
    Raw length = 0;
    const auto sight = static_cast<SightRule>(static_cast<int>(view_.settings.get("sight", 0)));
    std::set<NodeId> passed;
    for (NodeId s = state_.node(Scalar::start); s != state_.node(Scalar::goal);) {
      if (!passed.insert(s).second) return s;
      const auto remote = seen_.find(s);
      const NodeId next = printed || along_path   ? state_.rp(s)
                          : remote != seen_.end() ? remote->second
                                                  : state_.lp(s);
      if (!on_map(next)) return s;
      if (!is_move(s, next) && !in_sight(sight, s, next)) return s;
      length += segment(s, next);
      s = next;
    }
    if (!printed && length > way) return state_.node(Scalar::start);
    return std::nullopt;
  }

  [[nodiscard]] bool in_sight(SightRule rule, NodeId a, NodeId b) const {
    return view_.radius > 0 ? sees_wide(world_, world_.blocked, a, b)
                            : sees(world_, world_.blocked, rules_.corners, rule, a, b);
  }
  /// The length of a straight segment, rounded down.
  [[nodiscard]] Raw segment(NodeId a, NodeId b) const { return root_floor(step_squared(a, b)); }
  [[nodiscard]] std::int64_t step_squared(NodeId a, NodeId b) const {
    const Place p = world_.place(a), q = world_.place(b);
    const std::int64_t x = p[0] - q[0], y = p[1] - q[1];
    return x * x + y * y;
  }

  LogView view_;
  MoveRules rules_;
  SearchState state_;
  KeyRule::F f_;
  World world_;
  std::vector<std::vector<Move>> successors_;
  std::vector<Raw> penalty_;
  std::vector<Raw> costs_;  // every g, as of the step that is looked at
  bool map_stale_ = false;
  std::set<NodeId> written_;
  std::optional<std::uint64_t> taken_;  // the queue value of what the step took from the list
  bool disturbed_ = false;              // the map or the start has changed since the step began
  std::map<NodeId, Raw> g_before_;      // the step, of vertices whose g it has written
  std::map<NodeId, NodeId> seen_;       // remote parents that the planner saw while it read out the path
};

}  // namespace

std::optional<Fault> first_fault(const LogView& view, std::span<const Event> events) {
  return Bench(view).run(events);
}

}  // namespace replan::oracle
