// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "trivet/numerics/search/max_min.h"
#include "trivet/study/optimize/evaluation_counts.h"

namespace trivet::study {

/// Notes the best point of a search, and ends it when there is enough.
class SearchWatch {
 public:
  explicit SearchWatch(std::function<bool()> enough) : enough_(std::move(enough)) {}

  /// The same problem under watch; the best point of another one is only a fallback: its rank is not comparable.
  [[nodiscard]] numerics::MaxMinProblem over(numerics::MaxMinProblem problem);
  /// A point of the current problem. May be called on any thread.
  void note(numerics::MaxMinPoint here);

  [[nodiscard]] bool has_ended() const { return has_ended_; }
  /// The best points of the current problem and of the one before; empty if no point is judged.
  [[nodiscard]] std::vector<Eigen::VectorXd> best() const;

 private:
  std::function<bool()> enough_;
  std::atomic<bool> has_ended_ = false;
  std::mutex noting_;
  std::optional<numerics::MaxMinPoint> best_, before_;
};

/// A point that a search found, with the designs judged for it.
struct CountedPoint {
  numerics::MaxMinPoint point;
  EvaluationCounts counts;

  [[nodiscard]] std::string text() const;
  /// @throws foundation::DamagedText
  [[nodiscard]] static CountedPoint restored(const std::string& text, Eigen::Index variables);
};

}  // namespace trivet::study
