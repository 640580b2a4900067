// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::report {

/// A page of one result. @param remarks  warnings and notes, a line each
/// @param tables  HTML
[[nodiscard]] std::string result_page(const std::string& title, const std::string& remarks, const std::string& tables);

}  // namespace trivet::report
