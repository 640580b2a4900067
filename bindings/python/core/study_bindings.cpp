// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>
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

/// Arrays of something computed, and warnings about it.
using Study = nb::typed<nb::tuple, ArrayList, nb::typed<nb::list, foundation::Problem>>;

/// @param held  what the arrays refer to
Study study_of(const results::LabelledArrays& arrays, const std::shared_ptr<const void>& held,
               const foundation::Problems& warnings) {
  nb::list list;
  for (const foundation::Problem& one : warnings.list()) list.append(one);
  return nb::make_tuple(python_arrays(arrays, held), list);
}

Study matrices(const OpenProject& open, const std::string& case_name, const nb::object& progress) {
  const auto found = std::make_shared<study::SystemMatrices>();
  const project::Case& variant = case_of(*open.project, case_name);
  run_task({0, progress, "matrices"},
           [found, project = open.project, &variant](const Progress&) { *found = study::system_matrices(variant); });
  foundation::Problems warnings = without_unused(*open.project, variant.warnings);
  if (!found->exact)
    warnings.warning("elements", "frequency-dependent elements", "B and K are those of their nearest linear system",
                     "take `response` for exact amplitudes");
  return study_of(results::matrix_arrays(*found), found, warnings);
}

Study state_space(const OpenProject& open, const std::vector<std::string>& of, const std::string& quantity,
                  bool nearest, const std::string& case_name, const nb::object& progress) {
  const auto found = std::make_shared<study::LinearSystem>();
  const project::Case& variant = case_of(*open.project, case_name);
  const assembly::MotionQuantity motion = quantity_of(quantity);
  run_task({0, progress, "state_space"},
           [found, project = open.project, &variant, of, motion, nearest](const Progress&) {
             *found = study::linear_system(variant, of, motion, nearest);
           });
  foundation::Problems warnings = without_unused(*open.project, variant.warnings);
  warnings.add(found->warnings);
  return study_of(results::linear_system_arrays(*found), found, warnings);
}

/// What is asked of a sweep, in the words of the package.
struct AskedSweep {
  std::vector<std::string> paths;
  std::vector<std::vector<study::WrittenValue>> values;
  std::vector<std::string> of, excitations;
  std::vector<double> band;
};

study::SweepRequest request_of(const project::Case& variant, const AskedSweep& asked) {
  study::SweepRequest request;
  for (std::size_t i = 0; i < asked.paths.size(); ++i)
    request.numbers.push_back(study::swept_number(variant, asked.paths[i], asked.values.at(i)));
  request.of = asked.of;
  request.excitations = asked.excitations;
  if (!asked.band.empty() && asked.band.size() != 2)
    throw foundation::InvalidInput("band: it has two frequencies, FROM and TO");
  if (!asked.band.empty()) request.band = {asked.band[0], asked.band[1]};
  return request;
}

Study sweep(const OpenProject& open, const std::vector<std::string>& paths,
            const std::vector<std::vector<study::WrittenValue>>& values, const std::vector<std::string>& of,
            const std::vector<std::string>& excitations, const std::vector<double>& band, const std::string& quantity,
            const std::string& case_name, int threads, const nb::object& progress) {
  struct Found {
    study::SweepRequest request;
    study::DesignSweep sweep;
  };
  const auto found = std::make_shared<Found>();
  const project::Case& variant = case_of(*open.project, case_name);
  found->request = request_of(variant, {paths, values, of, excitations, band});
  found->request.quantity = quantity_of(quantity);
  run_task({threads, progress, "sweep"}, [found, project = open.project, &variant](const Progress& report) {
    found->sweep = study::design_sweep(variant, found->request, report);
  });
  foundation::Problems warnings = without_unused(*open.project, variant.warnings);
  if (found->sweep.without_model > 0)
    warnings.warning("sweep", fmt::format("designs without a valid model: {}", found->sweep.without_model),
                     "their amplitudes are NaN; the first: " + found->sweep.first_failure, "");
  if (const auto infinite = found->sweep.highest.array().isInf().count(); infinite > 0)
    warnings.warning("sweep", fmt::format("infinite amplitudes: {} of {}", infinite, found->sweep.highest.size()),
                     "an undamped resonance, or a motion without limit at rest, lies in the band",
                     "give a band without it, or damping");
  return study_of(results::sweep_arrays(found->request, found->sweep), found, warnings);
}

double angular_frequency(const std::string& text) {
  const auto value = project::to_si(text, project::Quantity::angular_frequency);
  if (!value) throw foundation::InvalidInput("\"" + text + "\": " + value.error() + "; give rad/s, or \"5 Hz\"");
  return *value;
}

}  // namespace

void bind_studies(nb::module_& module, nb::class_<OpenProject>& of) {
  const auto of_case = nb::arg("case") = "";
  const auto progress = nb::arg("progress") = nb::none();
  of.def("matrices", matrices, of_case, progress);
  of.def("state_space", state_space, nb::arg("of"), nb::arg("quantity") = "displacement", nb::arg("nearest") = false,
         of_case, progress);
  of.def("sweep", sweep, nb::arg("paths"), nb::arg("values"), nb::arg("of"), nb::arg("excitations"), nb::arg("band"),
         nb::arg("quantity"), nb::arg("case"), nb::arg("threads") = 0, progress);
  module.def("angular_frequency", angular_frequency, nb::arg("text"), "A frequency with its unit in rad/s.");
}

}  // namespace trivet::python
