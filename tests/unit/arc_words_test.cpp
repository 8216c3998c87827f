// Why an arc won or lost, in sentences and as a table of samples: held to the numbers that they are made of.
#include "core/debug/arc_words.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/drive/nearest_obstacle.hpp"
#include "core/drive/sample_grid.hpp"

namespace replan::arc_words_test {
namespace {

std::string digits(double number, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
  return text.data();
}

/// A moment of a drive, and what is decided there.
struct DriveMoment {
  DriveState state;
  LocalObstacles obstacles;
  Spot goal;
  DriveSettings settings;
  Explanation why;
};

DriveMoment any_moment(Random& random) {
  const auto spot = [&random] {
    const double x = 6 * random.unit();
    return Spot{x, 6 * random.unit()};
  };
  Settings values;
  values.set("w_max", 1.5);
  values.set("speeds", random.between(2, 8));
  values.set("turns", random.between(2, 15));
  values.set("normalise", random.between(0, 2));
  DriveMoment moment;
  moment.settings = drive_settings(values);
  std::vector<Spot> known, unknown;
  for (int i = random.between(0, 40); i > 0; --i) known.push_back(spot());
  for (int i = random.between(0, 20); i > 0; --i) unknown.push_back(spot());
  moment.obstacles.known = ObstacleSet({0.05, 0}, known);
  moment.obstacles.unknown = ObstacleSet({0, 0.075}, unknown);
  const Spot at = spot();
  moment.state.pose = {at.x, at.y, 6 * random.unit() - 3};
  moment.state.motion = {random.chance(0.3) ? 0 : 0.5 * random.unit(), 2 * random.unit() - 1};
  moment.goal = spot();
  moment.why = explain(moment.state, moment.obstacles, moment.goal, moment.settings);
  return moment;
}

/// The numbers of a sentence about an admissible sample that is not the winner.
void expect_told(const DriveSample& sample, const DriveSample& winner, const std::string& words) {
  std::size_t most = 0;
  std::array<double, kScoreTerms> lost{};
  for (std::size_t i = 0; i < kScoreTerms; ++i) {
    lost[i] = winner.weighted[i] - sample.weighted[i];
    if (lost[i] > lost[most]) most = i;
  }
  EXPECT_NE(words.find("scores " + digits(sample.score, 3)), std::string::npos) << words;
  if (winner.score - sample.score < 0.0005) return;
  const auto term = static_cast<ScoreTerm>(most);
  EXPECT_NE(words.find(std::string("loses most by ") + std::string(score_term_words(term)) + ","),
            std::string::npos)
      << words;
  int count = 3;  // as many as tell them apart
  while (digits(sample.weighted[most], count) == digits(winner.weighted[most], count)) ++count;
  EXPECT_NE(words.find(digits(sample.weighted[most], count) + " against " +
                       digits(winner.weighted[most], count) + "."),
            std::string::npos)
      << words;
  EXPECT_NE(words.find(digits(winner.score - sample.score, 3) + " less"), std::string::npos) << words;
}

TEST(ArcWords, TellByWhichTermAndHowMuchAnArcLost) {
  Random random(1);
  int lost = 0, won = 0, alone = 0;
  for (int i = 0; i < 400; ++i) {
    const DriveMoment moment = any_moment(random);
    if (!moment.why.decision.winner) continue;
    const DriveSample& winner = moment.why.samples[*moment.why.decision.winner];
    for (const DriveSample& sample : moment.why.samples) {
      if (!sample.admissible()) continue;
      const std::string words = verdict_sentence(sample, moment.why, moment.settings);
      if (sample.motion == winner.motion) {
        EXPECT_TRUE(words.starts_with("It is the winner")) << words;
        moment.why.runner_up ? ++won : ++alone;
        continue;
      }
      expect_told(sample, winner, words);
      ++lost;
    }
  }
  EXPECT_GT(lost, 5000);
  EXPECT_GT(won, 200);
}

TEST(ArcWords, TellHowFarAheadTheObstacleIs) {
  Random random(2);
  std::array<int, 6> seen{};
  for (int i = 0; i < 1000; ++i) {
    const DriveMoment moment = any_moment(random);
    for (const DriveSample& sample : moment.why.samples) {
      ++seen[static_cast<std::size_t>(sample.rejection)];
      const std::string words = rejection_sentence(sample, moment.settings);
      EXPECT_EQ(words.empty(), sample.admissible());
      const bool hits =
          sample.rejection == Rejection::too_fast || sample.rejection == Rejection::turns_too_fast;
      if (!hits) continue;
      // Driven along the arc in small steps, it is free until there and touches something a little farther on.
      const Arc arc(moment.state.pose, sample.motion);
      const double radius = moment.settings.limits.radius, gap = moment.settings.margin;
      const auto clearance = [&](double time) {
        return moment.obstacles.to_still(arc.spot(time), 9) - radius;
      };
      EXPECT_LT(sample.contact, sample.stopping);
      if (sample.contact > 0.02) {
        for (double time = 0; time < sample.contact - 0.01; time += 0.01)
          EXPECT_GT(clearance(time), std::min(gap, clearance(0)) - 2e-3);
        EXPECT_LT(clearance(sample.contact), gap + 3e-3);
      }
      const double ahead = sample.motion.v * sample.contact;
      if (ahead < 0.005) continue;
      EXPECT_NE(words.find("the obstacle " + digits(ahead, 2) + " m ahead"), std::string::npos) << words;
      EXPECT_NE(words.find("after " + digits(sample.contact, 1) + " s."), std::string::npos) << words;
    }
  }
  for (const Rejection each : {Rejection::none, Rejection::too_fast, Rejection::circles, Rejection::stands})
    EXPECT_GT(seen[static_cast<std::size_t>(each)], 100) << rejection_name(each);
}

TEST(ArcWords, TellWhatTheRobotDoes) {
  const auto words = [](DriveDeed deed, Twist motion) {
    return deed_sentence({.deed = deed, .motion = motion, .winner = {}});
  };
  EXPECT_EQ(words(DriveDeed::drive, {0.5, 0}), "It drives straight on at 0.50 m/s.");
  EXPECT_EQ(words(DriveDeed::drive, {0.42, -0.1}),
            "It drives at 0.42 m/s and turns to the left at 0.10 rad/s.");
  EXPECT_EQ(words(DriveDeed::drive, {0, 0.2}), "It turns to the right on the spot at 0.20 rad/s.");
  EXPECT_EQ(words(DriveDeed::brake, {0.3, 0}), "No arc is admissible: it brakes to 0.30 m/s.");
  EXPECT_EQ(words(DriveDeed::brake, {0, 0}), "No arc is admissible: it brakes to a stand.");
  EXPECT_TRUE(
      words(DriveDeed::turn, {0, -1}).starts_with("It can drive nowhere from here: it turns to the left"));
  EXPECT_TRUE(words(DriveDeed::stuck, {0, 0}).ends_with("it needs another plan."));
}

TEST(ArcWords, TellWhatTheMotorsCannotReach) {
  Random random(3);
  const DriveMoment moment = any_moment(random);
  const DriveSample far = assess(moment.state, moment.obstacles, moment.goal, moment.settings,
                                 {moment.why.window.v_high + 0.1, 0});
  EXPECT_EQ(rejection_sentence(far, moment.settings), "The motors cannot reach it within 0.2 s.");
}

TEST(SampleGrid, FindsTheSampleThatIsNearest) {
  Random random(4);
  int inside = 0, outside = 0;
  for (int i = 0; i < 300; ++i) {
    const DriveMoment moment = any_moment(random);
    const SampleGrid grid(moment.why, moment.settings);
    for (std::size_t n = 0; n < moment.why.samples.size(); ++n) {
      const auto found = grid.nearest(moment.why, moment.why.samples[n].motion);
      ASSERT_TRUE(found.has_value());
      EXPECT_EQ(moment.why.samples[*found].motion, moment.why.samples[n].motion);
      EXPECT_EQ(grid.sample(grid.row(*found), grid.column(*found)), *found);
    }
    for (int k = 0; k < 20; ++k) {
      const Twist motion{0.6 * random.unit(), 3 * random.unit() - 1.5};
      const auto found = grid.nearest(moment.why, motion);
      const SpeedWindow& window = moment.why.window;
      const bool near =
          motion.v > window.v_low - grid.row_step / 2 && motion.v < window.v_high + grid.row_step / 2 &&
          motion.w > window.w_low - grid.column_step / 2 && motion.w < window.w_high + grid.column_step / 2;
      EXPECT_EQ(found.has_value(), near || window.contains(motion));
      ++(found ? inside : outside);
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 1000);
}

TEST(NearestObstacle, IsAsFarAsTheDistanceSays) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const DriveMoment moment = any_moment(random);
    for (const ObstacleSet* set : {&moment.obstacles.known, &moment.obstacles.unknown}) {
      const auto point = nearest_point(*set, moment.goal);
      EXPECT_EQ(point.has_value(), !set->empty());
      if (!point) continue;
      const double far = set->distance(moment.goal, 100);
      EXPECT_NEAR(distance(*point, moment.goal), std::max(far, 0.0), 1e-9);
      EXPECT_NEAR(set->distance(*point, 1), std::min(far, 0.0), 1e-9);
    }
  }
}

}  // namespace
}  // namespace replan::arc_words_test
