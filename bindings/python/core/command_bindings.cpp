// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "core/project.h"
#include "core/task.h"

namespace trivet::python {
namespace {

namespace nb = nanobind;

/// The result of work on another thread (core/task.h).
template <typename Result, typename Work>
Result done(const std::string& task, int threads, const nb::object& progress, const OpenProject& open, Work work) {
  const auto result = std::make_shared<Result>();
  run_task({threads, progress, task}, [result, project = open.project, work = std::move(work)](const Progress& report) {
    *result = work(project, report);
  });
  return std::move(*result);
}

}  // namespace

void bind_commands(nb::class_<OpenProject>& of) {
  const auto threads = nb::arg("threads") = 0;
  const auto progress = nb::arg("progress") = nb::none();
  const auto of_case = nb::arg("case") = "";
  of.def(
      "ask",
      [](const OpenProject& open, const std::string& question, const std::string& name, int count,
         const nb::object& shown) {
        return done<Answer>(question, count, shown, open,
                            [question, name](const ProjectPointer& project, const Progress& report) {
                              return asked(project, question, name, report);
                            });
      },
      nb::arg("question"), of_case, threads, progress, "The answer to a question of the table of questions.");
  of.def(
      "map",
      [](const OpenProject& open, const std::string& name, int nx, int ny, int count, const nb::object& shown) {
        return done<Answer>("map", count, shown, open,
                            [name, nx, ny](const ProjectPointer& project, const Progress& report) {
                              return mapped(project, name, nx, ny, report);
                            });
      },
      of_case, nb::arg("nx") = 0, nb::arg("ny") = 0, threads, progress);
  of.def(
      "select",
      [](const OpenProject& open, int most, const std::string& by, int count, const nb::object& shown) {
        return done<Answer>("select", count, shown, open,
                            [most, by](const ProjectPointer& project, const Progress& report) {
                              return selected(project, most, by, report);
                            });
      },
      nb::arg("most") = 10, nb::arg("by") = "margin", threads, progress);
  of.def(
      "optimize",
      [](const OpenProject& open, int count, const nb::object& shown) {
        return done<Answer>("optimize", count, shown, open, optimized);
      },
      threads, progress);
  of.def(
      "verdict",
      [](const OpenProject& open, int count, const nb::object& shown) {
        return done<Answer>("verdict", count, shown, open, judged);
      },
      threads, progress);
  of.def(
      "check",
      [](const OpenProject& open, bool deep, int count, const nb::object& shown) {
        return done<Answer>("check", count, shown, open,
                            [deep](const ProjectPointer& project, const Progress&) { return checked(project, deep); });
      },
      nb::arg("deep") = false, threads, progress);
  of.def(
      "explain",
      [](const OpenProject& open, const std::vector<std::string>& results, int most, const std::string& name, int count,
         const nb::object& shown) {
        return done<Answer>("explain", count, shown, open,
                            [results, most, name](const ProjectPointer& project, const Progress& report) {
                              return explained(project, name, results, most, report);
                            });
      },
      nb::arg("of") = std::vector<std::string>(), nb::arg("most") = 10, of_case, threads, progress);
  of.def(
      "suspension",
      [](const OpenProject& open, const std::vector<std::vector<double>>& torques,
         const std::vector<double>& excitations, const std::string& name, const nb::object& shown) {
        return done<Answer>("suspension", 0, shown, open,
                            [torques, excitations, name](const ProjectPointer& project, const Progress&) {
                              return suspended(project, name, torques, excitations);
                            });
      },
      nb::arg("torques") = std::vector<std::vector<double>>(), nb::arg("excitations") = std::vector<double>(), of_case,
      progress);
  of.def(
      "element",
      [](const OpenProject& open, const std::string& element_name, bool all, const std::string& name, int count,
         const nb::object& shown) {
        return done<Answer>("element", count, shown, open,
                            [element_name, all, name](const ProjectPointer& project, const Progress& report) {
                              return element(project, element_name, name, all, report);
                            });
      },
      nb::arg("name"), nb::arg("all") = false, of_case, threads, progress);
  of.def(
      "run",
      [](const OpenProject& open, const std::string& folder, int count, const nb::object& shown) {
        return done<std::vector<Answer>>(
            "run", count, shown, open,
            [folder](const ProjectPointer& project, const Progress& report) { return ran(project, folder, report); });
      },
      nb::arg("folder"), threads, progress);
  of.def(
      "export",
      [](const OpenProject& open, const std::string& format, const std::string& target,
         const std::vector<std::string>& what, const std::string& name, int count, const nb::object& shown) {
        return done<std::vector<std::string>>(
            "export", count, shown, open,
            [format, target, what, name](const ProjectPointer& project, const Progress& report) {
              return exported(project, format, target, what, name, report);
            });
      },
      nb::arg("format"), nb::arg("target"), nb::arg("what"), of_case, threads, progress);
}

}  // namespace trivet::python
