#include "core/debug/law_checker.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/debug/law_book.hpp"

namespace replan {
namespace {

/// The pseudo-code line under which a planner reads out its path: line 6 of Algorithm 1.
constexpr std::uint8_t kReadsPath = 106;

}  // namespace

/// The values of a run and the laws that they are held against, whatever its dimension.
class LawKeeper {
 public:
  virtual ~LawKeeper() = default;
  LawKeeper() = default;
  LawKeeper(const LawKeeper&) = delete;
  LawKeeper& operator=(const LawKeeper&) = delete;

  virtual void apply(const Event& event) = 0;
  /// Holds what the step touched against the laws.
  virtual void step() = 0;
  virtual void plan(PlanStatus status, std::span<const Hop> hops) = 0;
  virtual void look(NodeId node) = 0;
  [[nodiscard]] virtual std::vector<Finding> take() = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

template <int D>
class LawKeeperOf final : public LawKeeper {
 public:
  LawKeeperOf(const LogView& view, std::size_t position)
      : values_(view, position), laws_(make_law_book(view, values_)) {}

  void apply(const Event& event) override { values_.apply(event); }
  void step() override {
    values_.finish_step();
    laws_->step();
    values_.settle();
  }
  void plan(PlanStatus status, std::span<const Hop> hops) override { laws_->plan(status, hops); }
  void look(NodeId node) override { laws_->look(node); }
  std::vector<Finding> take() override { return laws_->take(); }
  [[nodiscard]] std::size_t bytes() const override { return values_.bytes(); }

 private:
  LawValues<D> values_;
  std::unique_ptr<LawBook<D>> laws_;
};

static std::unique_ptr<LawKeeper> make_law_keeper(const LogView& view, std::size_t position) {
  return with_dimensions(view.lattice, [&](auto d) -> std::unique_ptr<LawKeeper> {
    return std::make_unique<LawKeeperOf<d()>>(view, position);
  });
}

struct LawChecker::State {
  const Timeline* log;
  const PlannerInfo* info;
  Settings settings;
  double radius;
  Box frame;
  std::unique_ptr<LawKeeper> laws;
  std::vector<Hop> hops;  // of the path that is being read out
  std::size_t read = 0;
  std::vector<Breach> breaches;
  std::size_t count = 0;

  explicit State(const LogView& view)
      : log(&view.log), info(&view.info), settings(view.settings), radius(view.radius), frame(view.lattice) {
    begin_at(0);
  }

  void begin_at(std::size_t position) {
    laws = make_law_keeper({*log, frame, *info, settings, radius}, position);
    hops.clear();
    read = position;
  }

  void take(const Event& event) {
    const bool stands = event.kind == EventKind::plan_end;
    if (stands || event.kind == EventKind::pop) {
      laws->step();
      keep(read);
    }
    if (event.kind == EventKind::sight && event.line == kReadsPath && event.delta >> 32 != 0)
      hops.push_back({event.node, static_cast<NodeId>(event.delta)});
    laws->apply(event);
    ++read;
    if (!stands) return;
    laws->plan(static_cast<PlanStatus>(event.delta), hops);
    hops.clear();
    keep(read);
  }

  void keep(std::size_t position) {
    for (Finding& finding : laws->take()) {
      ++count;
      if (breaches.size() < kMostKept)
        breaches.push_back({position, finding.node, finding.law, std::move(finding.words)});
    }
  }
};

LawChecker::LawChecker(const LogView& view) : state_(std::make_unique<State>(view)) {}
LawChecker::~LawChecker() = default;
LawChecker::LawChecker(LawChecker&&) noexcept = default;
LawChecker& LawChecker::operator=(LawChecker&&) noexcept = default;

bool LawChecker::advance(std::size_t events) {
  State& state = *state_;
  const std::size_t end = state.log->size();
  for (; events > 0 && state.read < end; --events) state.take(state.log->event(state.read));
  return state.read < end;
}

void LawChecker::rewind(std::size_t position) {
  State& state = *state_;
  if (position >= state.read) return;
  // Of those that were only counted nobody knows where they were.
  const bool all_known = state.count == state.breaches.size();
  state.begin_at(all_known ? position : 0);
  std::erase_if(state.breaches, [&](const Breach& breach) { return breach.position > state.read; });
  state.count = state.breaches.size();
  // What is still broken there is known already.
  for (const Breach& breach : state.breaches) state.laws->look(breach.node);
  (void)state.laws->take();
}

std::size_t LawChecker::checked() const {
  return state_->read;
}
std::span<const Breach> LawChecker::breaches() const {
  return state_->breaches;
}
std::size_t LawChecker::breach_count() const {
  return state_->count;
}
std::size_t LawChecker::bytes() const {
  return state_->laws->bytes();
}

}  // namespace replan
