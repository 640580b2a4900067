// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "core/errors.h"
#include "core/project.h"
#include "core/task.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/text/units.h"
#include "trivet/results/study_arrays.h"

namespace trivet::python {
namespace {

namespace nb = nanobind;

assembly::MotionQuantity quantity_of(const std::string& name) {
  using assembly::MotionQuantity;
  if (name == "displacement") return MotionQuantity::displacement;
  if (name == "velocity") return MotionQuantity::velocity;
  if (name == "acceleration") return MotionQuantity::acceleration;
  throw foundation::InvalidInput("quantity: \"" + name +
                                 "\"; it is \"displacement\", \"velocity\" or \"acceleration\"");
}

/// Arrays of something computed, which they keep alive.
template <typename Found, typename Arrays>
ArrayList held_arrays(const std::shared_ptr<const Found>& found, const Arrays& arrays) {
  return python_arrays(arrays(*found), found);
}

ArrayList matrices(const OpenProject& open, const std::string& case_name) {
  const auto found =
      std::make_shared<const study::SystemMatrices>(study::system_matrices(case_of(*open.project, case_name)));
  return held_arrays(found, results::matrix_arrays);
}

ArrayList state_space(const OpenProject& open, const std::vector<std::string>& of, const std::string& quantity,
                      bool nearest, const std::string& case_name) {
  const auto found = std::make_shared<const study::LinearSystem>(
      study::linear_system(case_of(*open.project, case_name), of, quantity_of(quantity), nearest));
  return held_arrays(found, results::linear_system_arrays);
}

ArrayList sweep(const OpenProject& open, const std::vector<std::string>& paths,
                const std::vector<std::vector<double>>& values, const std::vector<std::string>& of,
                const std::vector<double>& band, const std::string& quantity, const std::string& case_name, int threads,
                const nb::object& progress) {
  struct Found {
    study::SweepRequest request;
    study::DesignSweep sweep;
  };
  const auto found = std::make_shared<Found>();
  study::SweepRequest& request = found->request;
  for (std::size_t i = 0; i < paths.size(); ++i) request.numbers.push_back({paths[i], values.at(i)});
  request.of = of;
  request.quantity = quantity_of(quantity);
  if (!band.empty() && band.size() != 2) throw foundation::InvalidInput("band: it has two frequencies, FROM and TO");
  if (!band.empty()) request.band = {band[0], band[1]};
  const project::Case& variant = case_of(*open.project, case_name);
  run_task({threads, progress}, [found, project = open.project, &variant](const Progress& report) {
    found->sweep = study::design_sweep(variant, found->request, report);
  });
  return python_arrays(results::sweep_arrays(found->request, found->sweep), found);
}

double angular_frequency(const std::string& text) {
  const auto value = project::to_si(text, project::Quantity::angular_frequency);
  if (!value) throw foundation::InvalidInput("\"" + text + "\": " + value.error() + "; give rad/s, or \"5 Hz\"");
  return *value;
}

}  // namespace

void bind_studies(nb::module_& module, nb::class_<OpenProject>& of) {
  of.def("matrices", matrices, nb::arg("case") = "");
  of.def("state_space", state_space, nb::arg("of"), nb::arg("quantity") = "displacement", nb::arg("nearest") = false,
         nb::arg("case") = "");
  of.def("sweep", sweep, nb::arg("paths"), nb::arg("values"), nb::arg("of"), nb::arg("band"), nb::arg("quantity"),
         nb::arg("case"), nb::arg("threads") = 0, nb::arg("progress") = nb::none());
  module.def("angular_frequency", angular_frequency, nb::arg("text"), "A frequency with its unit in rad/s.");
}

}  // namespace trivet::python
