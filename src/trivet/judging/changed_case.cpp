// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/changed_case.h"

#include <optional>
#include <utility>

#include "trivet/judging/checked_case.h"
#include "trivet/judging/rest_checks.h"
#include "trivet/project/read_case.h"
#include "trivet/project/text/changes.h"

namespace trivet::judging {
namespace {

using project::Case;
using project::Node;

std::optional<Case> read_changed(const Case& variant, const std::vector<Node>& changes, foundation::Problems& problems,
                                 bool may_fall = false) {
  Node document = project::without_analyses(variant.written);
  for (const Node& change : changes) project::apply_changes(document, change, "", problems);
  const project::KnownModel known{variant.document, variant.system.description()};
  auto read = project::read_case(std::move(document), variant.name, problems, &known);
  auto changed = read ? checked_case(std::move(*read), {}, nullptr, problems) : std::nullopt;
  if (changed && !may_fall) problems.add(standing_problems(*changed, assembly::AssembledOnce(changed->system)));
  return problems.has_errors() ? std::nullopt : std::move(changed);
}

}  // namespace

foundation::Expected<model::System> changed_system(const Case& variant, const std::vector<Node>& changes,
                                                   bool may_fall) {
  foundation::Problems problems;
  auto changed = read_changed(variant, changes, problems, may_fall);
  if (changed) return std::move(changed->system);
  return tl::make_unexpected(std::move(problems));
}

foundation::Expected<Case> changed_case(const Case& variant, const std::vector<Node>& changes) {
  foundation::Problems problems;
  auto changed = read_changed(variant, changes, problems);
  if (!changed) return tl::make_unexpected(std::move(problems));
  changed->analyses = variant.analyses;
  changed->warnings = variant.warnings;
  return std::move(*changed);
}

foundation::Expected<model::System> changed_system(const Case& variant, const project::Design& design) {
  std::vector<Node> changes;
  for (const auto& [number, value] : design) changes.push_back(number.change(value));
  return changed_system(variant, changes);
}

}  // namespace trivet::judging
