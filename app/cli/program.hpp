// The command line as a whole: which command was asked for, help, and the one line about what is wrong.
#pragma once

namespace replan::cli {

/// Runs the program and returns its exit code.
int run_program(int argc, char** argv);

}  // namespace replan::cli
