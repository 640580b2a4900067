// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <complex>
#include <optional>
#include <utility>

#include "trivet/assembly/loads.h"
#include "trivet/exports/format_table.h"
#include "trivet/exports/mat_file.h"
#include "trivet/exports/unique_names.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/project/input_files.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/study/explain/linear_system.h"

/// MATLAB files of version 5: a structure for each group, "about" with names, units and axes, and "check": exact
/// displacements at some frequencies, which NAME_check.m computes again from A, B, K and the load by backslash.
namespace trivet::exports {
namespace {

using results::LabelledArray;
using Complex = std::complex<double>;

/// Bytes that a variable of version 5 may have.
constexpr double most_bytes = 2147483647;

/// A name that MATLAB accepts: letters, digits and _, at most 63.
std::string field_name(const std::string& name) {
  constexpr std::size_t longest = 63, room_for_number = 5;
  std::string field;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 0x80;
    field += plain ? c : '_';
  }
  if (field.empty() || std::isalpha(static_cast<unsigned char>(field[0])) == 0) field = "n_" + field;
  field.resize(std::min(field.size(), longest - room_for_number));
  return field;
}

/// Numbers by columns: a vector is a column, a matrix has rows and columns, and more axes follow.
std::vector<std::size_t> sizes_of(const LabelledArray& array) {
  std::vector<std::size_t> sizes = array.shape;
  while (sizes.size() < 2) sizes.push_back(1);
  return sizes;
}

/// Numbers with the first axis fastest from numbers with the last axis fastest.
template <typename T>
std::vector<T> by_columns(const std::vector<std::size_t>& shape, const std::vector<T>& numbers) {
  if (shape.size() < 2 || numbers.empty()) return numbers;
  std::vector<T> result(numbers.size());
  std::vector<std::size_t> at(shape.size(), 0);
  for (const T& number : numbers) {
    std::size_t place = 0;
    for (std::size_t axis = shape.size(); axis-- > 0;) place = place * shape[axis] + at[axis];
    result[place] = number;
    for (std::size_t axis = shape.size(); axis-- > 0;) {
      if (++at[axis] < shape[axis]) break;
      at[axis] = 0;
    }
  }
  return result;
}

MatBytes variable_of(const LabelledArray& array) {
  if (array.is_text()) return mat_texts("", array.texts());
  if (array.is_complex()) return mat_complex("", sizes_of(array), by_columns(array.shape, array.complex_numbers()));
  return mat_real("", sizes_of(array), by_columns(array.shape, array.real_numbers()));
}

using Fields = std::vector<std::pair<std::string, MatBytes>>;

/// Groups with names, units and axes of their fields.
MatBytes group_variables(const Content& content, std::vector<std::string>& notes) {
  MatBytes variables;
  bool all_the_same = true;
  std::vector<std::string> fields, names, units, axes;
  for (const Group& group : content.groups) {
    UniqueNames used;
    Fields of_group;
    for (const LabelledArray& array : group.arrays.list()) {
      const std::string field = used.unique(field_name(array.name));
      if (field != array.name && std::exchange(all_the_same, false))
        notes.push_back(fmt::format(
            "names of fields have at most 63 letters, digits and _: {} is {}; about.name has all", array.name, field));
      of_group.emplace_back(field, variable_of(array));
      fields.push_back(group.name + "." + field);
      names.push_back(array.name);
      units.push_back(array.unit);
      axes.push_back(fmt::format("{}", fmt::join(array.axes, " × ")));
    }
    variables += mat_structure(field_name(group.name), of_group);
  }
  Fields about;
  about.emplace_back("source", mat_text("", content.words()));
  about.emplace_back("sha256", mat_text("", project::input_hash(content.project)));
  about.emplace_back("field", mat_texts("", fields));
  about.emplace_back("name", mat_texts("", names));
  about.emplace_back("unit", mat_texts("", units));
  about.emplace_back("axes", mat_texts("", axes));
  return variables + mat_structure("about", about);
}

/// Frequencies around the natural ones, and displacements of the bodies there. Empty without excitation or if
/// constant matrices do not describe the system.
std::optional<MatBytes> check_variable(const Content& content) {
  if (!content.find("matrices")) return std::nullopt;
  const model::System& system = content.variant.system;
  const study::SystemMatrices named = study::system_matrices(content.variant);
  if (!named.exact || named.load.vanishes()) return std::nullopt;
  const assembly::Assembled assembled = assembly::assemble(system);
  std::vector<double> omega;
  for (const modal::Mode& mode : modal::modes(system, assembled).list)
    for (const double factor : {0.7, 0.99, 1.02, 1.4})
      if (mode.angular_frequency && *mode.angular_frequency > 0) omega.push_back(factor * *mode.angular_frequency);
  constexpr std::size_t most = 200;
  omega.resize(std::min(omega.size(), most));
  if (omega.empty()) return std::nullopt;
  const response::FrequencyResponse found = response::frequency_response(
      assembled, assembly::channels(system, assembled, {"coordinates"}, assembly::MotionQuantity::displacement),
      assembly::harmonic_loading(system, assembled), omega);
  std::vector<double> rows;
  std::vector<Complex> q;
  for (const response::Curve& curve : found.curves)
    rows.push_back(1.0 +
                   static_cast<double>(std::ranges::find(named.coordinates, curve.name) - named.coordinates.begin()));
  for (std::size_t k = 0; k < omega.size(); ++k)
    for (const response::Curve& curve : found.curves) q.push_back(curve.value(static_cast<Eigen::Index>(k)));
  Fields check;
  check.emplace_back("omega", mat_real("", {omega.size(), 1}, omega));
  check.emplace_back("row", mat_real("", {rows.size(), 1}, rows));
  check.emplace_back("q", mat_complex("", {rows.size(), omega.size()}, q));
  return mat_structure("check", check);
}

constexpr const char* check_script_start =
    "% Computes the displacements again from the matrices, by backslash, and compares them with those of the file.";

std::string check_script(const std::string& file) {
  return fmt::format(
      R"({}
data = load('{}');
m = data.matrices;
largest = 0;
for k = 1:numel(data.check.omega)
  s = 1i * data.check.omega(k);
  h = zeros(size(m.A, 1), 1);
  for term = 1:numel(m.load_power)
    h = h + s ^ m.load_power(term) * exp(-s * m.load_delay(term)) * m.load(term, :).';
  end
  q = (m.K + 1i * m.K_loss + s * m.B + s ^ 2 * m.A) \ h;
  q = q(data.check.row);
  largest = max(largest, max(abs(q - data.check.q(:, k))) / max(abs(q)));
end
fprintf('%d frequencies, largest difference %.2e of the largest displacement\n', numel(data.check.omega), largest);
assert(largest < 1e-10)
)",
      check_script_start, file);
}

/// A text that a MATLAB script can quote.
bool is_quotable(const std::string& name) { return name.find_first_of("'\n\r") == std::string::npos; }

void require_size(const Content& content) {
  for (const Group& group : content.groups) {
    double bytes = 0;
    for (const LabelledArray& array : group.arrays.list())
      bytes += static_cast<double>(array.size()) * (array.is_complex() ? 16 : 8);
    if (bytes > most_bytes)
      throw foundation::InvalidInput(
          fmt::format("{}: {:.3g} bytes; a MATLAB file of version 5 holds at most 2 GB in one variable; export fewer "
                      "results, or to hdf5",
                      group.name, bytes));
  }
}

std::vector<std::string> write_matlab(const Content& content, const Target& target, const foundation::Progress&) {
  require_size(content);
  const std::string name = target.path().filename().string();
  std::vector<std::string> notes;
  MatBytes bytes = mat_header("MATLAB 5.0 MAT-file, written by Trivet") + group_variables(content, notes);
  const std::optional<MatBytes> check = check_variable(content);
  if (check && is_quotable(name)) {
    bytes += *check;
    write_bytes(target.side(), check_script(name));
  } else if (check) {
    notes.emplace_back("no check script: it cannot quote the name of the file; choose one without '");
  } else if (content.find("matrices")) {
    notes.emplace_back("no check script: it needs a harmonic excitation and matrices that describe the system exactly");
  }
  write_bytes(target.path(), bytes);
  return notes;
}

}  // namespace

const Format matlab_format = {"matlab",
                              "MATLAB file of version 5 (.mat), and NAME_check.m, which solves it again",
                              Target::Kind::file,
                              {},
                              false,
                              write_matlab,
                              {"_check.m", check_script_start}};

}  // namespace trivet::exports
