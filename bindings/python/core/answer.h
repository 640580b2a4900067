// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/text/shown_units.h"
#include "trivet/results/labelled_arrays.h"

namespace trivet::python {

/// What one command found, in all its forms. Texts are made when they are wanted.
struct Answer {
  std::string question;   ///< name of the command
  std::string case_name;  ///< empty: the base model, or all cases
  std::string title;      ///< of the project
  foundation::Problems warnings;
  std::vector<std::string> notes;     ///< free motions, directions that are left out
  std::vector<std::string> failures;  ///< parts that could not be computed, with the reason
  std::vector<std::string> changes;   ///< of the best design: "elements.mount.scale = 1.5"
  std::function<std::string()> json, text;
  /// The text with the units of another [display]; empty: it has no units that can change.
  std::function<std::string(const project::ShownUnits& display)> text_in;
  std::vector<std::pair<std::string, std::function<std::string()>>> tables = {};   ///< "random.csv", CSV
  std::vector<std::pair<std::string, std::function<std::string()>>> figures = {};  ///< "front.svg", SVG
  results::LabelledArrays arrays = {};
  std::shared_ptr<const void> held = {};  ///< what the arrays refer to
};

void bind_answer(nanobind::module_& module);

using ArrayList = nanobind::typed<
    nanobind::list,
    nanobind::typed<nanobind::tuple, nanobind::str, nanobind::str,
                    nanobind::typed<nanobind::tuple, nanobind::str, nanobind::ellipsis>, nanobind::any>>;

/// (name, unit, axes, numbers or texts) of each array; numbers are read-only views that keep `held` alive.
[[nodiscard]] ArrayList python_arrays(const results::LabelledArrays& arrays, const std::shared_ptr<const void>& held);

}  // namespace trivet::python
