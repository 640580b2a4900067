// SPDX-License-Identifier: BSD-3-Clause
#include "core/result.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <complex>
#include <cstdint>

#include "core/errors.h"
#include "trivet/engine/result.h"
#include "trivet/engine/units.h"

namespace trivet::python {
namespace {

namespace nb = nanobind;
using documents::LabelledArray;
using engine::DisplayUnits;
using engine::Result;

using ArrayList =
    nb::typed<nb::list, nb::typed<nb::tuple, nb::str, nb::str, nb::typed<nb::tuple, nb::str, nb::ellipsis>, nb::any>>;

using ColumnList = nb::typed<nb::list, nb::typed<nb::tuple, nb::str, nb::str, nb::typed<nb::list, nb::any>>>;

/// Keeps the memory of a view alive.
struct Owners {
  std::shared_ptr<const void> result, array;
};

template <typename T>
nb::object view(const LabelledArray& array, const std::shared_ptr<const void>& held) {
  static const T nothing{};
  const T* const first = std::get<const T*>(array.values);
  auto* const owners = new Owners{held, array.owner};
  const nb::capsule owner(owners, [](void* p) noexcept { delete static_cast<Owners*>(p); });
  const std::vector<std::int64_t> strides(array.strides.begin(), array.strides.end());
  return nb::cast(nb::ndarray<nb::numpy, const T>(first ? first : &nothing, array.shape.size(), array.shape.data(),
                                                  owner, strides.data()),
                  nb::rv_policy::reference);
}

nb::object values_of(const LabelledArray& array, const std::shared_ptr<const void>& held) {
  if (array.is_text()) return nb::cast(array.texts());
  return array.is_complex() ? view<std::complex<double>>(array, held) : view<double>(array, held);
}

documents::LabelledArrays arrays_of(const Result& result) {
  return result.arrays ? result.arrays() : documents::LabelledArrays();
}

/// (name, unit, axes, numbers or texts) of each array; numbers are read-only views that keep the result alive.
ArrayList python_arrays(const Result& result) {
  ArrayList list;
  const documents::LabelledArrays arrays = arrays_of(result);
  for (const LabelledArray& array : arrays.list())
    list.append(nb::make_tuple(array.name, array.unit, nb::tuple(nb::cast(array.axes)), values_of(array, result.held)));
  return list;
}

std::vector<std::string> harmonic_names(const Result& result) {
  std::vector<std::string> names;
  const documents::LabelledArrays arrays = arrays_of(result);
  for (const LabelledArray& array : arrays.list())
    if (array.harmonic) names.push_back(array.name);
  return names;
}

std::vector<std::string> names_of(const engine::NamedWriters& forms) {
  std::vector<std::string> names;
  for (const auto& form : forms) names.push_back(form.first);
  return names;
}

/// The text of this name, made without Python's lock.
std::string text_of(const engine::NamedWriters& forms, const std::string& name) {
  for (const auto& form : forms)
    if (form.first == name) {
      const nb::gil_scoped_release released;
      return engine::whole(form.second);
    }
  throw nb::key_error(name.c_str());
}

nb::object python_value(const documents::Json& value) {
  if (value.is_null()) return nb::none();
  if (value.is_string()) return nb::cast(value.get<std::string>());
  if (value.is_boolean()) return nb::cast(value.get<bool>() ? "yes" : "no");
  if (value.is_number_integer()) return nb::cast(value.get<std::int64_t>());
  const double number = value.get<double>();
  return std::isnan(number) ? nb::object(nb::none()) : nb::cast(number);
}

/// (name, unit, values) of each column.
ColumnList python_columns(const Result& result, const std::string& table, const DisplayUnits& display) {
  ColumnList list;
  for (const documents::TypedColumn& column : result.columns(table, display)) {
    nb::list values;
    for (const documents::Json& value : column.values) values.append(python_value(value));
    list.append(nb::make_tuple(column.name, column.unit, values));
  }
  return list;
}

/// Arrays are zero-to-peak unless a level was chosen.
project::Level level_of_data(const DisplayUnits& units) { return units.level.value_or(project::Level::amplitude); }

void bind_units(nb::module_& module) {
  nb::class_<DisplayUnits>(module, "DisplayUnits", "Units in which tables and pictures show numbers.")
      .def(nb::init<>())
      .def(
          "changed",
          [](const DisplayUnits& units, const std::vector<std::pair<std::string, std::string>>& changes) {
            return value_or_throw(engine::changed_units(units, changes));
          },
          nb::arg("changes"))
      .def_ro("frequency", &DisplayUnits::frequency)
      .def_prop_ro("level", [](const DisplayUnits& units) { return project::level_name(level_of_data(units)); })
      .def_prop_ro("level_factor",
                   [](const DisplayUnits& units) { return project::level_factor(level_of_data(units)); })
      .def(
          "unit",
          [](const DisplayUnits& units, const std::string& si_unit) {
            const project::ShownUnit shown = project::shown_unit(units, si_unit);
            return std::pair(shown.unit, shown.factor);
          },
          nb::arg("si_unit"), "(unit, factor) in place of an SI unit")
      .def("axis", [](const DisplayUnits& units) {
        const project::ShownUnit shown = project::shown_frequency(units);
        return std::pair(shown.unit, shown.factor);
      });
}

}  // namespace

void bind_result(nb::module_& module) {
  bind_units(module);
  nb::class_<Result>(module, "Result", "What one command found.")
      .def_ro("analysis", &Result::command, "name of the command")
      .def_ro("case", &Result::case_name, "name of the case, \"\" for the base model")
      .def_ro("title", &Result::title, "title of the project")
      .def_ro("display", &Result::display, "units of the model")
      .def_ro("notes", &Result::notes)
      .def_ro("failures", &Result::failures, "parts that could not be computed, with the reason")
      .def_ro("changes", &Result::changes, "settings of the best design")
      .def_ro("remarks", &Result::remarks, "on files that were written")
      .def_ro("cases", &Result::cases, "of a run: the results of each case")
      .def_prop_ro("warnings",
                   [](const Result& result) {
                     std::vector<foundation::Problem> list = result.warnings.list();
                     for (foundation::Problem& one : list) one = in_words_of_python(one);
                     return list;
                   })
      .def(
          "json",
          [](const Result& result) {
            const nb::gil_scoped_release released;
            return engine::whole(result.json);
          },
          "JSON as docs/json.md describes it.")
      .def(
          "text",
          [](const Result& result, const std::optional<DisplayUnits>& display) {
            const nb::gil_scoped_release released;
            return display && result.text_in ? result.text_in(*display) : engine::whole(result.text);
          },
          nb::arg("display") = nb::none(), "The text of the command line, perhaps in other units.")
      .def(
          "html",
          [](const Result& result, const std::optional<DisplayUnits>& display) {
            const nb::gil_scoped_release released;
            return result.html ? result.html(display.value_or(result.display)) : std::string();
          },
          nb::arg("display") = nb::none(), "Tables and sentences as a part of a page; empty if it has none.")
      .def_prop_ro(
          "text_converts", [](const Result& result) { return static_cast<bool>(result.text_in); },
          "does the text have other units with another display?")
      .def_prop_ro(
          "tables", [](const Result& result) { return names_of(result.tables); }, "names of the CSV tables")
      .def(
          "table", [](const Result& result, const std::string& name) { return text_of(result.tables, name); },
          nb::arg("name"), "One table as CSV, SI.")
      .def_prop_ro(
          "tables_convert", [](const Result& result) { return static_cast<bool>(result.columns); },
          "can its tables have other units?")
      .def("columns", python_columns, nb::arg("table"), nb::arg("display"),
           "(name, unit, values) of each column of a table, in these units.")
      .def_prop_ro(
          "figures", [](const Result& result) { return names_of(result.figures); }, "names of the pictures")
      .def(
          "figure", [](const Result& result, const std::string& name) { return text_of(result.figures, name); },
          nb::arg("name"), "One picture as SVG.")
      .def("arrays", python_arrays,
           "(name, unit, axes, values) of each array; values are read-only views without a copy.")
      .def_prop_ro("harmonic", harmonic_names, "names of the arrays of harmonic quantities, which have a level");
}

}  // namespace trivet::python
