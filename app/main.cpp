#include "striate/app/program.hpp"

int main(int argc, char** argv) {
  return striate::app::run_program(argc, argv);
}
