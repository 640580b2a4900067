// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/display_units.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/known_model.h"

/// Reading ends here: at the checked description of one case. Nothing is solved; that is for the layer judging.
namespace trivet::project {

/// One variant of a document as it was read.
struct ReadCase {
  std::string name;
  std::string title;                    ///< of the file
  Node written;                         ///< the file with the changes applied
  Node document;                        ///< `written` with the element types merged in: the input of the model
  std::optional<model::System> system;  ///< undeformed, if its parts are nonlinear; none if the description has errors
  std::vector<model::Body> bodies;      ///< of the description, also with errors
  bool has_every_part = false;          ///< every body and element of the file is in the description
  Analyses analyses;
  DisplayUnits display;
  foundation::Problems of_text;   ///< of keys and values
  foundation::Problems of_model;  ///< of the description that they give, as far as they are not the cause
};

/// Reads a document; none, with `problems`, if its format is not known.
[[nodiscard]] std::optional<ReadCase> read_case(Node written, const std::string& name, foundation::Problems& problems,
                                                const KnownModel* known = nullptr);

/// The document without its analyses and cases.
[[nodiscard]] Node without_analyses(Node document);

}  // namespace trivet::project
