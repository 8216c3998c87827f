#include "core/debug/difference_search.hpp"

#include <utility>

#include "core/base/words.hpp"
#include "core/debug/event_words.hpp"
#include "core/plan/common_parameters.hpp"
#include "core/plan/planner.hpp"
#include "core/trace/expansions.hpp"

namespace replan {

/// What is compared, one after the other: an event, an expansion, a plan or a move.
struct ComparedItem {
  EventKind kind{};
  NodeId node = kNoNode;
  std::uint64_t value = 0;
  std::size_t position = 0;        ///< past the event that says what and where
  std::size_t value_position = 0;  ///< past the one that gives the value

  [[nodiscard]] Event event() const { return {.delta = value, .node = node, .kind = kind}; }
  [[nodiscard]] bool same_place(const ComparedItem& other) const {
    return kind == other.kind && node == other.node;
  }
  friend bool operator==(const ComparedItem& a, const ComparedItem& b) {
    return a.same_place(b) && a.value == b.value;
  }
};

namespace {

/// The kinds that both planners write. Lines are left out: pseudo-codes are numbered each in its own way.
KindSet shared_kinds(const PlannerInfo& a, const PlannerInfo& b) {
  using enum EventKind;
  KindSet kinds{known,     truth,   scalar,  pop,     plan_begin, plan_end, move,      sensed, surprise,
                collision, waiting, arrival, gave_up, new_goal,   put_down, forgotten, aim};
  for (const Field& field : a.values.fields)
    if (const Field* other = b.values.find(field.kind);
        other != nullptr && !is_own_field(field.kind) && field.shown && other->shown)
      kinds.add(field.kind);
  if (a.sight && b.sight)
    for (const EventKind kind : {sight, unchecked}) kinds.add(kind);
  return kinds;
}

}  // namespace

/// Reads one log and hands out what is compared.
class ComparedLog {
 public:
  ComparedLog(const LogView& view, Compare what, KindSet kinds)
      : log_(&view.log),
        frame_(view.lattice),
        info_(&view.info),
        along_path_(parameters::checks_along_path(view.settings)),
        what_(what),
        kinds_(kinds),
        state_(view.log.state_at(0)) {}

  [[nodiscard]] const PlannerInfo& info() const { return *info_; }
  [[nodiscard]] bool checks_along_path() const { return along_path_; }
  [[nodiscard]] bool at_end() const { return read_ == log_->size(); }
  [[nodiscard]] std::size_t position() const { return read_; }
  [[nodiscard]] const std::optional<ComparedItem>& item() const { return item_; }
  void drop() { item_.reset(); }

  /// Reads one event; item() is there when it completes one.
  void read() {
    const Event& event = log_->event(read_++);
    state_.apply(event);
    switch (what_) {
      case Compare::events:
        return read_event(event);
      case Compare::expansions:
        return read_expansion(event);
      case Compare::costs:
        if (event.kind == EventKind::plan_end)
          item_ = {event.kind, static_cast<NodeId>(event.delta), claimed(event), read_, read_};
        return;
      case Compare::moves:
        if (event.kind == EventKind::move) item_ = {event.kind, event.node, 0, read_, read_};
        return;
    }
  }
  /// The log has ended: what is half read is all there is.
  void finish() { item_ = std::exchange(expansion_, std::nullopt); }

  [[nodiscard]] std::string describe(const ComparedItem& item) const;
  /// What an expansion makes of the vertex.
  [[nodiscard]] std::string describe_value(const ComparedItem& item) const {
    return "gives " + node_text(frame_, item.node) +
           " g = " + cost_text({static_cast<std::int64_t>(item.value)});
  }

 private:
  void read_event(const Event& event) {
    set_up_ |= event.kind == EventKind::pop || event.kind == EventKind::plan_end;
    const bool lookahead_only =
        event.kind == EventKind::scalar && !kinds_.has(EventKind::rhs) &&
        (event.node == static_cast<NodeId>(Scalar::km) || event.node == static_cast<NodeId>(Scalar::last));
    if (set_up_ && kinds_.has(event.kind) && !lookahead_only)
      item_ = {event.kind, event.node, event.delta, read_, read_};
  }

  // The g that a vertex gets is written after it was taken, if at all; the next step says that it stays.
  void read_expansion(const Event& event) {
    if (counter_.take(event)) {
      const auto value = static_cast<std::uint64_t>(state_.g(event.node).raw);
      expansion_ = {event.kind, event.node, value, read_, read_};
    } else if (event.kind == EventKind::pop || event.kind == EventKind::plan_end) {
      item_ = std::exchange(expansion_, std::nullopt);
    } else if (event.kind == EventKind::g && expansion_ && event.node == expansion_->node) {
      expansion_->value = static_cast<std::uint64_t>(state_.g(event.node).raw);
      expansion_->value_position = read_;
    }
  }

  [[nodiscard]] std::uint64_t claimed(const Event& plan_end) const {
    if (!has_path(static_cast<PlanStatus>(plan_end.delta))) return 0;
    return static_cast<std::uint64_t>(claimed_cost(info_->values, state_).raw);
  }
  const Timeline* log_;
  Box frame_;
  const PlannerInfo* info_;
  bool along_path_;
  Compare what_;
  KindSet kinds_;
  SearchState state_;
  std::size_t read_ = 0;
  bool set_up_ = false;  // the first vertex was taken
  ExpansionCounter counter_;
  std::optional<ComparedItem> expansion_, item_;
};

std::string ComparedLog::describe(const ComparedItem& item) const {
  switch (what_) {
    case Compare::events:
      return event_text(frame_, info_->values, item.event(), state_.value(item.kind, item.node));
    case Compare::expansions:
      return "takes " + node_text(frame_, item.node);
    case Compare::costs:
      if (!has_path(static_cast<PlanStatus>(item.node))) return "finds no path";
      return "pays " + cost_text({static_cast<std::int64_t>(item.value)});
    case Compare::moves:
      return "goes to " + node_text(frame_, item.node);
  }
  return {};
}

struct DifferenceSearch::State {
  Compare what;
  std::array<ComparedLog, 2> readers;
  std::array<bool, 2> done{};
  std::size_t count = 0;  // items that were alike
  std::optional<Difference> difference;

  State(const LogView& a, const LogView& b, Compare which)
      : what(which),
        readers{ComparedLog(a, which, shared_kinds(a.info, b.info)),
                ComparedLog(b, which, shared_kinds(a.info, b.info))} {}

  /// Reads side `i` on to its next item. False if it has to wait for more of the log, or `events` are used
  /// up.
  bool read_on(std::size_t i, std::size_t& events, bool ended) {
    while (!readers[i].item() && !done[i]) {
      if (readers[i].at_end()) {
        if (!ended) return false;
        readers[i].finish();
        done[i] = true;
      } else {
        if (events == 0) return false;
        readers[i].read();
        --events;
      }
    }
    return true;
  }

  /// Both sides have their next item, or have come to their end.
  Outcome compare() {
    const auto &a = readers[0].item(), &b = readers[1].item();
    if (!a && !b) return Outcome::alike;
    if (a && b && *a == *b) {
      ++count;
      for (ComparedLog& reader : readers) reader.drop();
      return Outcome::more;
    }
    const bool same_place = a && b && a->same_place(*b);
    difference = Difference{.what = what, .words = sentence(same_place)};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& item = readers[i].item();
      difference->positions[i] = !item        ? readers[i].position()
                                 : same_place ? item->value_position
                                              : item->position;
      if (item && (what == Compare::expansions || what == Compare::moves)) difference->nodes[i] = item->node;
    }
    return Outcome::differ;
  }

  [[nodiscard]] std::string name(std::size_t i) const {
    const std::string own(readers[i].info().name);
    if (readers[0].info().sight && readers[1].info().sight &&
        readers[0].checks_along_path() != readers[1].checks_along_path())
      return own + (readers[i].checks_along_path() ? " (sight checked along the path)"
                                                   : " (sight checked in the search)");
    return readers[0].info().id == readers[1].info().id ? own + (i == 0 ? " (first)" : " (second)") : own;
  }
  [[nodiscard]] std::string sentence(bool same_place) const {
    std::string text;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& item = readers[i].item();
      text += (i == 0 ? number() + ": " : "; ") + name(i) + (what == Compare::events && item ? ": " : " ");
      if (!item)
        text += "has come to its end";
      else if (same_place && what == Compare::expansions)
        text += readers[i].describe_value(*item);
      else
        text += readers[i].describe(*item);
    }
    return text;
  }
  /// "expansion 214"
  [[nodiscard]] std::string number() const {
    switch (what) {
      case Compare::events:
        return "event " + std::to_string(count + 1) + " of the search";
      case Compare::expansions:
        return "expansion " + std::to_string(count + 1);
      case Compare::costs:
        return count == 0 ? "first plan" : "replan " + std::to_string(count);
      case Compare::moves:
        return "move " + std::to_string(count + 1);
    }
    return {};
  }
};

DifferenceSearch::DifferenceSearch(const LogView& a, const LogView& b, Compare what)
    : state_(std::make_unique<State>(a, b, what)) {}
DifferenceSearch::~DifferenceSearch() = default;
DifferenceSearch::DifferenceSearch(DifferenceSearch&&) noexcept = default;
DifferenceSearch& DifferenceSearch::operator=(DifferenceSearch&&) noexcept = default;

DifferenceSearch::Outcome DifferenceSearch::advance(std::size_t events, std::array<bool, 2> ended) {
  State& state = *state_;
  if (state.difference) return Outcome::differ;
  for (;;) {
    const bool first = state.read_on(0, events, ended[0]);
    const bool second = state.read_on(1, events, ended[1]);
    if (!first || !second) return events == 0 ? Outcome::more : Outcome::waits;
    if (const Outcome outcome = state.compare(); outcome != Outcome::more) return outcome;
  }
}

const std::optional<Difference>& DifferenceSearch::difference() const {
  return state_->difference;
}

std::string DifferenceSearch::alike() const {
  constexpr const char* kItems[] = {"event", "expansion", "plan", "move"};
  return counted(state_->count, kItems[static_cast<std::size_t>(state_->what)]);
}

std::optional<Difference> first_difference(const LogView& a, const LogView& b, Compare what) {
  DifferenceSearch search(a, b, what);
  while (search.advance(std::size_t{1} << 20, {true, true}) == DifferenceSearch::Outcome::more) {
  }
  return search.difference();
}

}  // namespace replan
