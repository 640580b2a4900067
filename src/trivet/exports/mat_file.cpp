// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/mat_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "trivet/exports/unique_names.h"

namespace trivet::exports {
namespace {

// Types of data and classes of variables.
constexpr std::uint32_t of_int8 = 1, of_int32 = 5, of_uint32 = 6, of_double = 9, of_variable = 14, of_utf16 = 17;
constexpr std::uint32_t cell_class = 1, structure_class = 2, character_class = 4, double_class = 6, is_complex = 0x800;
constexpr std::size_t granule = 8;  ///< bytes; every element starts at a multiple

template <typename T>
MatBytes bytes_of(const T* values, std::size_t count) {
  MatBytes bytes(count * sizeof(T), '\0');
  if (count > 0) std::memcpy(bytes.data(), values, bytes.size());
  return bytes;
}

/// A tag of the type and the number of bytes, the bytes, and zeros up to the next granule.
MatBytes element(std::uint32_t type, const MatBytes& data) {
  const std::array<std::uint32_t, 2> tag = {type, static_cast<std::uint32_t>(data.size())};
  MatBytes bytes = bytes_of(tag.data(), tag.size()) + data;
  bytes.resize((bytes.size() + granule - 1) / granule * granule, '\0');
  return bytes;
}

MatBytes variable(std::uint32_t kind, const std::string& name, const MatSizes& sizes, const MatBytes& content) {
  const std::array<std::uint32_t, 2> flags = {kind, 0};
  const std::vector<std::int32_t> dimensions(sizes.begin(), sizes.end());
  return element(of_variable,
                 element(of_uint32, bytes_of(flags.data(), flags.size())) +
                     element(of_int32, bytes_of(dimensions.data(), dimensions.size())) + element(of_int8, name) +
                     content);
}

MatBytes doubles(const std::vector<double>& numbers) {
  return element(of_double, bytes_of(numbers.data(), numbers.size()));
}

}  // namespace

MatBytes mat_header(const std::string& description) {
  constexpr std::size_t words = 116, subsystem = 8;
  constexpr std::uint16_t version = 0x0100, byte_order = 'M' << 8 | 'I';  // readers see whether it is swapped
  MatBytes header = description.substr(0, words);
  header.resize(words, ' ');
  header.append(subsystem, '\0');
  return header + bytes_of(&version, 1) + bytes_of(&byte_order, 1);
}

MatBytes mat_real(const std::string& name, const MatSizes& sizes, const std::vector<double>& numbers) {
  return variable(double_class, name, sizes, doubles(numbers));
}

MatBytes mat_complex(const std::string& name, const MatSizes& sizes, const std::vector<std::complex<double>>& numbers) {
  std::vector<double> real, imaginary;
  for (const std::complex<double>& number : numbers) {
    real.push_back(number.real());
    imaginary.push_back(number.imag());
  }
  return variable(double_class | is_complex, name, sizes, doubles(real) + doubles(imaginary));
}

MatBytes mat_text(const std::string& name, const std::string& words) {
  const std::u16string units = utf16(words);
  return variable(character_class, name, {units.empty() ? std::size_t{0} : 1, units.size()},
                  element(of_utf16, bytes_of(units.data(), units.size())));
}

MatBytes mat_texts(const std::string& name, const std::vector<std::string>& texts) {
  MatBytes cells;
  for (const std::string& text : texts) cells += mat_text("", text);
  return variable(cell_class, name, {texts.size(), 1}, cells);
}

MatBytes mat_structure(const std::string& name, const std::vector<std::pair<std::string, MatBytes>>& fields) {
  constexpr std::int32_t name_size = 64;  // with the zero at its end
  MatBytes names, values;
  for (const auto& [field, value] : fields) {
    std::string padded = field.substr(0, name_size - 1);
    padded.resize(name_size, '\0');
    names += padded;
    values += value;
  }
  // The size of a name must lie in its tag: two bytes of type, two of size, and the number.
  const std::array<std::uint32_t, 2> size_of_names = {of_int32 | 4u << 16, name_size};
  return variable(structure_class, name, {1, 1},
                  bytes_of(size_of_names.data(), size_of_names.size()) + element(of_int8, names) + values);
}

}  // namespace trivet::exports
