// The same commands give the same events, on every machine and at every optimisation level: hashes of whole
// logs against those in tests/golden/event_logs.txt. With REPLAN_WRITE_GOLDEN set the file is written anew;
// say in the commit why the logs changed.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/plan/registry.hpp"

namespace replan::test::golden_log_test {
namespace {

const std::string kFile = std::string(REPLAN_SOURCE_DIR) + "/tests/golden/event_logs.txt";

/// Settings by name; a planner takes those that it declares.
struct Variant {
  const char* name;
  std::map<std::string, std::string> settings;
  const char* only_with = nullptr;  ///< planners that do not declare this setting are left out
};
const std::vector<Variant>& variants() {
  static const std::vector<Variant> all = {
      {"defaults", {}},
      {"paper", {{"heuristic", "euclidean"}, {"sight", "bresenham"}, {"remote_parents", "printed"}}},
      {"wide", {{"range", "3.5"}, {"transform", "euclidean"}, {"border", "true"}, {"corners", "one"}}},
      {"plain", {{"heuristic", "zero"}, {"moves", "4"}, {"corners", "any"}}},
      {"along", {{"sight_checks", "path"}}, "sight_checks"},
      {"threat", {{"penalty", "threat"}, {"r_max", "4"}}, "penalty"},
  };
  return all;
}

std::uint64_t hash_of(const std::vector<Event>& log) {
  std::uint64_t hash = log.size();
  for (const Event& event : log) {
    hash = hash_combine(hash, event.delta);
    hash = hash_combine(hash, event.node);
    hash = hash_combine(hash, static_cast<std::uint64_t>(event.kind) << 8 | event.line);
  }
  return hash;
}

template <int D>
constexpr typename BoxLattice<D>::Coordinates kSize{};
template <>
constexpr BoxLattice<2>::Coordinates kSize<2>{40, 30};
template <>
constexpr BoxLattice<3>::Coordinates kSize<3>{12, 11, 9};

/// A plan and eight replans on a world drawn from a fixed seed; everything that was recorded.
template <int D>
std::vector<Event> fixed_run(const PlannerInfo& info, const Settings& settings) {
  Random random(2018);
  std::size_t count = 1;
  for (const int extent : kSize<D>) count *= static_cast<std::size_t>(extent);
  std::vector<std::uint8_t> cells(count);
  for (std::uint8_t& cell : cells) cell = random.below(100) < 14 ? 1 : 0;
  const auto last = static_cast<NodeId>(count - 1);
  cells[0] = cells[last] = 0;
  BoxLattice<D> lattice(kSize<D>, cells, move_rules(settings));
  Recorder recorder;
  const auto planner = make_planner(info, lattice, settings, recorder);
  planner->begin(0, last);
  finish(*planner);
  NodeId start = 0;
  for (int i = 0; i < 8; ++i) {
    const Path path = planner->path();
    if (path.size() > 2) start = lattice.node(cell_of(path.point(1)));
    std::vector<CellEdit> edits;
    for (int k = 0; k < 6; ++k) {
      const NodeId node = 1 + random.below(static_cast<std::uint32_t>(count) - 2);
      const auto same = [node](const CellEdit& edit) { return edit.node == node; };
      if (node != start && std::none_of(edits.begin(), edits.end(), same))
        edits.push_back({node, !lattice.blocked(node)});
    }
    const auto moves = lattice.apply(edits);
    planner->update({.cells = edits, .moves = moves}, start);
    finish(*planner);
  }
  planner->path();
  return recorder.take();
}

/// One line for each planner, lattice and variant: name, number of events, hash.
std::string all_logs() {
  std::ostringstream text;
  for (const PlannerInfo& info : planners())
    for (const Variant& variant : variants()) {
      if (variant.only_with != nullptr && find_parameter(info.parameters, variant.only_with) == nullptr)
        continue;
      Settings settings;
      for (const auto& [key, value] : variant.settings)
        EXPECT_TRUE(find_parameter(info.parameters, key) == nullptr ||
                    set_from_text(settings, info.parameters, key, value).ok())
            << key << '=' << value;
      for (const int dimensions : {2, 3}) {
        if (dimensions == 3 && info.planar) continue;
        const auto log = dimensions == 2 ? fixed_run<2>(info, settings) : fixed_run<3>(info, settings);
        text << info.id << ' ' << variant.name << ' ' << dimensions << "d " << std::dec << log.size() << ' '
             << std::hex << hash_of(log) << '\n';
      }
    }
  return text.str();
}

TEST(GoldenLogs, areTheSameEverywhere) {
  const std::string found = all_logs();
  if (std::getenv("REPLAN_WRITE_GOLDEN") != nullptr) {
    std::ofstream(kFile) << found;
    GTEST_SKIP() << "wrote " << kFile;
  }
  std::ifstream in(kFile);
  std::ostringstream expected;
  expected << in.rdbuf();
  EXPECT_EQ(found, expected.str())
      << "The logs changed. If that was meant, run this test with REPLAN_WRITE_GOLDEN=1.";
}

TEST(GoldenLogs, areTheSameTwiceInOneProcess) {
  EXPECT_EQ(all_logs(), all_logs());
}

}  // namespace
}  // namespace replan::test::golden_log_test
