// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/labelled_arrays.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "trivet/foundation/index.h"

namespace trivet::documents {
namespace {

using Complex = std::complex<double>;

std::vector<std::ptrdiff_t> last_axis_fastest(const std::vector<std::size_t>& shape) {
  std::vector<std::ptrdiff_t> strides(shape.size(), 1);
  for (std::size_t i = shape.size(); i-- > 1;) strides[i - 1] = strides[i] * static_cast<std::ptrdiff_t>(shape[i]);
  return strides;
}

template <typename T>
void gather(const LabelledArray& array, std::size_t axis, const T* from, std::vector<T>& to) {
  if (axis == array.shape.size()) {
    to.push_back(*from);
    return;
  }
  for (std::size_t i = 0; i < array.shape[axis]; ++i)
    gather(array, axis + 1, from + static_cast<std::ptrdiff_t>(i) * array.strides[axis], to);
}

template <typename T>
std::vector<T> gathered(const LabelledArray& array) {
  std::vector<T> numbers;
  numbers.reserve(array.size());
  if (array.size() > 0) gather(array, 0, std::get<const T*>(array.values), numbers);
  return numbers;
}

template <typename Vector>
LabelledArray of_vector(std::string name, std::string unit, std::string axis, const Vector& numbers) {
  return {std::move(name), std::move(unit), {std::move(axis)}, {static_cast<std::size_t>(numbers.size())}, {1},
          numbers.data()};
}

template <typename Matrix>
LabelledArray of_matrix(std::string name, std::string unit, std::pair<std::string, std::string> axes,
                        const Matrix& numbers) {
  return {std::move(name),
          std::move(unit),
          {std::move(axes.first), std::move(axes.second)},
          {to_size(numbers.rows()), to_size(numbers.cols())},
          {1, numbers.rows()},
          numbers.data()};
}

/// The same array with numbers of its own.
template <typename Make, typename Axes, typename Numbers>
LabelledArray owned(const Make& make, std::string name, std::string unit, Axes axes, Numbers numbers) {
  const auto kept = std::make_shared<const Numbers>(std::move(numbers));
  LabelledArray array = make(std::move(name), std::move(unit), std::move(axes), *kept);
  array.owner = kept;
  return array;
}

template <typename T>
LabelledArray owned_rows(std::string name, std::string unit, std::vector<std::string> axes,
                         std::vector<std::size_t> shape, std::vector<T> numbers) {
  const auto kept = std::make_shared<const std::vector<T>>(std::move(numbers));
  std::vector<std::ptrdiff_t> strides = last_axis_fastest(shape);
  return {std::move(name), std::move(unit), std::move(axes), std::move(shape), std::move(strides), kept->data(), kept};
}

}  // namespace

std::size_t LabelledArray::size() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<double> LabelledArray::real_numbers() const { return gathered<double>(*this); }
std::vector<Complex> LabelledArray::complex_numbers() const { return gathered<Complex>(*this); }

const LabelledArray* LabelledArrays::find(const std::string& name) const {
  const auto found = std::ranges::find(list_, name, &LabelledArray::name);
  return found == list_.end() ? nullptr : &*found;
}

void LabelledArrays::view(std::string name, std::string unit, std::string axis, const std::vector<double>& numbers) {
  add(of_vector(std::move(name), std::move(unit), std::move(axis), numbers));
}
void LabelledArrays::view(std::string name, std::string unit, std::string axis, const Eigen::VectorXd& numbers) {
  add(of_vector(std::move(name), std::move(unit), std::move(axis), numbers));
}
void LabelledArrays::view(std::string name, std::string unit, std::string axis, const Eigen::VectorXcd& numbers) {
  add(of_vector(std::move(name), std::move(unit), std::move(axis), numbers));
}
void LabelledArrays::view(std::string name, std::string unit, std::pair<std::string, std::string> axes,
                          const Eigen::MatrixXd& numbers) {
  add(of_matrix(std::move(name), std::move(unit), std::move(axes), numbers));
}
void LabelledArrays::view(std::string name, std::string unit, std::pair<std::string, std::string> axes,
                          const Eigen::MatrixXcd& numbers) {
  add(of_matrix(std::move(name), std::move(unit), std::move(axes), numbers));
}

void LabelledArrays::texts(std::string name, std::string axis, std::vector<std::string> list) {
  const std::size_t size = list.size();
  add({std::move(name), "", {std::move(axis)}, {size}, {1}, std::move(list)});
}

void LabelledArrays::copy(std::string name, std::string unit, std::string axis, std::vector<double> numbers) {
  add(owned(of_vector<std::vector<double>>, std::move(name), std::move(unit), std::move(axis), std::move(numbers)));
}
void LabelledArrays::copy(std::string name, std::string unit, std::string axis, Eigen::VectorXcd numbers) {
  add(owned(of_vector<Eigen::VectorXcd>, std::move(name), std::move(unit), std::move(axis), std::move(numbers)));
}
void LabelledArrays::copy(std::string name, std::string unit, std::pair<std::string, std::string> axes,
                          Eigen::MatrixXd numbers) {
  add(owned(of_matrix<Eigen::MatrixXd>, std::move(name), std::move(unit), std::move(axes), std::move(numbers)));
}
void LabelledArrays::copy(std::string name, std::string unit, std::pair<std::string, std::string> axes,
                          Eigen::MatrixXcd numbers) {
  add(owned(of_matrix<Eigen::MatrixXcd>, std::move(name), std::move(unit), std::move(axes), std::move(numbers)));
}

void LabelledArrays::value(std::string name, std::string unit, double number) {
  copy(std::move(name), std::move(unit), std::vector<std::string>{}, {}, std::vector<double>{number});
}

void LabelledArrays::copy(std::string name, std::string unit, std::vector<std::string> axes,
                          std::vector<std::size_t> shape, std::vector<double> numbers) {
  add(owned_rows(std::move(name), std::move(unit), std::move(axes), std::move(shape), std::move(numbers)));
}
void LabelledArrays::copy(std::string name, std::string unit, std::vector<std::string> axes,
                          std::vector<std::size_t> shape, std::vector<Complex> numbers) {
  add(owned_rows(std::move(name), std::move(unit), std::move(axes), std::move(shape), std::move(numbers)));
}

void LabelledArrays::mark_harmonic(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto found =
        std::find_if(list_.rbegin(), list_.rend(), [&](const LabelledArray& a) { return a.name == name; });
    assert(found != list_.rend());
    found->harmonic = true;
  }
}

void LabelledArrays::count(std::string axis, std::size_t count) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 1.0);
  std::string name = axis;
  copy(std::move(name), "1", std::move(axis), std::move(numbers));
}

}  // namespace trivet::documents
