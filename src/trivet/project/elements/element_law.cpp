// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/element_law.h"

#include <algorithm>
#include <string_view>

namespace trivet::project {

bool ElementLaw::is(const std::string& word) const {
  const std::string_view name = type;
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? word == name : word.starts_with(name.substr(0, colon + 1));
}

const std::vector<const ElementLaw*>& element_laws() {
#define TRIVET_LAW(name) &name##_law,
  static const std::vector<const ElementLaw*> list = {TRIVET_ELEMENT_LAWS(TRIVET_LAW)};
#undef TRIVET_LAW
  return list;
}

const ElementLaw* element_law(const std::string& type) {
  const auto& list = element_laws();
  const auto found = std::ranges::find_if(list, [&](const ElementLaw* law) { return law->is(type); });
  return found == list.end() ? nullptr : *found;
}

}  // namespace trivet::project
