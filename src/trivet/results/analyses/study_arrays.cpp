// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/study_arrays.h"

#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::results {
namespace {

void add_signals(const std::string& axis, const std::vector<study::Signal>& signals, LabelledArrays& list) {
  list.texts(axis, axis, signals, [](const study::Signal& signal) { return signal.name; });
  list.texts(axis + "_unit", axis, signals,
             [](const study::Signal& signal) { return signal.unit.empty() ? "1" : signal.unit; });
}

std::string unit_of(const study::SweptNumber& number) {
  if (!number.quantity) return "SI";
  const std::string unit = project::printed_si_unit(*number.quantity);
  return unit.empty() ? "1" : unit;
}

}  // namespace

LabelledArrays matrix_arrays(const study::SystemMatrices& matrices) {
  LabelledArrays list;
  list.texts("coordinate", "coordinate", matrices.coordinates);
  list.texts("coordinate_unit", "coordinate", matrices.units);
  const std::pair<std::string, std::string> axes = {"coordinate", "column"};
  list.texts("column", "column", matrices.coordinates);
  const numerics::DynamicMatrices& m = matrices.matrices;
  list.view("A", "SI", axes, m.A);
  list.view("B", "SI", axes, m.B);
  list.view("K", "SI", axes, m.K);
  if (m.lossy()) list.view("K_loss", "SI", axes, m.K_loss);
  else list.copy("K_loss", "SI", axes, Eigen::MatrixXd(Eigen::MatrixXd::Zero(m.size(), m.size())));
  const std::vector<numerics::LoadTerm>& terms = matrices.load.terms();
  list.column("load_power", "1", "load_term", terms, [](const numerics::LoadTerm& term) { return term.power; });
  list.column("load_delay", "s", "load_term", terms, [](const numerics::LoadTerm& term) { return term.delay; });
  Eigen::MatrixXcd loads(to_index(terms.size()), m.size());
  for (std::size_t i = 0; i < terms.size(); ++i) loads.row(to_index(i)) = terms[i].value.transpose();
  list.copy("load", "SI", {"load_term", "coordinate"}, std::move(loads));
  list.value("exact", "1", matrices.exact ? 1 : 0);
  return list;
}

LabelledArrays linear_system_arrays(const study::LinearSystem& system) {
  LabelledArrays list;
  add_signals("state", system.states, list);
  add_signals("input", system.inputs, list);
  add_signals("output", system.outputs, list);
  list.texts("state_derivative", "state_derivative", system.states,
             [](const study::Signal& signal) { return signal.name + " rate"; });
  list.view("A", "SI", {"state_derivative", "state"}, system.A);
  list.view("B", "SI", {"state_derivative", "input"}, system.B);
  list.view("C", "SI", {"output", "state"}, system.C);
  list.view("D", "SI", {"output", "input"}, system.D);
  return list;
}

LabelledArrays sweep_arrays(const study::SweepRequest& request, const study::DesignSweep& sweep) {
  LabelledArrays list;
  LabelledArray amplitude{"amplitude", "unit of the row", {}, {}, {}, sweep.highest.data()};
  for (const study::SweptNumber& number : request.numbers) {
    list.copy(number.path, unit_of(number), number.path, number.values);
    amplitude.axes.push_back(number.path);
    amplitude.shape.push_back(number.values.size());
  }
  list.texts("result", "result", sweep.results);
  list.texts("unit", "result", sweep.units);
  amplitude.axes.emplace_back("result");
  amplitude.shape.push_back(sweep.results.size());
  amplitude.strides.assign(amplitude.shape.size(), 1);
  for (std::size_t i = amplitude.shape.size(); i-- > 1;)
    amplitude.strides[i - 1] = amplitude.strides[i] * static_cast<std::ptrdiff_t>(amplitude.shape[i]);
  list.add(std::move(amplitude));
  list.value("in_kernels", "1", static_cast<double>(sweep.in_kernels));
  list.value("one_by_one", "1", static_cast<double>(sweep.one_by_one));
  list.value("without_model", "1", static_cast<double>(sweep.without_model));
  return list;
}

}  // namespace trivet::results
