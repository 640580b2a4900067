// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace trivet::documents {

/// A list of real or complex numbers that belong to a result: a view without a copy, except of temporary ones.
class Numbers {
 public:
  Numbers() = default;  ///< no list, which is not the same as an empty one
  Numbers(const std::vector<double>& list) : Numbers(list.data(), list.size()) {}
  Numbers(std::vector<double>&& list) : Numbers(kept(std::move(list))) {}
  template <typename Number, int size>
  Numbers(const Eigen::Matrix<Number, size, 1>& list) : Numbers(list.data(), static_cast<std::size_t>(list.size())) {}
  template <typename Number, int size>
  Numbers(Eigen::Matrix<Number, size, 1>&& list) : Numbers(kept(std::move(list))) {}
  template <typename Number>
  Numbers(const Number* first, std::size_t size, std::ptrdiff_t stride = 1)
      : exists_(true), first_(first), size_(size), stride_(stride) {}
  /// A member of every row of a list.
  template <typename Row>
  Numbers(const std::vector<Row>& rows, double Row::* member)
      : Numbers(rows.empty() ? nullptr : &(rows.front().*member), rows.size(),
                static_cast<std::ptrdiff_t>(sizeof(Row) / sizeof(double))) {
    static_assert(sizeof(Row) % sizeof(double) == 0);
  }
  /// A row of a matrix.
  [[nodiscard]] static Numbers row(const Eigen::MatrixXd& matrix, std::size_t row) {
    return {matrix.data() + row, static_cast<std::size_t>(matrix.cols()), matrix.rows()};
  }

  [[nodiscard]] bool exists() const { return exists_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }
  [[nodiscard]] bool is_complex() const { return std::holds_alternative<const std::complex<double>*>(first_); }
  [[nodiscard]] const std::variant<const double*, const std::complex<double>*>& first() const { return first_; }
  [[nodiscard]] const std::shared_ptr<const void>& owner() const { return owner_; }
  [[nodiscard]] std::complex<double> operator[](std::size_t i) const {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * stride_;
    if (is_complex()) return std::get<const std::complex<double>*>(first_)[at];
    return std::get<const double*>(first_)[at];
  }

 private:
  template <typename List>
  static Numbers kept(List&& list) {
    const auto own = std::make_shared<const std::decay_t<List>>(std::forward<List>(list));
    Numbers numbers(*own);
    numbers.owner_ = own;
    return numbers;
  }

  bool exists_ = false;
  std::variant<const double*, const std::complex<double>*> first_ = static_cast<const double*>(nullptr);
  std::size_t size_ = 0;
  std::ptrdiff_t stride_ = 1;
  std::shared_ptr<const void> owner_;
};

}  // namespace trivet::documents
