// SPDX-License-Identifier: BSD-3-Clause
#include "core/errors.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <system_error>
#include <tuple>

namespace trivet::python {
namespace {

namespace nb = nanobind;
using foundation::Problem;

void raise(const char* name, const nb::object& value) {
  const nb::object type = nb::module_::import_("trivet._errors").attr(name);
  PyErr_SetObject(type.ptr(), type(value).ptr());
}

nb::list errors_of(const foundation::Problems& problems) {
  nb::list list;
  for (const Problem& problem : problems.list())
    if (problem.severity == foundation::Severity::error) list.append(in_words_of_python(problem));
  return list;
}

/// A message of one part: "response: no harmonic excitation; …; add …".
foundation::Problems one_problem(const char* words) {
  foundation::Problems problems;
  problems.error("", words, "", "");
  return problems;
}

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const WrongInput& wrong) {
    raise("InputError", errors_of(wrong.problems));
  } catch (const foundation::InvalidInput& wrong) {
    raise("InputError", errors_of(one_problem(wrong.what())));
  } catch (const foundation::NotComputable& reason) {
    raise("NotComputable", nb::str(reason.what()));
  } catch (const foundation::Interrupted&) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
  } catch (const std::filesystem::filesystem_error& of_file) {
    PyErr_SetObject(PyExc_OSError,
                    nb::make_tuple(of_file.code().value(), of_file.code().message(), of_file.path1().string()).ptr());
  } catch (const std::system_error& of_system) {
    PyErr_SetObject(PyExc_OSError, nb::make_tuple(of_system.code().value(), of_system.what()).ptr());
  }
}

}  // namespace

Problem in_words_of_python(const Problem& problem) { return engine::with_word_of_settings(problem, "changes: "); }

void bind_errors(nb::module_& module) {
  nb::class_<Problem>(module, "Problem", "One problem of the input: where, what was found, which rule, what to do.")
      .def(
          "__init__",
          [](Problem* self, std::string subject, std::string finding, std::string rule, std::string remedy) {
            new (self) Problem{.subject = std::move(subject),
                               .finding = std::move(finding),
                               .rule = std::move(rule),
                               .remedy = std::move(remedy)};
          },
          nb::arg("subject"), nb::arg("finding"), nb::arg("rule"), nb::arg("remedy"))
      .def_prop_ro(
          "severity", [](const Problem& p) { return p.severity == foundation::Severity::error ? "error" : "warning"; },
          "\"error\" or \"warning\"")
      .def_prop_ro(
          "place", [](const Problem& p) { return foundation::place(p.origin); }, "\"machine.toml:12\"")
      .def_prop_ro(
          "line", [](const Problem& p) { return p.origin.line; }, "line of the file, 0 if unknown")
      .def_ro("subject", &Problem::subject, "the item as a path: \"elements.mount.stiffness\"")
      .def_ro("finding", &Problem::finding, "the value found")
      .def_ro("rule", &Problem::rule, "the rule that it violates")
      .def_ro("remedy", &Problem::remedy, "what to do")
      .def("__getstate__",
           [](const Problem& p) {
             return std::tuple(p.severity == foundation::Severity::error, p.origin.source, p.origin.line,
                               p.origin.column, p.subject, p.finding, p.rule, p.remedy);
           })
      .def(
          "__setstate__",
          [](Problem& self,
             const std::tuple<bool, std::string, int, int, std::string, std::string, std::string, std::string>& state) {
            const auto& [error, source, line, column, subject, finding, rule, remedy] = state;
            new (&self) Problem{.severity = error ? foundation::Severity::error : foundation::Severity::warning,
                                .origin = {source, line, column},
                                .subject = subject,
                                .finding = finding,
                                .rule = rule,
                                .remedy = remedy};
          })
      .def("__str__", [](const Problem& p) { return foundation::message(p); })
      .def("__repr__", [](const Problem& p) { return "<trivet.Problem " + foundation::message(p) + ">"; });
  module.def(
      "message_list",
      [](const std::vector<Problem>& list) {
        foundation::Problems problems;
        for (const Problem& problem : list) problems.add(problem);
        return engine::message_list(problems);
      },
      nb::arg("problems"), "The messages as the command line prints them.");
  nb::register_exception_translator(translate);
}

}  // namespace trivet::python
