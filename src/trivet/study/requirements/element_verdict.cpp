// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/element_verdict.h"

#include <optional>
#include <string>

namespace trivet::study {
namespace {

/// Is it of the element itself, or of one of its results: "front left", "front left.deflection.z"? Names have no dots.
bool judges(const RequirementResult& result, const std::string& element) {
  return result.subject == element || result.subject.starts_with(element + ".");
}

}  // namespace

std::vector<ElementVerdict> element_verdicts(const model::System& system,
                                             const std::vector<RequirementResult>& results) {
  std::vector<ElementVerdict> list;
  for (const model::Element& element : system.elements()) {
    std::optional<std::size_t> least;
    for (std::size_t r = 0; r < results.size(); ++r)
      if (results[r].value && judges(results[r], element.name) &&
          (!least || results[r].margin < results[*least].margin))
        least = r;
    if (least) list.push_back({element.name, *least, 1 / results[*least].margin});
  }
  return list;
}

}  // namespace trivet::study
