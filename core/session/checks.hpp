// What the session holds its planners to: their own laws, and the oracle's word on each plan.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/work_place.hpp"
#include "core/debug/difference.hpp"
#include "core/debug/laws.hpp"
#include "core/debug/oracle.hpp"

namespace replan {

class Run;

/// Read by panels; changed by the session's commands and update() alone.
class Checks {
 public:
  /// Worlds up to so many cells are held to their laws unless somebody switches that off: it costs the
  /// drawing thread less than a quarter of a frame there. In larger ones it is off until somebody switches it
  /// on.
  static constexpr std::size_t kCellsByDefault = std::size_t{512} * 512;

  /// For whoever must not wait: above this it takes too long to take in a world, and too much memory to hold its
  /// vertices twice.
  static constexpr std::size_t kCellsAtMost = std::size_t{2048} * 2048;

  /// `place` is where the oracle's answers are worked out.
  explicit Checks(WorkPlace place);
  ~Checks();
  Checks(Checks&&) noexcept;
  Checks& operator=(Checks&&) noexcept;

  /// Panes beyond the last have a report that is not on.
  [[nodiscard]] LawReport laws(std::size_t pane) const;
  [[nodiscard]] OracleReport oracle(std::size_t pane) const;
  /// The first thousand, by position.
  [[nodiscard]] std::span<const Breach> breaches(std::size_t pane) const;
  [[nodiscard]] std::span<const Disagreement> disagreements(std::size_t pane) const;
  /// What the last FindDifference came to; nothing if the two were found to be alike, none was asked for, or
  /// one of the two runs has become another since.
  [[nodiscard]] const std::optional<Difference>& difference() const { return difference_; }
  /// The same as a sentence, "alike to the end" included; empty if none was asked for.
  [[nodiscard]] const std::string& comparison() const { return comparison_; }
  /// While two runs are still being compared.
  [[nodiscard]] bool comparing() const { return comparing_; }
  /// Whether there is more to check of what the logs hold: another update is due.
  [[nodiscard]] bool busy() const { return busy_ || comparing_; }

 private:
  friend class Session;

  struct Pane;
  struct Comparison;
  /// What a comparison is of.
  struct Compared {
    std::array<std::size_t, 2> panes{};
    Compare what{};
    std::array<std::uint64_t, 2> log_ids{};
    friend bool operator==(const Compared&, const Compared&) = default;
  };
  using Runs = std::span<const std::unique_ptr<Run>>;

  /// Switches both for all panes; what was found before is forgotten where it is switched off.
  void set(bool laws, bool oracle);
  /// Goes on for some milliseconds. True if anything that is shown here changed.
  bool update(Runs runs);
  /// Goes on to the end of the logs as they are.
  void settle(Runs runs);
  /// Begins to compare; what was found before of the same runs stands. False if there is nothing to do.
  bool compare(Runs runs, const std::array<std::size_t, 2>& panes, Compare what);
  void stop_comparing();
  /// Goes on comparing. True if it has just come to an end.
  bool compare_on(Runs runs);

  void meet(Runs runs);
  void forget_difference(Runs runs);
  [[nodiscard]] bool laws_on(const Run& run) const;

  WorkPlace place_;
  std::vector<Pane> panes_;
  std::unique_ptr<Comparison> comparison_under_way_;
  std::optional<bool> laws_;  // what somebody chose
  bool oracle_ = false;
  std::size_t most_cells_ = static_cast<std::size_t>(-1);  // of a world whose laws are checked
  std::optional<Compared> compared_;                       // that came to the following
  std::optional<Difference> difference_;
  std::string comparison_;
  bool comparing_ = false;
  bool busy_ = false;
};

}  // namespace replan
