// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/symmetric_entries.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace trivet::numerics {

std::vector<SymmetricEntry> symmetric_entries(const DynamicMatrices& m, const Eigen::VectorXd& d) {
  assert(m.symmetric && d.size() == m.size() && "the lower triangle stands for both");
  const bool lossy = m.lossy();
  std::vector<SymmetricEntry> entries;
  for (Eigen::Index j = 0; j < m.size(); ++j)
    for (Eigen::Index i = j; i < m.size(); ++i) {
      const double a = m.A(i, j), b = m.B(i, j), k = m.K(i, j), loss = lossy ? m.K_loss(i, j) : 0.0;
      if (a != 0 || b != 0 || k != 0 || loss != 0) {
        const double scale = d(i) * d(j);
        entries.push_back({i, j, scale * a, scale * b, scale * k, scale * loss});
      }
    }
  return entries;
}

void add_free(const std::vector<FreeEntry>& free, std::vector<SymmetricEntry>& entries) {
  const auto place = [](const SymmetricEntry& e) { return std::tuple(e.column, e.row); };
  const auto before = [&](const SymmetricEntry& a, const SymmetricEntry& b) { return place(a) < place(b); };
  std::vector<SymmetricEntry> missing;
  for (std::size_t k = 0; k < free.size(); ++k) {
    SymmetricEntry entry{std::max(free[k].row, free[k].column), std::min(free[k].row, free[k].column)};
    entry.free = static_cast<int>(k);
    const auto found = std::lower_bound(entries.begin(), entries.end(), entry, before);
    if (found != entries.end() && place(*found) == place(entry)) found->free = entry.free;
    else missing.push_back(entry);
  }
  const auto old = static_cast<std::ptrdiff_t>(entries.size());
  std::ranges::sort(missing, before);
  entries.insert(entries.end(), missing.begin(), missing.end());
  std::inplace_merge(entries.begin(), entries.begin() + old, entries.end(), before);
  assert(std::ranges::adjacent_find(entries,
                                    [&](const SymmetricEntry& a, const SymmetricEntry& b) { return !before(a, b); }) ==
             entries.end() &&
         "column by column, each place once");
}

}  // namespace trivet::numerics
