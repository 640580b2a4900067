// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/foundation/problems.h"
#include "trivet/model/system.h"
#include "trivet/project/text/document.h"

namespace trivet::project {

/// A case that was read earlier: parts that another document has in common with it need not be read again.
struct KnownModel {
  const Node& document;
  const model::Description& description;
  /// Of reading it. Parts with warnings or a catalogue and elements with nonlinear laws are then read again, so that
  /// all is as if no part were known. Null if warnings, and the position of rest from which a machine settles, do not
  /// matter.
  const foundation::Problems* of_text = nullptr;

  /// The part of this name in a table ("bodies", "elements"), if it is the same in both documents and has no
  /// adjustments, which change the description later.
  [[nodiscard]] const Node* unchanged(const char* table, const std::string& name, const Node& now) const;
};

}  // namespace trivet::project
