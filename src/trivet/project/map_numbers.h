// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/document.h"

namespace trivet::project {

/// Reads a model without its questions and returns its problems.
using ReadModel = std::function<foundation::Problems(const Node& model)>;

/// The document without its questions and cases.
[[nodiscard]] Node without_questions(Node document);

/// Reports a number of a map that no design can have (a second law of damping, a unit of another quantity): the model
/// cannot be read with it at the ends or the middle of its range, at 1, or together with the other number.
void check_map_numbers(const Node& document, const MapRequest& map, const ReadModel& read,
                       foundation::Problems& problems);

/// The same of [parameters.NAME], each alone.
void check_parameters(const Node& document, const std::vector<DesignAxis>& parameters, const ReadModel& read,
                      foundation::Problems& problems);

}  // namespace trivet::project
