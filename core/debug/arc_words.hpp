// Why a robot that drives takes one motion and not another, in sentences.
#pragma once

#include <string>
#include <string_view>

#include "core/drive/dynamic_window.hpp"

namespace replan {

/// What a term is about: "the heading".
std::string_view score_term_words(ScoreTerm term);
/// The unit of its raw values: "rad".
std::string_view score_term_unit(ScoreTerm term);

/// What the robot does for the next period.
std::string deed_sentence(const DriveDecision& decision);
/// Why a sample is the winner, by which term and how much it lost to that, or why it is not to be chosen.
std::string verdict_sentence(const DriveSample& sample, const Explanation& why,
                             const DriveSettings& settings);
/// Why a motion is not to be chosen; empty if it is.
std::string rejection_sentence(const DriveSample& sample, const DriveSettings& settings);
/// "0.42 m/s".
std::string speed_text(double speed);
/// "0.10 rad/s left"; "0 rad/s" for none.
std::string turn_text(double turn);

}  // namespace replan
