// The way to a moment of a run that was just opened: the run is sent on to it in the background, and what is found there
// is held against what was promised.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/deadline.hpp"
#include "core/session/session.hpp"
#include "core/trace/log_hash.hpp"
#include "core/trace/state_hash.hpp"

namespace replan::ui {

class Arrival {
 public:
  /// Where to, and what is to be found there, as far as that is known.
  struct Moment {
    enum class From : std::uint8_t { text, link } from = From::text;
    std::size_t event = 0;                    ///< position in the leading run's log
    std::optional<std::uint64_t> state = {};  ///< SearchState::hash() there
    std::optional<std::uint32_t> log = {};    ///< LogHash::short_value() of the log up to there
  };
  /// How it went, as a sentence.
  struct Outcome {
    std::string words;
    bool bad = false;
  };

  void begin(const Session& session, const Moment& moment);
  void cancel() { going_.reset(); }
  [[nodiscard]] bool busy() const { return going_.has_value(); }
  /// Which event it leads to, and how much of the way is made, 0 to 1. Only while busy().
  [[nodiscard]] std::size_t event() const { return going_->to.event; }
  [[nodiscard]] double share(const Session& session) const;

  /// Once a frame, for a few milliseconds. The outcome when it is there, or cannot come there.
  std::optional<Outcome> go_on(Session& session);

 private:
  struct Going {
    Moment to;
    std::uint64_t log = 0;  ///< Run::log_id(); another one: somebody has gone another way
    bool sent = false;      ///< the run was sent on
    bool there = false;
    std::optional<StateHash> state = {};  ///< of what was come to, while that is read
    std::optional<LogHash> events = {};   ///< likewise
  };

  [[nodiscard]] std::optional<Outcome> arrive(Session& session);
  [[nodiscard]] std::optional<Outcome> compare(const Session& session);
  [[nodiscard]] Outcome give_up(const Session& session);

  std::optional<Going> going_;
};

}  // namespace replan::ui
