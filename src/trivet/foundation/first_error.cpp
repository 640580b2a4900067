// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/first_error.h"

#include <algorithm>
#include <cassert>

#include "trivet/foundation/invalid_input.h"

namespace trivet::foundation {

const Problem* first_error(const Problems& problems) {
  const auto first = std::ranges::find(problems.list(), Severity::error, &Problem::severity);
  return first == problems.list().end() ? nullptr : &*first;
}

const Problem& error_of(const Problems& problems) {
  const Problem* first = first_error(problems);
  assert(first);
  return *first;
}

std::string first_message(const Problems& problems) {
  const Problem* first = first_error(problems);
  return first ? message(*first) : "";
}

std::string first_reason(const Problems& problems) {
  const Problem& first = error_of(problems);
  return first.subject + ": " + first.finding + "; " + first.rule;
}

void refuse_errors(const Problems& problems) {
  if (const Problem* first = first_error(problems)) throw InvalidInput(message(*first));
}

}  // namespace trivet::foundation
