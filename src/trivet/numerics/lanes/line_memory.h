// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace trivet::numerics {

/// Numbers in the widest pack.
inline constexpr std::ptrdiff_t longest_pack = 8;

/// Uninitialised numbers aligned to a cache line: packs that cross a line are stored at half the speed.
class LineMemory {
 public:
  /// Keeps the memory and its contents if the size is unchanged.
  void resize(std::size_t size) {
    if (size == size_) return;
    numbers_.reset(size > 0 ? new (line) double[size] : nullptr);
    size_ = size;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double* data() const { return numbers_.get(); }

 private:
  static constexpr std::align_val_t line{64};
  struct Release {
    void operator()(double* numbers) const { ::operator delete[](numbers, line); }
  };
  std::unique_ptr<double[], Release> numbers_;
  std::size_t size_ = 0;
};

}  // namespace trivet::numerics
