#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/words.hpp"
#include "core/study/barn.hpp"

namespace replan {
namespace {

template <class... Values>
std::string line(const char* format, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// The place that a drive did not leave any more, and since which tick.
struct LastPlace {
  std::size_t since = 0;
  double width = 0, height = 0;  // m
};

LastPlace last_place(const std::vector<Pose>& track) {
  constexpr double kSide = 2;  // m
  LastPlace place{track.size(), 0, 0};
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  while (place.since > 0) {
    const Pose& at = track[place.since - 1];
    left = std::min(left, at.x), right = std::max(right, at.x);
    top = std::min(top, at.y), bottom = std::max(bottom, at.y);
    if (right - left > kSide || bottom - top > kSide) break;
    place = {place.since - 1, right - left, bottom - top};
  }
  return place;
}

/// How far a robot of that radius comes straight to the goal before it touches a disc; nothing: all the way.
std::optional<double> closed_after(const BarnWorld& world, Spot from, double radius) {
  constexpr double kStep = 0.01;  // m
  const ObstacleSet discs({0, world.disc_radius}, world.discs);
  const double far = distance(from, world.goal);
  for (double along = 0; along < far; along += kStep) {
    const double part = along / far;
    const Spot at{from.x + (world.goal.x - from.x) * part, from.y + (world.goal.y - from.y) * part};
    if (discs.distance(at, radius + kStep) < radius) return along;
  }
  return std::nullopt;
}

std::string failure_text(const std::string& name, const BarnWorld& world, const BarnDrive& drive,
                         const BarnSettings& settings) {
  if (drive.end == BarnEnd::collision)
    return line("%s, world %d: hit a cylinder after %.1f s, %.2f m from the goal.\n", name.c_str(),
                drive.world, drive.time, drive.to_goal);
  const LastPlace place = last_place(drive.track);
  const double since = settings.drive.period * static_cast<double>(place.since);
  const auto closed = closed_after(world, drive.track.back().spot(), settings.drive.limits.radius);
  std::string text =
      line("%s, world %d: out of time, %.2f m from the goal. From %.1f s on it stayed within %.1f x %.1f m. ",
           name.c_str(), drive.world, drive.to_goal, since, place.width, place.height);
  text += closed ? line("The straight way to the goal is closed after %.2f m. ", *closed)
                 : "The straight way to the goal is open. ";
  if (drive.stuck > 0) text += "It turned round in vain " + counted(drive.stuck, "time") + ". ";
  if (drive.replans > 0)
    text += "It made " + counted(drive.replans, "plan") + "; " + std::to_string(drive.no_path) +
            " found no way. ";
  text.back() = '\n';
  return text;
}

}  // namespace

std::string_view barn_end_name(BarnEnd end) {
  constexpr std::array<std::string_view, 3> kNames = {"success", "collision", "timeout"};
  return kNames[static_cast<std::size_t>(end)];
}

BarnSummary summary_of(const std::string& name, const std::vector<BarnDrive>& drives) {
  BarnSummary sum;
  sum.name = name;
  sum.worlds = drives.size();
  sum.least_gap = drives.empty() ? 0 : drives.front().least_gap;
  for (const BarnDrive& drive : drives) {
    sum.success += drive.end == BarnEnd::success ? 1 : 0;
    sum.collision += drive.end == BarnEnd::collision ? 1 : 0;
    sum.timeout += drive.end == BarnEnd::timeout ? 1 : 0;
    sum.time += drive.end == BarnEnd::success ? drive.time : 0;
    sum.score += drive.score;
    sum.least_gap = std::min(sum.least_gap, drive.least_gap);
  }
  const auto all = static_cast<double>(std::max<std::size_t>(drives.size(), 1));
  sum.time /= std::max(sum.success, 1.0);
  for (double* share : {&sum.success, &sum.collision, &sum.timeout, &sum.score}) *share /= all;
  return sum;
}

std::string barn_table(const std::vector<BarnSummary>& summaries) {
  std::string text =
      "| drive | worlds | success | collision | timeout | time (s) | score | least gap (m) |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|\n"
      "| DWA, published: README, 10 runs each | 50 | 0.880 | 0.048 | 0.072 | 33.47 | 0.169 | |\n"
      "| DWA, published: dwa_out.txt, evaluated | 50 | 0.850 | 0.056 | 0.094 | 34.09 | 0.159 | |\n";
  for (const BarnSummary& sum : summaries)
    text += line("| %s | %zu | %.3f | %.3f | %.3f | %.2f | %.3f | %.3f |\n", sum.name.c_str(), sum.worlds,
                 sum.success, sum.collision, sum.timeout, sum.time, sum.score, sum.least_gap);
  return text;
}

std::string barn_failures(const std::string& name, const std::vector<BarnWorld>& worlds,
                          const std::vector<BarnDrive>& drives, const BarnSettings& settings) {
  std::string text;
  for (const BarnDrive& drive : drives) {
    if (drive.end == BarnEnd::success) continue;
    const auto world = std::find_if(worlds.begin(), worlds.end(),
                                    [&](const BarnWorld& each) { return each.number == drive.world; });
    text += failure_text(name, *world, drive, settings);
  }
  return text;
}

std::string barn_csv(const std::string& name, const std::vector<BarnDrive>& drives) {
  if (name.empty())
    return "drive,world,end,time_s,score,way_m,least_gap_m,to_goal_m,replans,brakes,turns,stuck,no_path\n";
  std::string text;
  for (const BarnDrive& drive : drives)
    text += line("%s,%d,%s,%.2f,%.4f,%.3f,%.4f,%.3f,%d,%d,%d,%d,%d\n", name.c_str(), drive.world,
                 barn_end_name(drive.end).data(), drive.time, drive.score, drive.way, drive.least_gap,
                 drive.to_goal, drive.replans, drive.brakes, drive.turns, drive.stuck, drive.no_path);
  return text;
}

}  // namespace replan
