#include "core/session/film_plan.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/real_text.hpp"
#include "core/base/words.hpp"
#include "core/session/player.hpp"
#include "core/session/stepping.hpp"

namespace replan {
namespace {

constexpr double kSearchSeconds = 2, kEndSeconds = 1;
constexpr double kLongestWait = 1;  ///< a robot waits at once for what is scripted for much later

template <class T>
std::optional<T> whole(std::string_view text) {
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool takes_time(EventKind kind) {
  return kind == EventKind::move || kind == EventKind::waiting || kind == EventKind::turn;
}

/// The moment after a step that was told of at `event`.
auto decision_after(const Run& run, std::size_t event) {
  return std::upper_bound(run.decisions().begin(), run.decisions().end(), event,
                          [](std::size_t at, const Decision& decision) { return at < decision.event; });
}

/// Where a milestone's doing is done. A move is told by an event and carried out by those that follow it.
std::size_t position_after(const Run& run, const Milestone& milestone) {
  if (!takes_time(milestone.kind)) return milestone.event + 1;
  const auto after = decision_after(run, milestone.event);
  return after != run.decisions().end() ? after->event : milestone.event + 1;
}

/// Collects the frames between two positions of a run.
class Cutter {
 public:
  Cutter(const Run& run, const FilmOptions& options, std::size_t from, std::size_t to)
      : run_(run), options_(options), from_(from), to_(to) {}

  std::vector<FilmFrame> cut() {
    add(from_, 1);
    if (options_.speed.kind == FilmSpeed::Kind::events)
      every_so_many_events();
    else
      along_markers();
    add(to_, frames_in(kEndSeconds));
    return std::move(frames_);
  }
  [[nodiscard]] bool too_long() const { return frames_.size() > kMostFrames; }

 private:
  [[nodiscard]] std::size_t frames_in(double seconds) const {
    return static_cast<std::size_t>(std::max(1.0, std::round(seconds * options_.fps)));
  }
  void add(std::size_t position, std::size_t times, double travel = 1) {
    if (position < from_ || position > to_ || too_long()) return;
    frames_.insert(frames_.end(), std::min(times, kMostFrames + 1), {position, travel});
  }
  /// What a viewer has to read stands still for a moment.
  static bool is_read(EventKind kind) { return kind != EventKind::plan_begin && !takes_time(kind); }

  /// Where something stands still that a milestone tells of: behind it, or, of a repair, before its first expansion.
  [[nodiscard]] std::optional<std::size_t> still_position(const Milestone& milestone) const {
    if (is_read(milestone.kind)) return milestone.event + 1;
    if (milestone.kind != EventKind::plan_begin) return std::nullopt;
    const std::size_t first = next_stop(run_, milestone.event, StepUnit::expansion);
    return is_before_repair(run_, first) ? std::optional(first) : std::nullopt;
  }

  void every_so_many_events() {
    const auto step = static_cast<std::size_t>(options_.speed.number);
    std::vector<std::size_t> still;
    for (const Milestone& milestone : run_.milestones())
      if (const auto position = still_position(milestone)) still.push_back(*position);
    auto next = still.begin();
    for (std::size_t at = from_; at < to_ && !too_long(); at += std::min(step, to_ - at)) {
      for (; next != still.end() && *next <= at; ++next) add(*next, frames_in(options_.hold));
      if (at > from_) add(at, 1);
    }
    for (; next != still.end(); ++next) add(*next, frames_in(options_.hold));
  }

  void along_markers() {
    std::size_t begun = 0;
    bool searching = false;
    for (const Milestone& milestone : run_.milestones()) {
      if (milestone.event >= to_ || too_long()) break;
      if (milestone.kind == EventKind::plan_begin) begun = milestone.event;
      if (milestone.kind == EventKind::plan_end) search(begun, milestone.event);
      if (milestone.kind == EventKind::plan_begin || milestone.kind == EventKind::plan_end)
        searching = milestone.kind == EventKind::plan_begin;
      if (takes_time(milestone.kind))
        step(milestone);
      else if (is_read(milestone.kind))
        add(milestone.event + 1, frames_in(options_.hold));
    }
    if (searching) search(begun, to_);  // the film ends within it
  }

  /// The expansions of a search: each, or thinned to about two seconds, or none.
  void search(std::size_t begin, std::size_t end) {
    if (options_.speed.kind == FilmSpeed::Kind::move || end <= from_) return;
    std::vector<std::size_t> stops;
    const BitRow& all = run_.stops().iterations();
    for (std::size_t p = all.next(std::max(begin, from_)); p < end; p = all.next(p + 1))
      if (run_.timeline().event(p).kind == EventKind::pop) stops.push_back(p);
    const std::size_t most =
        options_.speed.kind == FilmSpeed::Kind::expansion ? stops.size() : frames_in(kSearchSeconds);
    const std::size_t every = most == 0 ? 1 : std::max<std::size_t>(1, (stops.size() + most - 1) / most);
    for (std::size_t i = 0; i < stops.size() && !too_long(); i += every)
      add(stops[i], is_before_repair(run_, stops[i]) ? frames_in(options_.hold) : 1);
  }

  /// A move of the robot, or a wait.
  void step(const Milestone& milestone) {
    const std::size_t after = position_after(run_, milestone);
    const double seconds = seconds_of(milestone);
    if (seconds == 0) {
      add(after, 1);
      return;
    }
    // Whole frames, so that after each second of the drive a second of the film is over.
    const double before = driven_;
    driven_ += seconds;
    const auto frames_until = [&](double time) {
      return static_cast<std::size_t>(std::floor(time * options_.fps + 1e-9));
    };
    const std::size_t count = frames_until(driven_) - frames_until(before);
    for (std::size_t i = 1; i <= count && !too_long(); ++i)
      add(after, 1, static_cast<double>(i) / static_cast<double>(count));
  }

  /// How long the film shows a step of the robot; 0: for one frame.
  [[nodiscard]] double seconds_of(const Milestone& milestone) const {
    if (options_.speed.kind == FilmSpeed::Kind::moves_per_second) return 1 / options_.speed.number;
    const bool timed = options_.speed.kind == FilmSpeed::Kind::automatic && is_smooth(run_);
    const auto after = decision_after(run_, milestone.event);
    const Decision* before = run_.decision_at(milestone.event);
    if (!timed || after == run_.decisions().end() || before == nullptr) return 0;
    const double seconds = static_cast<double>(after->time - before->time) / static_cast<double>(kSecond);
    return milestone.kind == EventKind::waiting ? std::min(seconds, kLongestWait) : seconds;
  }

  const Run& run_;
  const FilmOptions& options_;
  std::size_t from_, to_;
  double driven_ = 0;  // seconds of the drive shown so far
  std::vector<FilmFrame> frames_;
};

/// The N of "replan:N", if the moment is of that kind.
std::optional<std::string_view> number_of(std::string_view moment, std::string_view kind) {
  if (!moment.starts_with(kind) || moment.size() <= kind.size() || moment[kind.size()] != ':')
    return std::nullopt;
  return moment.substr(kind.size() + 1);
}

/// The position after the n-th milestone of a kind, counted from 1; `skipped` of them before do not count.
Result<std::size_t> nth(const Run& run, EventKind kind, std::size_t skipped, std::string_view number,
                        const char* what) {
  const auto n = whole<std::size_t>(number);
  if (!n || *n == 0)
    return Error{"'" + std::string(number) + "' is no number of a " + what + "; they count from 1"};
  std::size_t seen = 0;
  for (const Milestone& milestone : run.milestones())
    if (milestone.kind == kind && ++seen > skipped && seen - skipped == *n)
      return position_after(run, milestone);
  return Error{"the run has only " + counted(seen - std::min(seen, skipped), what) + ", so there is no " +
               what + " " + std::string(number)};
}

}  // namespace

Result<FilmSpeed> parse_film_speed(std::string_view text) {
  using Kind = FilmSpeed::Kind;
  if (text == "auto") return FilmSpeed{};
  if (text == "expansion") return FilmSpeed{Kind::expansion, 0};
  if (text == "move") return FilmSpeed{Kind::move, 0};
  if (text.ends_with("/s")) {
    const auto moves = real_from(text.substr(0, text.size() - 2));
    if (moves && *moves >= 0.1 && *moves <= 1000) return FilmSpeed{Kind::moves_per_second, *moves};
  } else if (const auto events = whole<std::uint32_t>(text); events && *events > 0) {
    return FilmSpeed{Kind::events, static_cast<double>(*events)};
  }
  return Error{"the speed cannot be '" + std::string(text) +
               "': give auto, expansion, move, a number of events per frame such as 50, or robot moves per "
               "second, from 0.1/s to 1000/s"};
}

Result<std::size_t> moment_position(const Run& run, std::string_view moment) {
  const std::size_t size = run.timeline().size();
  if (moment == "start") return std::size_t{0};
  if (moment == "end") return size;
  if (moment == "plan") return nth(run, EventKind::plan_end, 0, "1", "plan");
  if (const auto n = number_of(moment, "replan")) return nth(run, EventKind::plan_end, 1, *n, "replan");
  if (const auto n = number_of(moment, "move")) return nth(run, EventKind::move, 0, *n, "move");
  const auto event = whole<std::size_t>(moment);
  if (!event)
    return Error{"there is no moment '" + std::string(moment) +
                 "': give a number of events, start, plan, replan:N, move:N or end"};
  if (*event > size)
    return Error{"event " + std::to_string(*event) + " lies beyond the run's end; it has " +
                 counted(size, "event")};
  return *event;
}

Result<std::vector<FilmFrame>> plan_film(const Run& run, const FilmOptions& options) {
  if (options.fps < 1 || options.fps > kFastestFilm)
    return Error{"a film has 1 to " + std::to_string(kFastestFilm) + " frames per second, not " +
                 std::to_string(options.fps)};
  if (!(options.hold >= 0 && options.hold <= kLongestHold))
    return Error{"a plan can be held for 0 to " + std::to_string(static_cast<int>(kLongestHold)) +
                 " seconds"};
  const Result<std::size_t> from = moment_position(run, options.from), to = moment_position(run, options.to);
  if (!from) return Error{from.error()};
  if (!to) return Error{to.error()};
  if (*from > *to)
    return Error{"the film would begin at event " + std::to_string(*from) +
                 " and end before that, at event " + std::to_string(*to)};
  Cutter cutter(run, options, *from, *to);
  std::vector<FilmFrame> frames = cutter.cut();
  if (frames.size() > kMostFrames)
    return Error{"the film would have more than " + std::to_string(kMostFrames) +
                 " frames; show more in each (--speed), or less of the run (--from, --to)"};
  return frames;
}

}  // namespace replan
