#include "ui/shell/arrival.hpp"

#include <algorithm>
#include <utility>

#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

/// What comparing may take of a frame.
constexpr double kCompareMs = 8;

constexpr const char* kOtherText = "the text was made by another version of the program, or changed";
constexpr const char* kOtherRun =
    "this version of Replan plans this world otherwise than the one that the link is from";

}  // namespace

void Arrival::begin(const Session& session, const Moment& moment) {
  going_ = Going{.to = moment, .log = session.run().log_id()};
}

double Arrival::share(const Session& session) const {
  const auto come = static_cast<double>(session.run().timeline().size());
  return going_->to.event == 0 ? 1 : std::min(1.0, come / static_cast<double>(going_->to.event));
}

// The first plan is made to its end anyway; beyond it the run goes on as far as it takes.
std::optional<Arrival::Outcome> Arrival::go_on(Session& session) {
  if (!going_) return std::nullopt;
  const Run& run = session.run();
  const std::size_t size = run.timeline().size(), event = going_->to.event;
  if (run.log_id() != going_->log) {
    going_.reset();  // edited or closed meanwhile
    return std::nullopt;
  }
  if (going_->there) return compare(session);
  if (size > event || (size == event && !run.busy())) return arrive(session);
  if (run.busy()) return std::nullopt;
  if (going_->sent) return give_up(session);
  going_->sent = true;
  static_cast<void>(session.apply(RunTo{event}));
  return std::nullopt;
}

std::optional<Arrival::Outcome> Arrival::arrive(Session& session) {
  if (const Result<void> gone = session.apply(Seek{going_->to.event}); !gone) {
    going_.reset();
    return Outcome{gone.error(), true};
  }
  going_->there = true;
  if (going_->to.state) going_->state.emplace(session.run().timeline().state());
  if (going_->to.log) going_->events.emplace(going_->to.event);
  return compare(session);
}

/// Whether it is the moment that was meant shows once its state or its log is read, which may take more than this frame.
std::optional<Arrival::Outcome> Arrival::compare(const Session& session) {
  if (going_->state && !going_->state->advance(Deadline(kCompareMs))) return std::nullopt;
  if (going_->events && !going_->events->advance(session.run().timeline(), Deadline(kCompareMs)))
    return std::nullopt;
  const Going done = *std::exchange(going_, std::nullopt);
  const bool same = (!done.state || done.state->value() == done.to.state) &&
                    (!done.events || done.events->short_value() == done.to.log);
  const std::string at = "At event " + grouped(done.to.event);
  if (done.to.from == Moment::From::text)
    return Outcome{at + (same ? ", as it was copied"
                              : std::string(", but the state differs from the copied one: ") + kOtherText),
                   !same};
  return Outcome{at + (same ? (done.to.log ? ", as in the link" : "")
                            : std::string(", but ") + kOtherRun + ": the moment may be another"),
                 !same};
}

Arrival::Outcome Arrival::give_up(const Session& session) {
  const Going going = *std::exchange(going_, std::nullopt);
  const Run& run = session.run();
  const std::string ends = grouped(run.timeline().size()) + " events", event = grouped(going.to.event);
  if (const std::string failure = run.failure(); !failure.empty())
    return {"The run could not go on to event " + event + ": " + failure, true};
  if (!run.over())
    return {"Stopped after " + ends + ", before event " + event + "; a step or Play goes on from here",
            false};
  if (going.to.from == Moment::From::text)
    return {"The run ends after " + ends + ", before the copied event " + event + ": " + kOtherText, true};
  return {"The run ends after " + ends + ", before event " + event + " of the link: " + kOtherRun, true};
}

}  // namespace replan::ui
