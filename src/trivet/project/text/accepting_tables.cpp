// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/accepting_tables.h"

#include <algorithm>
#include <iterator>

namespace trivet::project {

bool may_accept(const std::string& path) {
  if (std::find(std::begin(accepting_tables), std::end(accepting_tables), path) != std::end(accepting_tables))
    return true;
  const std::size_t dot = path.find('.');
  return dot != std::string::npos && path.find('.', dot + 1) == std::string::npos &&
      std::find(std::begin(holders_of_accepting_tables), std::end(holders_of_accepting_tables), path.substr(0, dot)) !=
      std::end(holders_of_accepting_tables);
}

}  // namespace trivet::project
