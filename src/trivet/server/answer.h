// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/server/request_rules.h"

namespace trivet::server {

/// What is sent in reply to a request.
struct Answer {
  int status = 200;
  std::string body = {};
  std::string_view file = {};  ///< in place of `body`: a file of the page, which lives as long as the program
  std::string type = "application/json";
  std::string allow = {};

  [[nodiscard]] std::string_view content() const { return file.empty() ? std::string_view(body) : file; }
};

/// {"error": sentence}
[[nodiscard]] Answer error_answer(int status, const std::string& sentence);
[[nodiscard]] Answer refusal_answer(const Refusal& refusal);

/// Status line and header fields, with those that keep other pages out, up to the empty line.
[[nodiscard]] std::string head_of(const Answer& answer, bool keeps_alive);

}  // namespace trivet::server
