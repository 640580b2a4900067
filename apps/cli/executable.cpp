// SPDX-License-Identifier: BSD-3-Clause
#include "cli/main_program.h"

int main(int argc, char** argv) { return trivet::cli::main_program(argc, argv); }
