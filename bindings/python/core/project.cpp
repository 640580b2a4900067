// SPDX-License-Identifier: BSD-3-Clause
#include "core/project.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <tuple>

#include "core/errors.h"
#include "core/task.h"
#include "trivet/exports/format.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/version.h"
#include "trivet/project/rewritten_project.h"
#include "trivet/project/schema.h"
#include "trivet/project/text/embedded_text.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shown_units.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/units.h"
#include "trivet/study/asked_questions.h"

namespace trivet::python {
namespace {

namespace nb = nanobind;

/// Reads a project on another thread: finite elements may take a while.
OpenProject read(const std::string& text, const std::string& source, const std::vector<std::string>& settings,
                 const std::string& folder, const nb::object& progress) {
  struct Read {
    foundation::Expected<project::Project> project;
    std::string content;
  };
  const auto read = std::make_shared<Read>();
  run_task({0, progress, "open"}, [read, text, source, settings, folder](const Progress&) {
    read->project = project::project_from_text(text, source, settings, folder);
    if (read->project) read->content = project::content_hash(*read->project);
  });
  return {std::make_shared<const project::Project>(value_or_throw(std::move(read->project))), text, source, settings,
          read->content};
}

std::string unit_words(const std::string& from, const std::string& to) {
  for (const std::string& unit : {from, to})
    if (!project::is_known_unit(unit)) return "\"" + unit + "\" is not a unit; write it as in \"kN/mm\"";
  return "\"" + to + "\" measures another quantity than \"" + from + "\"; give a unit of the same";
}

std::vector<std::pair<std::string, std::string>> questions() {
  std::vector<std::pair<std::string, std::string>> list;
  for (const study::AskedQuestion& question : study::asked_questions())
    list.emplace_back(question.name, question.about);
  return list;
}

}  // namespace

void bind_project(nb::module_& module) {
  nb::class_<OpenProject> of(module, "Project", "A checked project.");
  of.def_ro("text", &OpenProject::text)
      .def_ro("source", &OpenProject::source)
      .def_ro("settings", &OpenProject::settings)
      .def_prop_ro("title", [](const OpenProject& open) { return open.project->title; })
      .def_ro("content", &OpenProject::content, "a hash, equal for equal projects")
      .def_prop_ro("cases",
                   [](const OpenProject& open) {
                     std::vector<std::string> names;
                     for (const project::Case& variant : open.project->cases)
                       if (!variant.name.empty()) names.push_back(variant.name);
                     return names;
                   })
      .def_prop_ro(
          "parts",
          [](const OpenProject& open) {
            const model::Description& parts = open.project->base().system.description();
            const auto names = [](const auto& list) {
              std::vector<std::string> all;
              for (const auto& one : list) all.push_back(one.name);
              return all;
            };
            return std::tuple(names(parts.bodies), names(parts.elements), names(parts.excitations));
          },
          "names of bodies, elements and excitations of the base model")
      .def(
          "to_toml",
          [](const OpenProject& open, const std::string& target) {
            const nb::gil_scoped_release released;
            return value_or_throw(project::text_with_settings(open.text, *open.project, open.settings, target));
          },
          nb::arg("target") = "", "The text with the settings, for a file.");
  bind_commands(of);
  bind_studies(module, of);
  module.def(
      "read_text", [](const std::string& file) { return value_or_throw(project::read_source(file)); }, nb::arg("file"),
      "Text of a project file.");
  module.def("read", read, nb::arg("text"), nb::arg("source"), nb::arg("settings"), nb::arg("folder") = "",
             nb::arg("progress") = nb::none(), "Reads and checks a project. Files are relative to `folder`.");
  module.def("path_keys", &project::path_keys, nb::arg("path"), "Keys of a path; empty if it is none.");
  module.def("questions", questions, "(name, what it answers) of every row of the table of questions");
  module.def("schema", &project::project_schema, "The JSON Schema of the project file.");
  module.def("starter", [] { return std::string(project::starter_text); }, "A commented project file to begin with.");
  module.def("use_unit_database", &project::use_unit_database, nb::arg("file"));
  module.def(
      "in_unit",
      [](double value, const std::string& from, const std::string& to) {
        const auto converted = project::in_unit({value, from}, to);
        if (!converted) throw foundation::InvalidInput(unit_words(from, to));
        return *converted;
      },
      nb::arg("value"), nb::arg("from_unit"), nb::arg("to_unit"), "A number in another unit of the same quantity.");
  nb::class_<project::ShownUnits>(module, "ShownUnits", "Units in which tables and pictures show numbers.")
      .def(nb::init<>())
      .def(
          "changed",
          [](const project::ShownUnits& units, const std::vector<std::pair<std::string, std::string>>& changes) {
            project::ShownUnits changed = units;
            foundation::Problems wrong;
            for (const auto& [key, value] : changes) wrong.add(project::set_shown_unit(changed, key, value));
            if (wrong.has_errors()) throw WrongInput(wrong);
            return changed;
          },
          nb::arg("changes"))
      .def_ro("frequency", &project::ShownUnits::frequency)
      .def_prop_ro("level", [](const project::ShownUnits& units) { return project::level_name(units.level); })
      .def_prop_ro("level_factor", [](const project::ShownUnits& units) { return project::level_factor(units.level); })
      .def(
          "unit",
          [](const project::ShownUnits& units, const std::string& si_unit) {
            const project::ShownUnit shown = project::shown_unit(units, si_unit);
            return std::pair(shown.unit, shown.factor);
          },
          nb::arg("si_unit"), "(unit, factor) in place of an SI unit")
      .def("axis", [](const project::ShownUnits& units) {
        const project::ShownUnit shown = project::shown_frequency(units);
        return std::pair(shown.unit, shown.factor);
      });
  module.def(
      "formats",
      [] {
        std::vector<std::pair<std::string, std::string>> list;
        for (const exports::Format& format : exports::formats()) list.emplace_back(format.name, format.about);
        return list;
      },
      "(name, what it holds) of every format of `export`");
  module.attr("version") = foundation::version();
}

}  // namespace trivet::python
