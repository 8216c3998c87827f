#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/batch_output.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/experiment/results_folder.hpp"

namespace replan::cli {
namespace {

struct MergeArguments {
  std::vector<std::string> folders;
  std::string out;
};

Result<int> merge(const MergeArguments& arguments) {
  BatchSums sums;
  const auto merged =
      merge_results(arguments.folders, arguments.out, [&](const RunResult& result) { sums.add(result); });
  if (!merged) return Error{merged.error()};
  print(counted(*merged, "run") + " of " + counted(arguments.folders.size(), "part") + " in '" +
        arguments.out + "'\n\n" + batch_table(sums.reports(), BatchKind::experiment));
  return kDone;
}

std::string merge_footer() {
  return "Examples:\n"
         "  replan merge part1 part2 part3 -o results\n"
         "      Three parts that 'replan batch --shard' has made: results.csv and results.json have the same "
         "bytes\n"
         "      as if one process had made all runs.\n\n"
         "Nothing is written if the parts are of different experiments, or if runs are missing or there "
         "twice: the\n"
         "error has their numbers.\n";
}

}  // namespace

Command add_merge(CLI::App& program) {
  CLI::App* app = program.add_subcommand("merge", "Put the parts of an experiment together");
  const auto arguments = std::make_shared<MergeArguments>();
  app->add_option("DIR", arguments->folders, "The folders of the parts")->required()->type_name("...");
  app->add_option("-o,--output", arguments->out, "The folder of the whole")->required()->type_name("DIR");
  app->footer(merge_footer);
  return {app, [arguments] { return merge(*arguments); }};
}

}  // namespace replan::cli
