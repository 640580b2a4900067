// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/page/shown_case.h"

/// What the short form of a report consists of, and the first page of the full one begins with.
namespace trivet::report {

/// The operating speeds in one sentence each: motion, force on the ground, isolation and nearest mode, in all cases.
[[nodiscard]] std::string speeds_part(const std::vector<ShownCase>& cases);

/// The drawing of a machine in an element that scrolls; on narrow screens its views are below each other and fit.
[[nodiscard]] std::string drawing_part(const project::Case& machine, const std::string& label);

/// The machine as its drawing and the table of its mounts show it.
[[nodiscard]] std::string machine_part(const project::Project& project);

/// Curves of all cases. @param picture  as SVG
[[nodiscard]] std::string overview_part(const std::string& picture, bool is_short);

/// Table of the modes, their pictures, and, if `folded`, what opens by a click.
[[nodiscard]] std::string modes_part(const ShownCase& shown, const std::string& title, bool folded);

/// Modes and operating speeds of the base model for the short form, which has no scripts and so nothing that opens by
/// a click.
[[nodiscard]] std::string short_results(const std::vector<ShownCase>& cases);

}  // namespace trivet::report
