#include "core/debug/arc_words.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "core/debug/event_words.hpp"

namespace replan {
namespace {

/// On a screen, where y points down.
const char* side_of(double turn) {
  return turn > 0 ? "right" : "left";
}

std::string drive_sentence(const Twist& motion) {
  if (motion.v > 0 && motion.w == 0) return "It drives straight on at " + speed_text(motion.v) + ".";
  const std::string rate = decimal_text(std::abs(motion.w), 2) + " rad/s";
  if (motion.v == 0)
    return "It turns to the " + std::string(side_of(motion.w)) + " on the spot at " + rate + ".";
  return "It drives at " + speed_text(motion.v) + " and turns to the " + side_of(motion.w) + " at " + rate +
         ".";
}

std::string winner_sentence(const DriveSample& winner, const Explanation& why) {
  const std::string score = decimal_text(winner.score, 3);
  if (!why.runner_up) return "It is the winner with a score of " + score + ": no other arc is admissible.";
  const DriveSample& next = why.samples[*why.runner_up];
  if (winner.score - next.score < 0.0005)
    return "It is the winner: the next best scores " + score +
           " too, and of equals the faster is taken, then the straighter.";
  return "It is the winner: it scores " + score + ", " + decimal_text(winner.score - next.score, 3) +
         " more than the next best.";
}

/// Two different numbers with as many digits as tell them apart.
std::pair<std::string, std::string> told_apart(double a, double b) {
  for (int digits = 3;; ++digits) {
    std::pair<std::string, std::string> texts{decimal_text(a, digits), decimal_text(b, digits)};
    if (texts.first != texts.second || digits == 9) return texts;
  }
}

std::string loser_sentence(const DriveSample& sample, const DriveSample& winner) {
  const std::string score = decimal_text(sample.score, 3);
  if (winner.score - sample.score < 0.0005)
    return "It scores " + score + " like the winner: of equals the faster is taken, then the straighter.";
  const auto term = static_cast<std::size_t>(largest_lead(winner, sample));
  const auto [own, winners] = told_apart(sample.weighted[term], winner.weighted[term]);
  return "It scores " + score + ", " + decimal_text(winner.score - sample.score, 3) +
         " less than the winner: it loses most by " +
         std::string(score_term_words(static_cast<ScoreTerm>(term))) + ", " + own + " against " + winners +
         ".";
}

}  // namespace

std::string_view score_term_words(ScoreTerm term) {
  constexpr std::array<std::string_view, kScoreTerms> kWords = {
      "the heading", "the speed", "the distance from known obstacles", "the distance from unknown obstacles"};
  return kWords[static_cast<std::size_t>(term)];
}

std::string_view score_term_unit(ScoreTerm term) {
  constexpr std::array<std::string_view, kScoreTerms> kUnits = {"rad", "m/s", "m", "m"};
  return kUnits[static_cast<std::size_t>(term)];
}

std::string deed_sentence(const DriveDecision& decision) {
  switch (decision.deed) {
    case DriveDeed::drive:
      return drive_sentence(decision.motion);
    case DriveDeed::brake:
      if (decision.motion.v < 0.005) return "No arc is admissible: it brakes to a stand.";
      return "No arc is admissible: it brakes to " + speed_text(decision.motion.v) + ".";
    case DriveDeed::turn:
      return std::string("It can drive nowhere from here: it turns to the ") + side_of(decision.motion.w) +
             " on the spot until it finds a way.";
    case DriveDeed::stuck:
      break;
  }
  return "It has turned all the way round and found no way: it needs another plan.";
}

std::string rejection_sentence(const DriveSample& sample, const DriveSettings& settings) {
  const double ahead = sample.motion.v * sample.contact;
  const std::string obstacle = "the obstacle " + decimal_text(ahead, 2) +
                               " m ahead, which it would hit after " + decimal_text(sample.contact, 1) +
                               " s.";
  constexpr double kTouch = 0.005;  // m
  switch (sample.rejection) {
    case Rejection::none:
      return "";
    case Rejection::outside:
      return "The motors cannot reach it within " + decimal_text(settings.period, 1) + " s.";
    case Rejection::too_fast:
      if (ahead < kTouch) return "It would drive against an obstacle that the robot almost touches.";
      return "It is too fast to stop before " + obstacle;
    case Rejection::turns_too_fast:
      if (ahead < kTouch) return "It would drive against an obstacle that the robot almost touches.";
      return "It turns too fast to come to a stand before " + obstacle;
    case Rejection::circles:
      return "At this speed it cannot turn in on its sub-goal, but would circle round it.";
    case Rejection::stands:
      break;
  }
  return sample.motion.w == 0 ? "Standing still is no choice."
                              : "The robot faces its sub-goal: it does not turn on the spot.";
}

std::string verdict_sentence(const DriveSample& sample, const Explanation& why,
                             const DriveSettings& settings) {
  if (!sample.admissible()) return rejection_sentence(sample, settings);
  if (!why.decision.winner) return "It is admissible, but it leads nowhere: the robot looks for a way first.";
  const DriveSample& winner = why.samples[*why.decision.winner];
  return sample.motion == winner.motion ? winner_sentence(winner, why) : loser_sentence(sample, winner);
}

std::string speed_text(double speed) {
  return decimal_text(speed, 2) + " m/s";
}

std::string turn_text(double turn) {
  if (turn == 0) return "0 rad/s";
  return decimal_text(std::abs(turn), 2) + " rad/s " + side_of(turn);
}

}  // namespace replan
