#pragma once

namespace striate::app {

/// The command `striate` with its words, program first. @return the exit code
int run_program(int argc, char** argv);

}  // namespace striate::app
