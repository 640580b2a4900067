// SPDX-License-Identifier: BSD-3-Clause
// Sixteen kinds of matrices on which solvers fail, from hard_cases.txt, with the true solution at frequencies around
// their resonances.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "paper_machine.h"
#include "quad.h"

namespace trivet::benchmarks {

struct HardCase {
  std::string name;
  bool lightly_damped = false;
  double least_damping_ratio = 0;
  PaperMachine system;
  std::vector<double> omega;
  std::vector<std::vector<QuadComplex>> truth;
};

inline std::vector<HardCase> hard_cases(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + " cannot be read");
  std::vector<HardCase> cases;
  const auto line = [&in] {
    std::string text;
    std::getline(in, text);
    return std::istringstream(text);
  };
  for (std::string name; std::getline(in, name);) {
    if (name.empty() || name[0] == '#') continue;
    HardCase c;
    c.name = name;
    line() >> c.lightly_damped >> c.least_damping_ratio;
    for (Matrix6* m : {&c.system.A, &c.system.B, &c.system.K}) {
      auto numbers = line();
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) numbers >> (*m)(i, j), (*m)(j, i) = (*m)(i, j);
    }
    auto load = line(), frequencies = line();
    for (double& h : c.system.load) load >> h;
    for (double w; frequencies >> w;) c.omega.push_back(w);
    for (const double w : c.omega)
      c.truth.push_back(quad_solution(c.system.A, c.system.B, c.system.K, c.system.load, w));
    cases.push_back(std::move(c));
  }
  return cases;
}

}  // namespace trivet::benchmarks
