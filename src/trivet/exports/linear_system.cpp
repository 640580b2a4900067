// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/linear_system.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <set>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::exports {

namespace {

void check_matrix(const char* name, const Eigen::MatrixXd& matrix, std::size_t rows, std::size_t columns) {
  if (matrix.rows() != to_index(rows) || matrix.cols() != to_index(columns))
    throw foundation::InvalidInput(fmt::format("linear system: {} is {} × {}, but must be {} × {}", name, matrix.rows(),
                                               matrix.cols(), rows, columns));
  if (!matrix.allFinite())
    throw foundation::InvalidInput(fmt::format("linear system: {} has an entry that is not finite", name));
}

void check_text(const char* what, const std::string& text, bool one_line) {
  if (const auto character = foundation::unprintable(text, one_line))
    throw foundation::InvalidInput(
        fmt::format("linear system: {} {} has {}", what, foundation::quoted(text), *character));
}

void check_signal(const Signal& signal, std::set<std::string>& names) {
  check_text("the name", signal.name, true);
  check_text("the description", signal.description, false);
  const std::string shown = foundation::quoted(signal.name);
  if (signal.name.empty()) throw foundation::InvalidInput("linear system: a signal has no name");
  if (!names.insert(signal.name).second)
    throw foundation::InvalidInput(fmt::format("linear system: the name {} is used twice", shown));
  if (!std::isfinite(signal.nominal) || !(signal.nominal > 0))
    throw foundation::InvalidInput(
        fmt::format("linear system: the nominal of {} is {}, but must be above 0", shown, signal.nominal));
}

}  // namespace

Eigen::VectorXd initial_states(const LinearSystem& system) {
  if (system.initial.size() == 0) return Eigen::VectorXd::Zero(to_index(system.states.size()));
  return system.initial;
}

void check(const LinearSystem& system) {
  const std::size_t n = system.states.size(), m = system.inputs.size(), p = system.outputs.size();
  check_matrix("A", system.A, n, n);
  check_matrix("B", system.B, n, m);
  check_matrix("C", system.C, p, n);
  check_matrix("D", system.D, p, m);
  check_matrix("the initial state", initial_states(system), n, 1);
  check_text("the title", system.title, true);
  std::set<std::string> names;
  for (const auto* signals : {&system.states, &system.inputs, &system.outputs})
    for (const Signal& signal : *signals) check_signal(signal, names);
}

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
