// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

#include "trivet/assembly/loads.h"
#include "trivet/exports/completeness.h"
#include "trivet/exports/format_table.h"
#include "trivet/exports/unique_names.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/study/explain/linear_system.h"

/// MATLAB files of version 5: a structure for each group, "about" with names, units and axes, and "check": exact
/// displacements at some frequencies, which NAME_check.m computes again from A, B, K and the load by backslash.
namespace trivet::exports {
namespace {

using results::LabelledArray;
using Complex = std::complex<double>;

struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, FreeVariable>;
struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};

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

Variable made_variable(matvar_t* variable) {
  if (!variable) throw std::runtime_error("a MATLAB variable cannot be created: not enough memory");
  return Variable(variable);
}

Variable mat_text(const char* name, const std::string& words) {
  std::u16string units = utf16(words);
  std::array<std::size_t, 2> sizes = {units.empty() ? std::size_t{0} : 1, units.size()};
  return made_variable(Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF16, 2, sizes.data(), units.data(), 0));
}

Variable cell_of_texts(const char* name, const std::vector<std::string>& texts) {
  std::array<std::size_t, 2> sizes = {texts.size(), 1};
  Variable cell = made_variable(Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, sizes.data(), nullptr, 0));
  for (std::size_t i = 0; i < texts.size(); ++i)
    Mat_VarSetCell(cell.get(), static_cast<int>(i), mat_text(nullptr, texts[i]).release());
  return cell;
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

Variable mat_real(const char* name, std::vector<std::size_t> sizes, std::vector<double> numbers) {
  return made_variable(
      Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(sizes.size()), sizes.data(), numbers.data(), 0));
}

Variable mat_complex(const char* name, std::vector<std::size_t> sizes, const std::vector<Complex>& numbers) {
  if (numbers.empty()) return mat_real(name, std::move(sizes), {});  // matio frees what it did not allocate
  std::vector<double> re, im;
  for (const Complex& number : numbers) {
    re.push_back(number.real());
    im.push_back(number.imag());
  }
  mat_complex_split_t split{re.data(), im.data()};
  return made_variable(Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(sizes.size()), sizes.data(),
                                     &split, MAT_F_COMPLEX));
}

Variable variable_of(const LabelledArray& array, const char* name) {
  if (array.is_text()) return cell_of_texts(name, array.texts());
  if (array.is_complex()) return mat_complex(name, sizes_of(array), by_columns(array.shape, array.complex_numbers()));
  return mat_real(name, sizes_of(array), by_columns(array.shape, array.real_numbers()));
}

/// A structure of variables, which it takes over.
Variable mat_structure(const char* name, std::vector<std::pair<std::string, Variable>> fields) {
  std::vector<const char*> names;
  for (const auto& field : fields) names.push_back(field.first.c_str());
  std::array<std::size_t, 2> sizes = {1, 1};
  Variable result =
      made_variable(Mat_VarCreateStruct(name, 2, sizes.data(), names.data(), static_cast<unsigned>(names.size())));
  for (auto& field : fields) Mat_VarSetStructFieldByName(result.get(), field.first.c_str(), 0, field.second.release());
  return result;
}

using Fields = std::vector<std::pair<std::string, Variable>>;

/// Groups with names, units and axes of their fields.
std::vector<Variable> group_variables(const Content& content, std::vector<std::string>& notes) {
  std::vector<Variable> variables;
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
      of_group.emplace_back(field, variable_of(array, nullptr));
      fields.push_back(group.name + "." + field);
      names.push_back(array.name);
      units.push_back(array.unit);
      axes.push_back(fmt::format("{}", fmt::join(array.axes, " × ")));
    }
    variables.push_back(mat_structure(field_name(group.name).c_str(), std::move(of_group)));
  }
  Fields about;
  about.emplace_back("source", mat_text(nullptr, content.words()));
  about.emplace_back("sha256", mat_text(nullptr, content.project.sha256));
  about.emplace_back("field", cell_of_texts(nullptr, fields));
  about.emplace_back("name", cell_of_texts(nullptr, names));
  about.emplace_back("unit", cell_of_texts(nullptr, units));
  about.emplace_back("axes", cell_of_texts(nullptr, axes));
  variables.push_back(mat_structure("about", std::move(about)));
  return variables;
}

/// Frequencies around the natural ones, and displacements of the bodies there. Empty without excitation or if
/// constant matrices do not describe the system.
std::optional<Variable> check_variable(const Content& content) {
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
  check.emplace_back("omega", mat_real(nullptr, {omega.size(), 1}, omega));
  check.emplace_back("row", mat_real(nullptr, {rows.size(), 1}, rows));
  check.emplace_back("q", mat_complex(nullptr, {rows.size(), omega.size()}, q));
  return mat_structure("check", std::move(check));
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
  const std::string path = target.path().string(), name = target.path().filename().string();
  std::vector<std::string> notes;
  {
    const std::unique_ptr<mat_t, CloseFile> file(
        Mat_CreateVer(path.c_str(), "MATLAB 5.0 MAT-file, written by Trivet", MAT_FT_MAT5));
    if (!file) throw std::runtime_error(fmt::format("cannot write {}", path));
    std::vector<Variable> variables = group_variables(content, notes);
    std::optional<Variable> check = check_variable(content);
    if (check && is_quotable(name)) {
      variables.push_back(std::move(*check));
      write_bytes(target.side(), check_script(name));
    } else if (check) {
      notes.emplace_back("no check script: it cannot quote the name of the file; choose one without '");
    } else if (content.find("matrices")) {
      notes.emplace_back(
          "no check script: it needs a harmonic excitation and matrices that describe the system exactly");
    }
    for (const Variable& variable : variables)
      if (Mat_VarWrite(file.get(), variable.get(), MAT_COMPRESSION_NONE) != 0)
        throw std::runtime_error(fmt::format("cannot write {} to {}; is the disk full?", variable->name, path));
  }
  require_complete_matlab_file(target.path());
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
