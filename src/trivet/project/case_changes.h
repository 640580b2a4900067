// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Is this a setting of a number of a case: cases.NAME.… = …?
[[nodiscard]] bool is_of_case(const Node& setting);

/// Adds settings of cases to the changes of these cases in a document; an unknown case is a problem, and other settings
/// are ignored.
void change_cases(Node& document, const std::vector<Node>& settings, foundation::Problems& problems);

/// The changes `first` and then `second` as one: values of both, those of `second` in place of the same ones of
/// `first`.
[[nodiscard]] Node merged_changes(Node first, const Node& second);

/// The text of a project file with a further case at its end: the changes of the case `like` (empty: none, the base
/// model), and these settings; all else stays. The result was parsed again and has exactly this case more. All problems
/// at once: a name that is empty or not new, an unknown case, settings that cannot be read.
/// @param source  of the text, in messages
[[nodiscard]] foundation::Expected<std::string> text_with_case(const std::string& text, const std::string& source,
                                                               const std::string& name, const std::string& like,
                                                               const std::vector<std::string>& settings);

}  // namespace trivet::project
