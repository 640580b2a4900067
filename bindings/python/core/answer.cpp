// SPDX-License-Identifier: BSD-3-Clause
#include "core/answer.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <complex>

namespace trivet::python {
namespace {

namespace nb = nanobind;
using results::LabelledArray;

/// Keeps the memory of a view alive.
struct Owners {
  std::shared_ptr<const void> answer, array;
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

using Texts = std::vector<std::pair<std::string, std::function<std::string()>>>;

std::vector<std::string> names_of(const Texts& texts) {
  std::vector<std::string> names;
  for (const auto& text : texts) names.push_back(text.first);
  return names;
}

/// The text of this name, made without Python's lock.
std::string text_of(const Texts& texts, const std::string& name) {
  for (const auto& text : texts)
    if (text.first == name) {
      const nb::gil_scoped_release released;
      return text.second();
    }
  throw nb::key_error(name.c_str());
}

}  // namespace

ArrayList python_arrays(const results::LabelledArrays& arrays, const std::shared_ptr<const void>& held) {
  ArrayList list;
  for (const LabelledArray& array : arrays.list())
    list.append(nb::make_tuple(array.name, array.unit, nb::tuple(nb::cast(array.axes)), values_of(array, held)));
  return list;
}

void bind_answer(nb::module_& module) {
  nb::class_<Answer>(module, "Answer", "What one command found.")
      .def_ro("question", &Answer::question, "name of the command")
      .def_ro("case", &Answer::case_name, "name of the case, \"\" for the base model")
      .def_ro("title", &Answer::title, "title of the project")
      .def_ro("notes", &Answer::notes)
      .def_ro("failures", &Answer::failures, "parts that could not be computed, with the reason")
      .def_ro("changes", &Answer::changes, "settings of the best design")
      .def_prop_ro("warnings", [](const Answer& answer) { return answer.warnings.list(); })
      .def(
          "json",
          [](const Answer& answer) {
            const nb::gil_scoped_release released;
            return answer.json();
          },
          "JSON as docs/json.md describes it.")
      .def(
          "text",
          [](const Answer& answer, const std::optional<project::ShownUnits>& display) {
            const nb::gil_scoped_release released;
            return display && answer.text_in ? answer.text_in(*display) : answer.text();
          },
          nb::arg("display") = nb::none(), "The text of the command line, perhaps in other units.")
      .def_prop_ro(
          "text_converts", [](const Answer& answer) { return static_cast<bool>(answer.text_in); },
          "does the text have other units with another display?")
      .def_prop_ro(
          "tables", [](const Answer& answer) { return names_of(answer.tables); }, "names of the CSV tables")
      .def(
          "table", [](const Answer& answer, const std::string& name) { return text_of(answer.tables, name); },
          nb::arg("name"), "One table as CSV, SI.")
      .def_prop_ro(
          "figures", [](const Answer& answer) { return names_of(answer.figures); }, "names of the pictures")
      .def(
          "figure", [](const Answer& answer, const std::string& name) { return text_of(answer.figures, name); },
          nb::arg("name"), "One picture as SVG.")
      .def(
          "arrays", [](const Answer& answer) { return python_arrays(answer.arrays, answer.held); },
          "(name, unit, axes, values) of each array; values are read-only views without a copy.")
      .def_prop_ro(
          "harmonic",
          [](const Answer& answer) {
            std::vector<std::string> names;
            for (const LabelledArray& array : answer.arrays.list())
              if (array.harmonic) names.push_back(array.name);
            return names;
          },
          "names of the arrays of harmonic quantities, which have a level");
}

}  // namespace trivet::python
