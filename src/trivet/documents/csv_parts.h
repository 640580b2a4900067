// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/documents/document.h"

/// What the forms of a table in a file share.
namespace trivet::documents {

/// The table or curves with this file name. @throws foundation::InvalidInput if there is none
[[nodiscard]] const Part& part_with_file(const Document& document, const std::string& file);

/// "machine.z re [m]": name and unit; a heading without brackets has no unit.
struct HeadingParts {
  std::string name, unit;
};
[[nodiscard]] HeadingParts parts_of(const std::string& heading);

}  // namespace trivet::documents
