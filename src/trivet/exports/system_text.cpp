// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/system_text.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>

#include "trivet/foundation/index.h"

namespace trivet::exports {
namespace {

void append_matrix(std::string& text, const char* name, const Eigen::MatrixXd& matrix) {
  text += name;
  text += '\n';
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      fmt::format_to(std::back_inserter(text), FMT_COMPILE("{} "), matrix(i, j));
    text += '\n';
  }
}

}  // namespace

std::string system_text(const LinearSystem& system, const std::string& token) {
  std::string text = fmt::format("trivet-linear-system 1\ntoken {}\nstates {} inputs {} outputs {}\n", token,
                                 system.states.size(), system.inputs.size(), system.outputs.size());
  append_matrix(text, "A", system.A);
  append_matrix(text, "B", system.B);
  append_matrix(text, "C", system.C);
  append_matrix(text, "D", system.D);
  append_matrix(text, "initial", initial_states(system).transpose());
  Eigen::RowVectorXd nominals(to_index(system.states.size()));
  for (Eigen::Index i = 0; i < nominals.size(); ++i) nominals(i) = system.states[i].nominal;
  append_matrix(text, "nominals", nominals);
  return text + "end\n";
}

}  // namespace trivet::exports
