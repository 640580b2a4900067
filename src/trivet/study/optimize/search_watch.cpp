// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/search_watch.h"

#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/interruption.h"
#include "trivet/foundation/stored_words.h"
#include "trivet/study/optimize/design_search.h"

namespace trivet::study {

using numerics::MaxMinPoint;
using numerics::MaxMinProblem;

MaxMinProblem SearchWatch::over(MaxMinProblem problem) {
  if (best_) before_ = std::exchange(best_, std::nullopt);
  if (!enough_) return problem;
  MaxMinProblem watched = problem;
  watched.evaluate = [this, inner = std::move(problem)](const Eigen::VectorXd& x, Eigen::VectorXd& values,
                                                        Eigen::MatrixXd* slopes) {
    if (enough_()) {
      has_ended_ = true;
      throw foundation::Interrupted();
    }
    inner.evaluate(x, values, slopes);
    if ((x.array() < 0).any() || (x.array() > 1).any()) return;
    note(numerics::point_with(inner, x, values));
  };
  return watched;
}

void SearchWatch::note(MaxMinPoint here) {
  const std::lock_guard lock(noting_);
  if (!best_ || rank(here) > rank(*best_)) best_ = std::move(here);
}

std::vector<Eigen::VectorXd> SearchWatch::best() const {
  std::vector<Eigen::VectorXd> found;
  if (best_) found.push_back(best_->x);
  if (before_ && !(best_ && best_->x == before_->x)) found.push_back(before_->x);
  return found;
}

std::string CountedPoint::text() const {
  foundation::StoredWords words;
  for (const double share : point.x) words.exact(share);
  words.exact(point.objective);
  words.exact(point.constraint);
  counts.store(words);
  return words.words();
}

CountedPoint CountedPoint::restored(const std::string& text, Eigen::Index variables) {
  foundation::WordReader words(text);
  CountedPoint found;
  found.point.x.resize(variables);
  for (double& share : found.point.x) share = words.exact();
  found.point.objective = words.exact();
  found.point.constraint = words.exact();
  found.counts = EvaluationCounts::restored(words);
  words.end();
  return found;
}

}  // namespace trivet::study
