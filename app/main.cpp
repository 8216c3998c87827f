// replan: a laboratory for robot path planning.
#include "app/cli/program.hpp"

int main(int argc, char** argv) {
  return replan::cli::run_program(argc, argv);
}
