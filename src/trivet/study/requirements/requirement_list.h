// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// What a requirement on a curve judges: a result over frequency, and what drives it.
struct RequirementCurve {
  assembly::Channel channel;
  assembly::Loading loading;
};

/// The result named by its subject under its excitations, or its transmissibility.
[[nodiscard]] RequirementCurve requirement_curve(const model::System& system, const assembly::Assembled& assembled,
                                                 const RequirementResult& result);

/// True if two requirements have the same loading and band, so that one search finds the peaks of both.
[[nodiscard]] bool have_same_drive(const RequirementResult& a, const RequirementResult& b);

/// Requirements of a case that are being judged, in their order.
class RequirementList {
 public:
  RequirementResult& add(RequirementKind kind, const std::string& subject, RequirementWords words,
                         const std::string& unit, double allowed);
  /// Bounds of single results, all with the same kind and words: "NAME ≤ 0.5 mm".
  void add_bounds(const CaseContext& context, RequirementKind kind, const std::vector<project::AmplitudeLimit>& limits,
                  const std::string& of);
  /// Adds requirements that are judged already.
  void append(std::vector<RequirementResult> judged);

  /// Computes values of results from `first` on; if that is impossible, these have the reason.
  void attempt(std::size_t first, const std::function<void()>& compute);
  /// The same for results at some places.
  void attempt(const std::vector<std::size_t>& places, const std::function<void()>& compute);

  [[nodiscard]] std::size_t size() const { return results_.size(); }
  [[nodiscard]] RequirementResult& operator[](std::size_t i) { return results_[i]; }
  [[nodiscard]] std::vector<RequirementResult> release() { return std::move(results_); }

 private:
  std::vector<RequirementResult> results_;
};

}  // namespace trivet::study
