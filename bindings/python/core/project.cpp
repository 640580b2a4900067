// SPDX-License-Identifier: BSD-3-Clause
#include "core/project.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <tuple>

#include "core/errors.h"
#include "core/task.h"
#include "trivet/engine/program.h"
#include "trivet/engine/session.h"
#include "trivet/engine/units.h"

namespace trivet::python {
namespace {

namespace nb = nanobind;
using engine::Session;

/// Opens a project on another thread: finite elements may take a while.
Session read(const std::string& text, const std::string& source, const std::vector<std::string>& settings,
             const std::string& folder, const nb::object& progress) {
  const auto read = std::make_shared<foundation::Expected<Session>>(tl::make_unexpected(foundation::Problems()));
  run_task({0, progress, "open"}, [read, text, source, settings, folder](const foundation::Progress&) {
    *read = Session::open({source, text, folder}, settings);
  });
  return value_or_throw(std::move(*read));
}

/// The same with these changes of the file in place of the earlier ones.
Session changed(const Session& session, const std::vector<std::string>& settings) {
  const nb::gil_scoped_release released;
  return value_or_throw(session.changed(settings));
}

/// A value of Python as one of a request. @throws nb::type_error for a kind that no key has
engine::Value value_of(nb::handle object) {
  if (nb::isinstance<nb::bool_>(object)) return nb::cast<bool>(object);
  if (nb::isinstance<nb::str>(object)) return nb::cast<std::string>(object);
  if (nb::isinstance<nb::int_>(object) || nb::isinstance<nb::float_>(object)) return nb::cast<double>(object);
  if (!nb::isinstance<nb::list>(object) && !nb::isinstance<nb::tuple>(object))
    throw nb::type_error("a value of a key is a text, a number, a bool or a list of these");
  std::vector<engine::Value> list;
  for (nb::handle one : nb::cast<nb::sequence>(object)) list.push_back(value_of(one));
  return list;
}

/// The result of a command, computed on another thread.
engine::Result ask(const Session& session, const std::string& command, const std::string& case_name,
                   const nb::typed<nb::dict, nb::str, nb::any>& keys, int threads, const nb::object& progress) {
  engine::Request request{.command = command, .case_name = case_name, .threads = threads};
  for (const auto& [key, value] : keys) request.keys.emplace_back(nb::cast<std::string>(key), value_of(value));
  const auto result = std::make_shared<engine::Result>();
  run_task({threads, progress, command},
           [result, session, request](const foundation::Progress& report) { *result = session.ask(request, report); });
  if (result->errors.has_errors()) throw WrongInput(result->errors);
  if (!result->failure.empty()) throw foundation::NotComputable(result->failure);
  return std::move(*result);
}

std::vector<std::pair<std::string, std::string>> analyses() {
  std::vector<std::pair<std::string, std::string>> list;
  for (const engine::Command& command : engine::commands())
    if (command.is_analysis) list.emplace_back(command.name, command.about);
  return list;
}

/// (name, about) of each key.
using KeyList = std::vector<std::pair<std::string, std::string>>;

/// (name, what it is for, has it a case, its keys besides those of the file and files that it writes) of every command.
std::vector<std::tuple<std::string, std::string, bool, KeyList>> commands() {
  std::vector<std::tuple<std::string, std::string, bool, KeyList>> list;
  for (const engine::Command& command : engine::commands()) {
    KeyList keys;
    if (!command.is_analysis)  // its keys are those of the file, too
      for (const engine::Key& key : command.keys)
        if (key.kind != engine::KeyKind::file) keys.emplace_back(key.name, key.about);
    list.emplace_back(command.name, command.about, command.of_one_case, std::move(keys));
  }
  return list;
}

template <typename Part>
std::vector<std::string> names_of(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

}  // namespace

void bind_project(nb::module_& module) {
  nb::class_<Session>(module, "Project", "A checked project.")
      .def_prop_ro("text", &Session::text)
      .def_prop_ro("source", &Session::source)
      .def_prop_ro("settings", &Session::settings)
      .def_prop_ro("title", &Session::title)
      .def_prop_ro("content", &Session::content, "a hash, equal for equal projects")
      .def_prop_ro("cases",
                   [](const Session& session) {
                     std::vector<std::string> names = session.case_names();
                     names.erase(names.begin());
                     return names;
                   })
      .def_prop_ro(
          "parts",
          [](const Session& session) {
            const model::Description& parts = session.model().system.description();
            return std::tuple(names_of(parts.bodies), names_of(parts.elements), names_of(parts.excitations));
          },
          "names of bodies, elements and excitations of the base model")
      .def("model", &Session::model_json, nb::arg("case") = "", "Bodies, elements, … of a case as JSON, SI.")
      .def(
          "to_toml",
          [](const Session& session, const std::string& target) {
            const nb::gil_scoped_release released;
            return value_or_throw(session.text_with_settings(target));
          },
          nb::arg("target") = "", "The text with the settings, for a file.")
      .def("changed", changed, nb::arg("settings"), "The project with these settings in place of its own.")
      .def("ask", ask, nb::arg("command"), nb::arg("case") = "", nb::arg("keys") = nb::dict(), nb::arg("threads") = 0,
           nb::arg("progress") = nb::none(), "The result of a command.");
  module.def("read", read, nb::arg("text"), nb::arg("source"), nb::arg("settings"), nb::arg("folder") = "",
             nb::arg("progress") = nb::none(), "Reads and checks a project. Files are relative to `folder`.");
  module.def(
      "read_text", [](const std::string& file) { return value_or_throw(engine::read_source(file)); }, nb::arg("file"),
      "Text of a project file.");
  module.def("path_keys", &engine::path_keys, nb::arg("path"), "Keys of a path; empty if it is none.");
  module.def("analyses", analyses, "(name, what it answers) of every analysis of a case");
  module.def("commands", commands, "(name, what it answers, is it of one case, its keys) of every command");
  module.def(
      "file_table",
      [](const std::string& command) {
        const engine::Command* found = engine::find_command(command);
        return found ? engine::file_table(*found) : std::string();
      },
      nb::arg("command"), "Path of a command's table in the project file.");
  module.def(
      "file_keys",
      [](const std::string& command) {
        const engine::Command* found = engine::find_command(command);
        return found ? engine::file_keys(*found) : std::string();
      },
      nb::arg("command"), "Keys of a command's table in the project file, as its help lists them.");
  module.def("schema", &engine::project_schema, "The JSON Schema of the project file.");
  module.def("starter", &engine::starter_text, "A commented project file to begin with.");
  module.def("in_unit", &engine::in_unit, nb::arg("value"), nb::arg("from_unit"), nb::arg("to_unit"),
             "A number in another unit of the same quantity.");
  module.def("angular_frequency", &engine::angular_frequency, nb::arg("text"), "A frequency with its unit in rad/s.");
  module.def("formats", &engine::export_formats, "(name, what it holds) of every format of `export`");
  module.attr("version") = engine::version();
}

}  // namespace trivet::python
