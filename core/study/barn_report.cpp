#include <algorithm>
#include <array>
#include <cstdio>

#include "core/study/barn.hpp"

namespace replan {
namespace {

template <class... Values>
std::string line(const char* format, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
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
