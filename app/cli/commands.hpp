// The commands of the program. Each is declared once, with its options, help and examples, and carried out
// when it was the one asked for.
#pragma once

#include <functional>
#include <vector>

#include "core/base/result.hpp"

namespace CLI {
class App;
}

namespace replan::cli {

/// A command and what it does. The action returns the exit code, or the sentence to complain with.
struct Command {
  CLI::App* app = nullptr;
  std::function<Result<int>()> action;
};

Command add_run(CLI::App& program);
Command add_batch(CLI::App& program);
Command add_merge(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_barn(CLI::App& program);
Command add_study(CLI::App& program);
Command add_anytime(CLI::App& program);
Command add_convert(CLI::App& program);
Command add_show(CLI::App& program);
Command add_list(CLI::App& program);
Command add_render(CLI::App& program);  // in a program with a window alone

}  // namespace replan::cli
