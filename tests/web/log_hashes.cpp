// For every scenario that is named, and each of its planners: how long the log of the whole mission is, and a hash of it.
// Built for the desktop and for the page's machine, it prints the same (tests/web/logs_test.sh).
#include <cstdio>
#include <memory>

#include "core/session/run.hpp"
#include "core/world/scenario.hpp"

namespace {

bool print_logs(const char* file) {
  const replan::Result<replan::Scenario> read = replan::read_scenario(file);
  if (!read) {
    std::fprintf(stderr, "%s\n", read.error().c_str());
    return false;
  }
  const auto scenario = std::make_shared<const replan::Scenario>(*read);
  for (std::size_t pane = 0; pane < scenario->planners.size(); ++pane) {
    replan::Run run(scenario, pane);
    run.finish(replan::Target::end());
    std::printf("%s %s %zu %016llx\n", file, scenario->planners[pane].id.c_str(), run.timeline().size(),
                static_cast<unsigned long long>(run.timeline().log_hash()));
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  bool all = argc > 1;
  for (int i = 1; i < argc; ++i) all = print_logs(argv[i]) && all;
  return all ? 0 : 1;
}
