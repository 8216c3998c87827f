#include "app/cli/program.hpp"

#include <csignal>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/window.hpp"
#include "core/link/link.hpp"

namespace replan::cli {
namespace {

std::string footer() {
  return std::string("Examples:\n") +
         (has_window() ? "  replan maps/demo.json\n"
                         "      Opens the demo in the window.\n"
                         "  replan 'replan.html#v=1&at=1200&world=...'\n"
                         "      Opens the world of a link at its event (Help > Copy a link to this moment).\n"
                       : "") +
         "  replan run maps/demo.json\n"
         "      Its figures, without a window.\n" +
         (has_window() ? "  replan render maps/demo.json -o demo.png --at-end\n"
                         "      A picture, without a display.\n"
                       : "") +
         "  replan batch arena.map.scen --planner astar,dstar-lite\n"
         "      All problems of a benchmark file.\n\n"
         "'replan COMMAND --help' tells the options of a command, with examples and every planner setting.\n"
         "Exit codes: 0 done, 1 no path or a failed check, 2 bad input.";
}

/// The command whose options are being read.
const CLI::App& current(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program : *chosen.front();
}

std::string help_hint(const CLI::App& program) {
  const CLI::App& app = current(program);
  return "; see 'replan " + (&app == &program ? "" : app.get_name() + " ") + "--help'";
}

/// "replan FILE" where there is no such file: perhaps a command was meant.
Error no_such_file(const CLI::App& program, const std::string& file) {
  if (file.find_first_of("./") != std::string::npos)
    return {"cannot read '" + file + "': there is no such file"};
  std::vector<std::string> held;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    held.push_back(command->get_name());
  const std::vector<std::string_view> names(held.begin(), held.end());
  return {"there is no file '" + file + "' and no command of that name" +
          suggestion(file, names, "; see 'replan --help'")};
}

bool exists(const std::string& file) {
  std::error_code failed;
  return std::filesystem::exists(file, failed);
}

/// An argument that no option takes.
Error unexpected(const CLI::App& program, const std::string& argument) {
  const CLI::App& app = current(program);
  std::vector<std::string> held;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) held.push_back("--" + name);
  const std::vector<std::string_view> names(held.begin(), held.end());
  if (!argument.starts_with("-"))
    return {"there is one argument too many: '" + argument + "'" + help_hint(program)};
  return {"unknown option '" + argument + "'" + suggestion(argument, names, help_hint(program))};
}

/// CLI11's errors as one sentence in our words.
Error sentence(const CLI::App& program, const std::string& file, const CLI::ParseError& error) {
  const bool window = program.get_subcommands().empty();
  if (window && !file.empty() && !is_link(file) && !exists(file)) return no_such_file(program, file);
  const auto extra = program.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extra.empty())
    return unexpected(program, extra.front());
  return {std::string(error.what()) + help_hint(program)};
}

/// What is said of the window alone, before any command.
struct WindowArguments {
  std::string file;
  bool in_step = false;
};

Result<int> show(const CLI::App& program, const WindowArguments& window) {
  const std::string& file = window.file;
  if (!file.empty() && !is_link(file) && !exists(file)) return no_such_file(program, file);
  const auto closed = open_window(file.empty() ? std::nullopt : std::optional(file), window.in_step);
  if (!closed) return Error{closed.error()};
  return kDone;
}

Result<int> carry_out(const CLI::App& program, const std::vector<Command>& commands,
                      const WindowArguments& window) {
  for (const Command& command : commands) {
    if (!command.app->parsed()) continue;
    if (window.in_step) return Error{"--in-step is for the window alone: leave it out before a command"};
    return command.action();
  }
  return show(program, window);
}

/// Prints the help or the version that was asked for.
int answer(const CLI::App& program, const CLI::Success& asked) {
  std::ostringstream out, none;
  program.exit(asked, out, none);
  print(out.str());
  return kDone;
}

}  // namespace

int run_program(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // print() sees a closed pipe as a failed write
  CLI::App program(
      has_window() ? "Replan: a laboratory for robot path planning. Without a command it opens the window."
                   : "Replan: a laboratory for robot path planning, built without its window.",
      "replan");
  program.set_version_flag("--version", "replan " REPLAN_VERSION, "Print the version and exit");
  program.require_subcommand(0, 1);
  program.footer(footer());
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.get_formatter()->label("Positionals", "Arguments");
  program.get_formatter()->label("TEXT", "");
  WindowArguments window;
  program.add_option("FILE", window.file, "A scenario, a map, an experiment or a link to open in the window");
  if (has_window())
    program.add_flag("--in-step", window.in_step,
                     "Have the window work in step with its frames, without threads: for finding faults");
  std::vector<Command> commands = {add_run(program),     add_batch(program),   add_merge(program),
                                   add_compare(program), add_anytime(program), add_barn(program),
                                   add_study(program)};
  for (Command& command : add_drawing(program)) commands.push_back(std::move(command));
  for (const auto add : {add_convert, add_show, add_list}) commands.push_back(add(program));
  for (const Command& command : commands) command.app->group("Commands");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return finish_output(answer(program, asked));
  } catch (const CLI::ParseError& error) {
    complain(sentence(program, window.file, error).message);
    return kBadInput;
  }
  try {
    const Result<int> code = carry_out(program, commands, window);
    if (code) return finish_output(*code);
    complain(code.error());
  } catch (const std::bad_alloc&) {
    complain("there is not enough memory for this world");
  }
  return finish_output(kBadInput);
}

}  // namespace replan::cli
