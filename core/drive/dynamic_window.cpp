#include "core/drive/dynamic_window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

namespace replan {
namespace {

/// Values spread evenly from low to high.
double spread(double low, double high, int i, int count) {
  return i == count - 1 ? high : low + (high - low) * i / (count - 1);
}

/// The turn rates that are tried, in order.
std::vector<double> turn_rates(const SpeedWindow& window, int count) {
  std::vector<double> rates(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    rates[static_cast<std::size_t>(i)] = spread(window.w_low, window.w_high, i, count);
  if (window.w_low <= 0 && window.w_high >= 0)
    *std::min_element(rates.begin(), rates.end(),
                      [](double a, double b) { return std::abs(a) < std::abs(b); }) = 0;
  return rates;
}

/// The angle between the direction that a robot looks in and that to the goal, 0 .. pi.
double bearing_error(const Spot& at, const SineCosine& heading, Spot goal) {
  const double x = goal.x - at.x, y = goal.y - at.y;
  const double across = heading.cosine * y - heading.sine * x, along = heading.cosine * x + heading.sine * y;
  return std::abs(arc_tangent(across, along));
}

/// A robot that faces its goal so well does not turn in place.
constexpr double kFacing = kPi / 12;

/// One decision at work.
class Judge {
 public:
  Judge(const DriveState& state, const LocalObstacles& obstacles, Spot goal, const DriveSettings& settings)
      : state_(state), obstacles_(obstacles), goal_(goal), settings_(settings) {
    error_ = bearing_error(state.pose.spot(), sine_cosine(state.pose.heading), goal);
    const double far = distance(state.pose.spot(), goal);
    const double across = error_ < kPi / 2 ? sine(error_) : 1;
    homing_ = across > 0 ? settings.limits.w_max * far / (2 * across) : settings.limits.v_max;
    homing_ = std::max(homing_, dynamic_window(state.motion, settings).v_low);
  }

  [[nodiscard]] DriveSample assess(const Twist& motion) const;
  [[nodiscard]] std::vector<DriveSample> samples(const SpeedWindow& window) const;
  void score(std::vector<DriveSample>& samples) const;
  [[nodiscard]] DriveDecision decide(const std::vector<DriveSample>& samples,
                                     std::optional<std::size_t> best) const;

 private:
  [[nodiscard]] Rejection reason(const Twist& motion, double contact) const;
  [[nodiscard]] ScoreTerms terms(const Arc& arc, double time) const;
  [[nodiscard]] DriveDecision turn_in_place() const;
  [[nodiscard]] double free_straight(double by) const;
  [[nodiscard]] double freer_side() const;

  const DriveState& state_;
  const LocalObstacles& obstacles_;
  Spot goal_;
  const DriveSettings& settings_;
  double error_ = 0;   // of the bearing now
  double homing_ = 0;  // the fastest that it can go and still turn in on the goal
};

DriveSample Judge::assess(const Twist& motion) const {
  DriveSample sample;
  sample.motion = motion;
  const Arc arc(state_.pose, motion);
  sample.stopping = stopping_time(motion, settings_);
  double span = settings_.horizon;
  if (motion.v > 0) span = std::min(span, distance(state_.pose.spot(), goal_) / motion.v);
  const double looked_at = std::max(span, sample.stopping);
  const double contact = time_to_contact(arc, obstacles_, settings_, looked_at);
  sample.contact = contact;
  sample.hits = contact < span;
  sample.time = std::min(contact, span);
  sample.rejection = reason(motion, contact);
  sample.end = arc.pose(sample.time);
  sample.raw = terms(arc, sample.time);
  return sample;
}

Rejection Judge::reason(const Twist& motion, double contact) const {
  if (motion.v == 0) return motion.w == 0 || error_ < kFacing ? Rejection::stands : Rejection::none;
  if (contact < stopping_time(motion, settings_)) {
    const bool slow_enough = contact >= settings_.period + motion.v / (2 * settings_.limits.brake);
    return slow_enough ? Rejection::turns_too_fast : Rejection::too_fast;
  }
  return motion.v > homing_ ? Rejection::circles : Rejection::none;
}

ScoreTerms Judge::terms(const Arc& arc, double time) const {
  const Spot end = arc.spot(time);
  const double radius = settings_.limits.radius, most = radius + settings_.reach;
  return {kPi - bearing_error(end, arc.heading(time), goal_), arc.motion().v,
          std::max(obstacles_.to_known(end, most) - radius, 0.0),
          std::max(obstacles_.to_unknown(end, most) - radius, 0.0)};
}

std::vector<DriveSample> Judge::samples(const SpeedWindow& window) const {
  const std::vector<double> rates = turn_rates(window, settings_.turns);
  const int speeds = window.v_high > window.v_low ? settings_.speeds : 1;
  std::vector<DriveSample> samples;
  samples.reserve(static_cast<std::size_t>(speeds) * rates.size());
  for (int i = 0; i < speeds; ++i)
    for (const double w : rates)
      samples.push_back(assess({spread(window.v_low, window.v_high, i, speeds), w}));
  return samples;
}

void Judge::score(std::vector<DriveSample>& samples) const {
  ScoreTerms least{}, divisor{kPi, settings_.limits.v_max, settings_.reach, settings_.reach};
  if (settings_.normalise != Normalise::limits) {
    const bool by_range = settings_.normalise == Normalise::range;
    ScoreTerms most{}, sum{};
    least.fill(std::numeric_limits<double>::infinity());
    for (const DriveSample& sample : samples) {
      if (!sample.admissible()) continue;
      for (std::size_t i = 0; i < kScoreTerms; ++i) {
        least[i] = std::min(least[i], sample.raw[i]);
        most[i] = std::max(most[i], sample.raw[i]);
        sum[i] += sample.raw[i];
      }
    }
    for (std::size_t i = 0; i < kScoreTerms; ++i) {
      divisor[i] = by_range ? most[i] - least[i] : sum[i];
      if (!by_range) least[i] = 0;
    }
  }
  for (DriveSample& sample : samples) {
    if (!sample.admissible()) continue;
    for (std::size_t i = 0; i < kScoreTerms; ++i) {
      sample.normalised[i] = divisor[i] > 0 ? (sample.raw[i] - least[i]) / divisor[i] : 0;
      sample.weighted[i] = settings_.weights[i] * sample.normalised[i];
      sample.score += sample.weighted[i];
    }
  }
}

/// Whether a is to be chosen before b; both admissible. Of equals the faster, then the straighter.
bool before(const DriveSample& a, const DriveSample& b) {
  return std::tuple(a.score, a.motion.v, -std::abs(a.motion.w)) >
         std::tuple(b.score, b.motion.v, -std::abs(b.motion.w));
}

/// The best admissible sample but for one that is left out; the first of equals.
std::optional<std::size_t> best_of(const std::vector<DriveSample>& samples,
                                   std::optional<std::size_t> but = {}) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].admissible() && i != but && (!best || before(samples[i], samples[*best]))) best = i;
  return best;
}

DriveDecision Judge::decide(const std::vector<DriveSample>& samples, std::optional<std::size_t> best) const {
  if (!best) {
    if (state_.motion.v > 0)
      return {.deed = DriveDeed::brake, .motion = braked(state_.motion, settings_), .winner = {}};
    return turn_in_place();
  }
  const DriveSample& winner = samples[*best];
  if (winner.motion.v == 0) {
    const bool could_drive = std::any_of(samples.begin(), samples.end(), [](const DriveSample& sample) {
      return sample.admissible() && sample.motion.v > 0;
    });
    if (!could_drive) return turn_in_place();
  }
  const double turned = winner.motion.v > 0 ? 0 : state_.turned + winner.motion.w * settings_.period;
  return {.deed = DriveDeed::drive,
          .motion = winner.motion,
          .winner = best,
          .score = winner.score,
          .turned = turned};
}

/// It goes on turning the way that it began.
DriveDecision Judge::turn_in_place() const {
  if (std::abs(state_.turned) >= 2 * kPi)
    return {.deed = DriveDeed::stuck,
            .motion = braked(state_.motion, settings_),
            .winner = {},
            .turned = state_.turned};
  const double side = state_.turned != 0 ? (state_.turned > 0 ? 1 : -1) : freer_side();
  const SpeedWindow window = dynamic_window(state_.motion, settings_);
  const double w = side > 0 ? window.w_high : window.w_low;
  return {.deed = DriveDeed::turn,
          .motion = {0, w},
          .winner = {},
          .turned = state_.turned + w * settings_.period};
}

/// How far it could go straight on if it looked in another direction, in metres.
double Judge::free_straight(double by) const {
  Pose turned = state_.pose;
  turned.heading += by;
  return time_to_contact(Arc(turned, {1, 0}), obstacles_, settings_, settings_.reach);
}

/// The side, 1 or -1, to which it has to turn less until it has room to go; of equals that of the goal.
double Judge::freer_side() const {
  const double to_goal = arc_tangent(goal_.y - state_.pose.y, goal_.x - state_.pose.x);
  const double side = wrapped_angle(to_goal - state_.pose.heading) < 0 ? -1 : 1;
  constexpr int kDirections = 8;
  double best = side, farthest = 0;
  for (int i = 1; i <= kDirections; ++i)
    for (const double way : {side, -side}) {
      const double free = free_straight(way * i * kPi / kDirections);
      if (free >= settings_.reach) return way;
      if (free > farthest) std::tie(best, farthest) = std::tuple(way, free);
    }
  return best;
}

}  // namespace

std::string_view rejection_name(Rejection rejection) {
  constexpr std::array<std::string_view, 6> kNames = {"none",           "outside", "too-fast",
                                                      "turns-too-fast", "circles", "stands"};
  return kNames[static_cast<std::size_t>(rejection)];
}

std::string_view drive_deed_name(DriveDeed deed) {
  constexpr std::array<std::string_view, 4> kNames = {"drive", "brake", "turn", "stuck"};
  return kNames[static_cast<std::size_t>(deed)];
}

ScoreTerm largest_lead(const DriveSample& winner, const DriveSample& other) {
  std::size_t term = 0;
  const auto lead = [&](std::size_t i) { return winner.weighted[i] - other.weighted[i]; };
  for (std::size_t i = 1; i < kScoreTerms; ++i)
    if (lead(i) > lead(term)) term = i;
  return static_cast<ScoreTerm>(term);
}

Explanation explain(const DriveState& state, const LocalObstacles& obstacles, Spot goal,
                    const DriveSettings& settings) {
  const Judge judge(state, obstacles, goal, settings);
  Explanation why;
  why.window = dynamic_window(state.motion, settings);
  why.samples = judge.samples(why.window);
  judge.score(why.samples);
  const auto best = best_of(why.samples);
  why.decision = judge.decide(why.samples, best);
  why.decision.admissible = static_cast<std::size_t>(
      std::count_if(why.samples.begin(), why.samples.end(), std::mem_fn(&DriveSample::admissible)));
  if (!best) return why;
  why.runner_up = best_of(why.samples, best);
  if (why.runner_up) why.lost_by = largest_lead(why.samples[*best], why.samples[*why.runner_up]);
  return why;
}

DriveDecision decide(const DriveState& state, const LocalObstacles& obstacles, Spot goal,
                     const DriveSettings& settings) {
  return explain(state, obstacles, goal, settings).decision;
}

DriveSample assess(const DriveState& state, const LocalObstacles& obstacles, Spot goal,
                   const DriveSettings& settings, const Twist& motion) {
  DriveSample sample = Judge(state, obstacles, goal, settings).assess(motion);
  if (!dynamic_window(state.motion, settings).contains(motion)) sample.rejection = Rejection::outside;
  return sample;
}

}  // namespace replan
