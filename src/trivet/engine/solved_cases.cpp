// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/solved_cases.h"

#include <algorithm>

namespace trivet::engine {
namespace {

constexpr double most_bytes = 256e6;

/// Some 30 matrices of numbers: mass, damping, stiffness, shapes and their shares, complex roots of twice the size.
double bytes_of(const study::SolvedCase& solved) {
  constexpr double matrices = 30;
  const auto size = static_cast<double>(solved.assembled.matrices.size());
  return matrices * size * size * sizeof(double);
}

}  // namespace

std::shared_ptr<const study::SolvedCase> SolvedCases::of(const project::Case& variant) {
  const auto found = [&] { return std::ranges::find(kept_, &variant, &Kept::variant); };
  {
    const std::lock_guard guard(lock_);
    if (const auto kept = found(); kept != kept_.end()) return kept->solved;
  }
  auto solved = std::make_shared<const study::SolvedCase>(variant.system);  // outside the lock: others may go on
  const std::lock_guard guard(lock_);
  if (const auto kept = found(); kept != kept_.end()) return kept->solved;  // another thread was faster
  if (bytes_ + bytes_of(*solved) <= most_bytes) {
    bytes_ += bytes_of(*solved);
    kept_.push_back({&variant, solved});
  }
  return solved;
}

}  // namespace trivet::engine
