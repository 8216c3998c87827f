#include "core/export/posthoc.hpp"

#include "core/base/words.hpp"
#include "core/export/trace_text.hpp"

namespace replan {
namespace {

/// No step has named the cell yet.
constexpr NodeId kUnnamed = kNoNode - 1;

/// JSON is YAML too, so both kinds of file have the same views. Cells stay painted and are painted over: to
/// clear them one by one takes the visualiser time that grows with the square of their number.
constexpr std::string_view kSquare = R"(
    "square": [
      { "$": "rect", "x": "${{ $.x }}", "y": "${{ $.y }}", "width": 1, "height": 1, "fill": "${{ $.paint }}",
        "alpha": 0.75 }
    ],)";
constexpr std::string_view kValuesOpen = R"(
    "vertex": [
      { "$": "square", "paint": "${{ $.paint }}",
        "$info": { )";
constexpr std::string_view kMain = R"( } }
    ],
    "main": [
      { "$": "vertex", "$if": "${{ !!color[$.type] && $.f !== undefined }}", "paint": "${{ color[$.type] }}" },
      { "$": "square", "$if": "${{ !!color[$.type] && $.f === undefined }}", "paint": "${{ color[$.type] }}" },
      { "$": "square", "$if": "${{ $.type == 'block' }}", "paint": "${{ theme.foreground }}" },
      { "$": "square", "$if": "${{ $.type == 'unblock' }}", "paint": "${{ theme.background }}" },
      { "$": "path", "$if": "${{ $.type == 'plan' && $.points.length > 1 }}", "clear": "plan",
        "points": "${{ $.points }}", "line-width": 0.2, "fill": "${{ color.end }}" },
      { "$": "circle", "$if": "${{ $.type == 'move' }}", "clear": "move", "x": "${{ $.x + 0.5 }}",
        "y": "${{ $.y + 0.5 }}", "radius": 0.35, "fill": "${{ color.destination }}" }
    ]
  })";
constexpr std::string_view kPivot = R"({ "x": "${{ $.x + 0.5 }}", "y": "${{ $.y + 0.5 }}", "scale": 1 })";

std::string info_keys(bool lookahead) {
  std::string keys;
  for (const std::string_view key : {"g", "rhs", "k1", "k2", "km", "f", "pass"}) {
    const bool two_values = key == "rhs" || key == "k1" || key == "k2" || key == "km";
    if (two_values && !lookahead) continue;
    if (key == "f" && lookahead) continue;  // the same as k1
    keys += (keys.empty() ? "\"" : ", \"") + std::string(key) + "\": \"${{ $." + std::string(key) + " }}\"";
  }
  return keys;
}

}  // namespace

/// One event of the file: `- { type: move, id: robot, x: 4, y: 5 }` or `{"type":"move",...}`.
class PosthocTrace::Step {
 public:
  Step(PosthocTrace& trace, std::string& out, std::string_view type) : out_(out), yaml_(trace.yaml_) {
    if (yaml_)
      out_ += "- { type: ";
    else
      out_ += trace.first_ ? "\n{\"type\":\"" : ",\n{\"type\":\"";
    out_ += type;
    if (!yaml_) out_ += '"';
    trace.first_ = false;
  }
  ~Step() { out_ += yaml_ ? " }\n" : "}"; }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  void word(std::string_view key, std::string_view value) {
    name(key);
    if (!yaml_) out_ += '"';
    out_ += value;
    if (!yaml_) out_ += '"';
  }
  void null(std::string_view key) {
    name(key);
    out_ += "null";
  }
  void whole(std::string_view key, std::integral auto value) {
    name(key);
    append_whole(out_, value);
  }
  void cost(std::string_view key, Cost value) {
    name(key);
    if (value.is_infinite())
      out_ += yaml_ ? ".inf" : "null";
    else
      append_cost(out_, value);
  }
  void at(Cell cell) {
    whole("x", cell.x);
    whole("y", cell.y);
  }
  void points(const Path& path) {
    name("points");
    out_ += '[';
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (i > 0) out_ += yaml_ ? ", " : ",";
      out_ += yaml_ ? "{ x: " : "{\"x\":";
      append_real(out_, path.point(i).x);
      out_ += yaml_ ? ", y: " : ",\"y\":";
      append_real(out_, path.point(i).y);
      out_ += yaml_ ? " }" : "}";
    }
    out_ += ']';
  }

 private:
  void name(std::string_view key) {
    out_ += yaml_ ? ", " : ",\"";
    out_ += key;
    out_ += yaml_ ? ": " : "\":";
  }

  std::string& out_;
  bool yaml_;
};

namespace {

std::string cell_id(Cell at) {
  std::string id = "c";
  append_whole(id, at.x);
  id += '_';
  append_whole(id, at.y);
  return id;
}

}  // namespace

PosthocSize posthoc_size(const Timeline& log) {
  constexpr std::size_t kCounted = std::size_t{1} << 18, kSample = 4096;
  constexpr std::size_t kBytesPerStep = 165;
  constexpr KindSet kSteps{EventKind::queue, EventKind::visit, EventKind::known, EventKind::move,
                           EventKind::plan_end};
  const std::size_t size = log.size();
  const std::size_t stride = size <= kCounted ? kSample : size / (kCounted / kSample);
  std::size_t seen = 0, steps = 0;
  for (std::size_t from = 0; from < size; from += stride)
    for (const Event& event : log.peek(from, std::min(size, from + kSample))) {
      ++seen;
      steps += kSteps.has(event.kind);
      if (event.kind == EventKind::pop && steps > 0)
        --steps;  // the removal that follows is no step of its own
    }
  if (seen > 0)
    steps = static_cast<std::size_t>(static_cast<double>(steps) * static_cast<double>(size) /
                                     static_cast<double>(seen));
  return {steps, steps * kBytesPerStep};
}

PosthocTrace::PosthocTrace(const TraceRun& run, bool yaml)
    : run_(run),
      yaml_(yaml),
      lookahead_(run.view.info.values.lookahead()),
      parents_(run.view.lattice.node_count(), kUnnamed) {}

void PosthocTrace::head(std::string& out, std::size_t) {
  out += yaml_ ? "version: \"1.4.0\"\nviews: {" : "{\n  \"version\": \"1.4.0\",\n  \"views\": {";
  ((((out += kSquare) += kValuesOpen) += info_keys(lookahead_)) += kMain);
  out += yaml_ ? "\npivot: " : ",\n  \"pivot\": ";
  out += kPivot;
  out += yaml_ ? "\nevents:\n" : ",\n  \"events\": [";
}

void PosthocTrace::tail(std::string& out, const SearchState& state) {
  if (visited_ != kNoNode) settle(out, state, state.g(visited_));
  if (yaml_ && first_) out += "[]\n";
  if (!yaml_) out += "\n]}\n";
}

void PosthocTrace::event(std::string& out, std::size_t index, const Event& event, const SearchState& state) {
  if (visited_ != kNoNode) {
    const bool its_g = event.kind == EventKind::g && event.node == visited_;
    const std::uint64_t after = state.value(EventKind::g, visited_) ^ (its_g ? event.delta : 0);
    settle(out, state, {static_cast<std::int64_t>(after)});
  }
  if (expansions_.take(event)) return visit(event, state);
  if (event.kind == EventKind::queue) return queue(out, event, state);
  if (event.kind == EventKind::known)
    return place(out, state.known_blocked(event.node) ? "unblock" : "block", event.node);
  if (!event.changes_value()) happening(out, index, event, state);
}

void PosthocTrace::queue(std::string& out, const Event& event, const SearchState& state) {
  const std::uint64_t before = state.value(EventKind::queue, event.node), after = before ^ event.delta;
  const Cost key{static_cast<std::int64_t>(after == 0 ? before : after) - 1};
  if (leaving_ && event.node == popped_ && after == 0) {
    leaving_ = false;
    popped_key_ = key;
    return;
  }
  const bool goes_back = event.node == popped_ && before == 0;  // visit() forgets what was popped
  if (goes_back) popped_ = kNoNode;
  cell(out, after == 0 || goes_back ? "closing" : "generating", event.node, state,
       {state.g(event.node), state.rhs(event.node), key, state.km()});
}

void PosthocTrace::visit(const Event& event, const SearchState& state) {
  visited_ = event.node;
  visited_as_ = lookahead_ && state.g(event.node) < state.rhs(event.node) ? "updating" : "expanding";
  popped_ = kNoNode;
}

void PosthocTrace::settle(std::string& out, const SearchState& state, Cost g) {
  const NodeId node = visited_;
  visited_ = kNoNode;
  cell(out, visited_as_, node, state, {g, state.rhs(node), popped_key_, state.km()});
}

void PosthocTrace::happening(std::string& out, std::size_t index, const Event& event,
                             const SearchState& state) {
  switch (event.kind) {
    case EventKind::plan_begin:
      pass_ = event.delta + 1;
      if (event.delta != 0) return;
      place(out, "source", run_.view.lattice.node(run_.start));
      place(out, "destination", run_.view.lattice.node(run_.goal));
      return robot(out, event.node);
    case EventKind::pop:
      popped_ = event.node;
      leaving_ = true;
      return;
    case EventKind::plan_end:
      return plan(out, run_.path_at(index));
    case EventKind::new_goal:
    case EventKind::aim:
      return place(out, "destination", event.node);
    case EventKind::move:
    case EventKind::put_down:
      return robot(out, event.node);
    case EventKind::arrival:
      return place(out, "end", event.node);
    case EventKind::epoch:
      return close_all(out, state);
    default:
      return;
  }
}

/// The search is forgotten, and with it all that was in its open list.
void PosthocTrace::close_all(std::string& out, const SearchState& state) {
  for (NodeId node = 0; node < state.node_count(); ++node)
    if (!state.touched(EventKind::queue, node))
      node += static_cast<NodeId>(SearchState::kPage - 1 - node % SearchState::kPage);
    else if (state.queued(node))
      cell(out, "closing", node, state, {state.g(node), state.rhs(node), state.k1(node), state.km()});
}

/// A step about a cell that says nothing of the search.
void PosthocTrace::place(std::string& out, std::string_view type, NodeId node) {
  const Cell at = run_.view.lattice.position(node);
  Step step(*this, out, type);
  step.word("id", cell_id(at));
  step.at(at);
  step.whole("pass", pass_);
  if (parents_[node] == kUnnamed) parents_[node] = kNoNode;
}

void PosthocTrace::robot(std::string& out, NodeId node) {
  Step step(*this, out, "move");
  step.word("id", "robot");
  step.at(run_.view.lattice.position(node));
  step.whole("pass", pass_);
}

void PosthocTrace::plan(std::string& out, const Path& path) {
  Step step(*this, out, "plan");
  step.word("id", "plan");
  step.whole("pass", pass_);
  step.points(path);
}

void PosthocTrace::cell(std::string& out, std::string_view type, NodeId node, const SearchState& state,
                        const Values& values) {
  const Cell at = run_.view.lattice.position(node);
  Step step(*this, out, type);
  step.word("id", cell_id(at));
  parent(step, node, state);
  step.at(at);
  step.cost("f", values.k1);
  step.cost("g", values.g);
  if (lookahead_) {
    step.cost("rhs", values.rhs);
    step.cost("k1", values.k1);
    step.cost("k2", std::min(values.g, values.rhs));
    step.cost("km", values.km);
  }
  step.whole("pass", pass_);
}

/// A parent that the visualiser can follow: another cell, named before, that does not lead back here. Where
/// there is none and the cell has had one, `none`: null would not forget it.
void PosthocTrace::parent(Step& step, NodeId node, const SearchState& state) {
  const NodeId remote = run_.view.info.sight ? state.rp(node) : kNoNode;
  const NodeId to = remote != kNoNode ? remote : state.lp(node);
  NodeId& written = parents_[node];
  if (to != kNoNode && to != node && parents_[to] != kUnnamed && !leads_to(to, node)) {
    step.word("pId", cell_id(run_.view.lattice.position(to)));
    written = to;
    return;
  }
  if (written == kUnnamed || written == kNoNode)
    step.null("pId");
  else
    step.word("pId", "none");
  // A cell that was cut off stays so: null after `none` changes nothing.
  written = kNoNode;
}

bool PosthocTrace::leads_to(NodeId from, NodeId node) const {
  while (from < kUnnamed && from != node) from = parents_[from];
  return from == node;
}

}  // namespace replan
