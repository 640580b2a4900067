// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sampled_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/changed_case.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/packed_margins.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

using foundation::InvalidInput;
using foundation::NotComputable;

constexpr auto kernel_lanes = static_cast<Eigen::Index>(SampledCase::kernel_piece);

/// Shares of the numbers of a draw beyond an end of its range. The first is that of bounded numbers: nothing is beyond.
constexpr double no_tail = 0;
constexpr std::array tails = {no_tail, 1e-6, 1e-4, 1e-2};

std::string case_words(const project::Case& variant) {
  return variant.name.empty() ? "" : " in case " + foundation::quoted(variant.name);
}

NotComputable unjudged(const RequirementResult& one, const project::Case& variant) {
  return NotComputable(fmt::format("tolerances: \"{}\"{} cannot be judged: {}", one.words_for_people(variant.display),
                                   case_words(variant), one.reason));
}

/// Why something of a design has no result; empty if it has one.
template <typename Compute>
std::string refused(const Compute& compute) {
  try {
    compute();
    return "";
  } catch (const NotComputable& reason) {
    return reason.what();
  } catch (const InvalidInput& reason) {
    return reason.what();
  }
}

}  // namespace

ToleratedNumbers::ToleratedNumbers(const project::Case& variant, const std::vector<project::Tolerance>& tolerances,
                                   const DrawnDesigns& drawn)
    : tolerances_(tolerances) {
  for (std::size_t t = 0; t < tolerances.size(); ++t)
    for (std::size_t p = 0; p < tolerances[t].places.size(); ++p) {
      const std::string& path = tolerances[t].places[p].path;
      project::ModelNumber number(path, "");
      const auto given = number.read(variant);
      if (!given)
        throw InvalidInput(fmt::format("tolerances: {}: no number at {}{}", foundation::quoted(tolerances[t].name),
                                       foundation::quoted(path), case_words(variant)));
      list_.push_back({std::move(number), *given, t, p, to_index(drawn.draw_of(t, p))});
    }
}

model::System ToleratedNumbers::machine(const project::Case& variant, const Eigen::VectorXd& draws) const {
  project::Design design;
  for (const Number& one : list_)
    design.emplace_back(one.number, tolerances_[one.tolerance].number(one.place, one.given, draws(one.draw)));
  auto changed = judging::changed_system(variant, design);
  if (changed) return std::move(*changed);
  throw NotComputable(foundation::first_reason(changed.error()));
}

bool is_constant(const RequirementResult& result) { return requirement_row(result.kind).slopes == MarginSlopes::zero; }

SampledCase::SampledCase(const project::Case& variant, const std::vector<project::Tolerance>& tolerances,
                         const DrawnDesigns& drawn, const project::SampleRequest& request)
    : case_(variant), numbers_(variant, tolerances, drawn) {
  given_ = results(variant.system);
  for (const RequirementResult& one : given_)
    if (!one.value) throw unjudged(one, variant);
  for (const RequirementResult& one : limits_that_miss_speeds(variant.system, variant.analyses, given_))
    throw unjudged(one, variant);
  if (!request.bands.empty()) bands_.emplace(variant, request);
  no_kernels_ = beyond_kernels();
  if (no_kernels_.empty()) fit(drawn);
}

std::string SampledCase::beyond_kernels() const {
  const bool loads =
      std::ranges::any_of(given_, [](const RequirementResult& one) { return one.kind == RequirementKind::mount_load; });
  for (const model::Element& element : case_.system.elements())
    if (loads && element.rating && std::ranges::any_of(element.rating->load, [](const auto& one) { return !one; }))
      return "a mount has no range in some direction, where only a model shows whether its load is noticeable";
  for (const RequirementResult& one : given_)
    if (requirement_row(one.kind).packed == PackedPart::none && !is_constant(one))
      return fmt::format("\"{}\" has no kernel over many designs", one.words_for_people(case_.display));
  const CaseVector packed(case_, case_.analyses, given_, true);
  return packed.reason().empty() ? not_covered(packed) : packed.reason();
}

std::string SampledCase::not_covered(const CaseVector& packed) const {
  for (std::size_t r = 0; r < given_.size(); ++r)
    if (!packed.covers(r) && !is_constant(given_[r]))
      return fmt::format("\"{}\" is not judged by a kernel here{}{}", given_[r].words_for_people(case_.display),
                         packed.not_covered(r).empty() ? "" : ": ", packed.not_covered(r));
  return "";
}

std::string SampledCase::without_model(const Eigen::VectorXd& draws) const {
  try {
    static_cast<void>(system(draws));
    return "";
  } catch (const NotComputable& reason) {
    return reason.what();
  }
}

std::string SampledCase::set_ranges(const DrawnDesigns& drawn, double tail) {
  from_.resize(to_index(drawn.draws()));
  to_.resize(from_.size());
  Eigen::VectorXd middle(from_.size());
  for (std::size_t d = 0; d < drawn.draws(); ++d) middle(to_index(d)) = numerics::quantile(drawn.distribution(d), 0.5);
  for (std::size_t d = 0; d < drawn.draws(); ++d)
    for (const bool upper : {false, true}) {
      const numerics::Distribution& one = drawn.distribution(d);
      std::string refused = "no range";
      for (const double share : tails) {
        const auto [least, largest] = numerics::ends(one);
        const double last = upper ? largest : least;
        if (share < tail || (share == no_tail && !std::isfinite(last))) continue;
        double& end = (upper ? to_ : from_)(to_index(d));
        end = share == no_tail ? last : numerics::quantile(one, upper ? 1 - share : share);
        Eigen::VectorXd draws = middle;
        draws(to_index(d)) = end;
        refused = without_model(draws);
        if (refused.empty()) break;
      }
      if (!refused.empty()) return fmt::format("{} has no range of valid models: {}", drawn.name(d).words(), refused);
    }
  return "";
}

void SampledCase::fit(const DrawnDesigns& drawn) {
  // Kernels interpolate matrices, also of designs without a model. So they judge ranges whose ends have one, alone and
  // together; designs beyond are assembled.
  for (const double tail : tails) {
    no_kernels_ = set_ranges(drawn, tail);
    if (!no_kernels_.empty()) return;
    DesignNumbers numbers;
    numbers.any_size = true;
    numbers.compared = design::SumFamily::Compared::ends;
    for (std::size_t d = 0; d < drawn.draws(); ++d)
      numbers.variables.push_back({from_(to_index(d)), to_(to_index(d)), drawn.name(d).words()});
    numbers.model = [this](const Eigen::VectorXd& draws) { return system(draws); };
    batch_.emplace(numbers, case_, case_.analyses, given_);
    no_kernels_ = batch_->reason();
    if (no_kernels_.empty()) no_kernels_ = not_covered(batch_->packed());
    if (!no_kernels_.empty()) continue;
    if (bands_) bands_->fit(numbers);
    return;
  }
}

std::vector<RequirementResult> SampledCase::results(const model::System& system,
                                                    const foundation::Progress& interruption) const {
  const CaseContext context(system, interruption);
  foundation::Problems warnings;
  return requirement_values(context, case_.analyses, warnings);
}

void SampledCase::set_margins(const model::System& machine, Eigen::Index design, SampledMargins& into,
                              const foundation::Progress& interruption) const {
  const std::vector<RequirementResult> found = results(machine, interruption);
  for (const RequirementResult& one : found)
    if (!one.value)
      throw NotComputable("\"" + one.words_for_people(case_.display) + "\" cannot be judged: " + one.reason);
  if (found.size() != given_.size()) throw NotComputable("it has other requirements than the given design");
  for (std::size_t r = 0; r < found.size(); ++r) {
    if (std::isnan(found[r].margin))
      throw NotComputable("the margin of \"" + found[r].words_for_people(case_.display) + "\" is not a number");
    into.margins(design, to_index(r)) = found[r].margin;
  }
}

void SampledCase::set_amplitudes(const model::System& machine, Eigen::Index design, SampledMargins& into) const {
  if (!refused([&] { into.amplitudes.col(design) = bands_->amplitudes(machine); }).empty())
    into.amplitudes.col(design).setConstant(std::numeric_limits<double>::quiet_NaN());
}

void SampledCase::assemble(const Eigen::MatrixXd& draws, Eigen::Index design, SampledMargins& into,
                           const foundation::Progress& interruption) const {
  foundation::report_progress(interruption, "", 0);
  std::optional<model::System> machine;
  std::string& failure = into.failures[to_size(design)];
  failure = refused([&] {
    machine.emplace(system(draws.row(design).transpose()));
    set_margins(*machine, design, into, interruption);
  });
  if (!failure.empty()) {
    into.margins.row(design).setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  ++into.one_by_one;
  if (into.amplitudes.rows() > 0) set_amplitudes(*machine, design, into);
}

SampledMargins SampledCase::unfilled(Eigen::Index designs, Eigen::Index amplitudes) const {
  return {.margins = Eigen::ArrayXXd(designs, to_index(given_.size())),
          .failures = std::vector<std::string>(to_size(designs)),
          .amplitudes = Eigen::ArrayXXd::Constant(amplitudes, designs, std::numeric_limits<double>::quiet_NaN())};
}

SampledMargins SampledCase::assembled(const Eigen::MatrixXd& draws, const foundation::Progress& interruption) const {
  SampledMargins found = unfilled(draws.rows(), 0);
  for (Eigen::Index d = 0; d < draws.rows(); ++d) assemble(draws, d, found, interruption);
  return found;
}

void SampledCase::complete_amplitudes(const Eigen::MatrixXd& draws, Eigen::Index design, SampledMargins& into,
                                      const foundation::Progress& interruption) const {
  if (!into.amplitudes.col(design).isNaN().any()) return;
  foundation::report_progress(interruption, "", 0);
  static_cast<void>(refused([&] { set_amplitudes(system(draws.row(design).transpose()), design, into); }));
}

SampledMargins SampledCase::judged(const Eigen::MatrixXd& draws, Eigen::Index amplitudes,
                                   const foundation::Progress& interruption) const {
  SampledMargins found = unfilled(draws.rows(), amplitudes);
  for (Eigen::Index d = 0; d < draws.rows() && !no_kernels_.empty(); ++d) assemble(draws, d, found, interruption);
  for (Eigen::Index first = 0; first < draws.rows() && no_kernels_.empty(); first += kernel_lanes) {
    foundation::report_progress(interruption, "", 0);
    const Eigen::Index count = std::min(kernel_lanes, draws.rows() - first);
    // A design in a tail is judged with the ends of its ranges, and assembled afterwards.
    Eigen::MatrixXd inside = draws.middleRows(first, count);
    for (Eigen::Index d = 0; d < count; ++d)
      inside.row(d) = inside.row(d).array().max(from_.transpose()).min(to_.transpose()).matrix();
    found.margins.middleRows(first, count) = packed_margins(batch_->packed(), batch_->family().designs(inside));
    if (amplitudes > 0 && bands_->no_kernels().empty())
      found.amplitudes.middleCols(first, count) = bands_->amplitudes(inside);
    for (std::size_t r = 0; r < given_.size(); ++r)
      if (is_constant(given_[r])) found.margins.col(to_index(r)).segment(first, count).setConstant(given_[r].margin);
    for (Eigen::Index d = 0; d < count; ++d) {
      const bool proven =
          (inside.row(d).array() == draws.row(first + d).array()).all() && !found.margins.row(first + d).isNaN().any();
      if (!proven) {
        assemble(draws, first + d, found, interruption);
        continue;
      }
      ++found.in_kernels;
      complete_amplitudes(draws, first + d, found, interruption);
    }
  }
  return found;
}

}  // namespace trivet::study
