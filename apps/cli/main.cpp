// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sstream>
#include <string>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/signals.h"
#include "trivet/exports/format.h"
#include "trivet/foundation/freed_memory.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/problems.h"
#include "trivet/foundation/version.h"
#include "trivet/project/schema.h"
#include "trivet/project/text/embedded_text.h"
#include "trivet/study/asked_questions.h"

namespace {

using trivet::cli::Options;

std::string not_empty(const std::string& text) { return text.empty() ? "an empty text; omit the option" : ""; }

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& about, Options& options) {
  CLI::App* command = app.add_subcommand(name, about);
  command->add_option("PROJECT", options.project, "project file (TOML)")->required();
  command
      ->add_option("--set", options.settings,
                   "change a number: elements.front.scale=1.5 (repeatable); overrides the file and its cases")
      ->allow_extra_args(false);
  return command;
}

CLI::App* add_answer(CLI::App& app, const std::string& name, const std::string& about, Options& options) {
  CLI::App* command = add_command(app, name, about, options);
  command->add_option("--case", options.case_name, "a case of the file instead of the base model")->check(not_empty);
  CLI::Option* json = command->add_flag("--json", options.json, "JSON, SI");
  command->add_flag("--csv", options.csv, "CSV, SI")->excludes(json);
  return command;
}

/// Adds --strict to a command with a verdict.
CLI::App* add_strict(CLI::App* command, Options& options) {
  command->add_flag(
      "--strict", options.strict,
      "exit code 3 if a limit or a rule is violated, 4 if there are only warnings; the answer is written in any case");
  return command;
}

std::string at_least_one(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number >= 1
      ? ""
      : "\"" + text + "\": must be a whole number ≥ 1";
}

void add_picture(CLI::App& command, const std::string& drawn, Options& options) {
  const auto is_svg = [](const std::string& path) {
    return std::filesystem::path(path).extension() == ".svg"
        ? std::string()
        : (path.empty() ? "\"\"" : path) + ": pictures are SVG; name a file that ends in .svg";
  };
  command.add_option("--picture", options.picture, "draw the " + drawn + " to this SVG file")->check(is_svg);
}

void add_write(CLI::App& command, const std::string& best, Options& options) {
  command
      .add_option("--write", options.write,
                  "write the project file with the " + best + " to this file; comments, order and format stay")
      ->check(not_empty);
}

/// Reports a word that is not a command.
void refuse_command(CLI::App& app, const std::string& word) {
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(command->get_name());
  const std::string guess = trivet::foundation::nearest_name(word, commands);
  trivet::cli::write_error("error: " + trivet::foundation::quoted(word) + " is not a command; " +
                           (guess.empty() ? "trivet --help lists them" : "did you mean \"" + guess + "\"?") + "\n");
}

/// Prints help and version unchanged; for a wrong command line, prints what the user typed as printable text.
int said_by_parser(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  std::stringstream text;
  static_cast<void>(app.exit(error, text, text));
  std::string mark = "error: ";
  for (std::string line; std::getline(text, line); mark.clear())
    trivet::cli::write_error(mark + trivet::foundation::on_one_line(line) + "\n");
  return trivet::cli::wrong_input;
}

int dispatch(const CLI::App& app, const Options& options) {
  const std::string which = app.get_subcommands().front()->get_name();
  if (which == "new") return trivet::cli::write_output(trivet::project::starter_text), trivet::cli::done;
  if (which == "schema") return trivet::cli::write_output(trivet::project::project_schema()), trivet::cli::done;
  if (which == "check") return trivet::cli::check_command(options);
  if (which == "element") return trivet::cli::element_command(options);
  if (which == "explain") return trivet::cli::explain_command(options);
  if (which == "suspension") return trivet::cli::suspension_command(options);
  if (which == "verdict") return trivet::cli::verdict_command(options);
  if (which == "optimize") return trivet::cli::optimize_command(options);
  if (which == "select") return trivet::cli::select_command(options);
  if (which == "map") return trivet::cli::map_command(options);
  if (which == "export") return trivet::cli::export_command(options);
  if (which == "run") return trivet::cli::run_command(options);
  return trivet::cli::answer_command(which, options);
}

void add_response_options(CLI::App& app, Options& options) {
  CLI::App* response = app.get_subcommand("response");
  CLI::Option* at = response->add_option("--at", options.at, "single frequencies: 1,2.7,15.6 in rad/s, or with units")
                        ->check(not_empty);
  response->add_option("--band", options.band, "FROM,TO in rad/s, or with units")->check(not_empty)->excludes(at);
}

void add_modes_options(CLI::App& app, Options& options) {
  app.get_subcommand("modes")->add_option("--lowest", options.lowest, "report only so many modes")->check(at_least_one);
}

void add_explain(CLI::App& app, Options& options) {
  CLI::App* explain =
      add_answer(app, "explain", "causes of each resonance peak, and the parameters that change it", options);
  explain
      ->add_option("--of", options.of,
                   "result whose peaks are explained (repeatable); default: the results of `peaks` in the file")
      ->allow_extra_args(false);
  explain->add_option("--most", options.most, "number of peaks explained, the highest relative to their curve")
      ->capture_default_str()
      ->check(at_least_one);
}

void add_suspension(CLI::App& app, Options& options) {
  CLI::App* suspension =
      add_answer(app, "suspension", "elastic centre, roll axes, decoupling and frequency separation", options);
  suspension
      ->add_option("--torque", options.torque,
                   "axis of the moment, body frame: x, y, z or 0.9,0,0.1; all three by default")
      ->check(not_empty);
  suspension
      ->add_option("--excitation", options.excitations,
                   "frequencies to compare with the natural ones: 25Hz,50Hz, or in rad/s")
      ->check(not_empty);
}

void add_map(CLI::App& app, Options& options) {
  CLI::App* map =
      add_answer(app, "map", "map of limits over two parameters: feasible designs and governing rules", options);
  map->add_option("--points", options.points,
                  "designs along both axes instead of those of the file: 200x150, or 100 for both")
      ->check(not_empty);
  add_picture(*map, "map", options);
  add_strict(map, options);
}

void add_element(CLI::App& app, Options& options) {
  CLI::App* element =
      add_command(app, "element",
                  "one element: its 12x12, checks, energy, and a comparison with three springs in its place", options);
  element->add_option("NAME", options.element, "name of the element")->required();
  element->add_option("--case", options.case_name, "a case of the file instead of the base model");
  element->add_flag("--json", options.json, "JSON, SI");
  element->add_flag("--all", options.all,
                    "replace every element by three springs for the comparison, not only this one");
  add_picture(*element, "element", options);
}

void add_verdict(CLI::App& app, Options& options) {
  CLI::App* verdict = add_command(
      app, "verdict", "is every requirement met in every case, which one governs, and by what margin?", options);
  CLI::Option* json = verdict->add_flag("--json", options.json, "JSON, SI");
  verdict->add_flag("--csv", options.csv, "CSV, SI")->excludes(json);
  add_strict(verdict, options);
}

void add_optimize(CLI::App& app, Options& options) {
  CLI::App* optimize = add_command(
      app, "optimize", "the values of [parameters] with the largest least margin, or the smallest amplitudes", options);
  CLI::Option* json = optimize->add_flag("--json", options.json, "JSON");
  optimize->add_flag("--csv", options.csv, "CSV: the parameters, or the points of a front")->excludes(json);
  add_write(*optimize, "optimum", options);
  optimize
      ->add_option("--time-limit", options.time_limit,
                   "end the search after this time with the best design so far: \"10 min\", \"2 h\", or seconds")
      ->check(not_empty);
  add_picture(*optimize, "front", options);
  add_strict(optimize, options);
}

void add_select(CLI::App& app, Options& options) {
  CLI::App* select = add_command(
      app, "select", "the mounts of a catalogue with the largest least margin of all requirements", options);
  select->add_option("--most", options.most, "number of combinations listed")
      ->capture_default_str()
      ->check(at_least_one);
  select->add_option("--by", options.by, "margin, or of those that meet every requirement the isolation, price or mass")
      ->capture_default_str()
      ->check(CLI::IsMember({"margin", "isolation", "price", "mass"}));
  select->add_flag("--json", options.json, "JSON, SI");
  add_write(*select, "best mounts", options);
  add_strict(select, options);
}

void add_export(CLI::App& app, Options& options) {
  CLI::App* exported =
      add_command(app, "export", "matrices and answers in files of other programs, notes on what these lose", options);
  std::string formats;
  for (const trivet::exports::Format& format : trivet::exports::formats())
    formats += std::string("\n  ") + format.name + ": " + format.about;
  exported->add_option("--to", options.format, "format:" + formats)->required();
  exported->add_option("-o,--output", options.output, "file, or folder of files")->required()->check(not_empty);
  exported
      ->add_option("--what", options.what,
                   "matrices and questions, as in matrices,modes,response; default: what the format and the file "
                   "have")
      ->check(not_empty);
  exported->add_option("--case", options.case_name, "a case of the file instead of the base model")->check(not_empty);
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Vibration of bodies on real elastic elements");
  app.set_version_flag("--version", std::string("trivet ") + trivet::foundation::version());
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 something could not be computed, 2 the input is wrong, 128 + n ended by signal n, 141 the "
      "output pipe was closed; with --strict also 3 and 4, see run --help.");
  add_strict(
      add_command(app, "run", "all analyses of the file: tables on the screen, numbers and report.html in a folder",
                  options),
      options)
      ->add_option("-o,--output", options.output, "result folder")
      ->capture_default_str();
  CLI::App* check = add_command(app, "check", "check a project file and list all its problems", options);
  check->add_flag("--deep", options.deep, "compare the solver with a second, independent one");
  check->add_flag("--json", options.json, "JSON");
  add_strict(check, options);
  for (const trivet::study::AskedQuestion& question : trivet::study::asked_questions())
    add_strict(add_answer(app, question.name, question.about, options), options);
  app.get_subcommand("steady")
      ->add_option(
          "--at", options.at,
          "state the harmonics of all motions found there: \"12 Hz\" or \"750 rpm\", or several: 75,80 in rad/s")
      ->check(not_empty);
  app.get_subcommand("steady")->add_flag("--deep", options.deep, "judge the stability of every point in two ways");
  add_modes_options(app, options);
  add_response_options(app, options);
  add_explain(app, options);
  add_suspension(app, options);
  add_map(app, options);
  add_verdict(app, options);
  add_optimize(app, options);
  add_select(app, options);
  add_element(app, options);
  add_export(app, options);
  app.add_subcommand("new", "a commented starter file");
  app.add_subcommand("schema", "the JSON Schema of the project file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::RequiredError& error) {
    if (!app.get_subcommands().empty() || argc < 2 || argv[1][0] == '-') return said_by_parser(app, error);
    refuse_command(app, argv[1]);
    return trivet::cli::wrong_input;
  } catch (const CLI::ParseError& error) {
    return said_by_parser(app, error);
  }
  return trivet::cli::exit_code(dispatch(app, options));
}

}  // namespace

int main(int argc, char** argv) {
  trivet::foundation::keep_freed_memory();
  trivet::cli::occupy_closed_streams();
  trivet::cli::end_cleanly_on_signals();
  // OpenBLAS, which is loaded for large models, would start threads that wait actively although only one is used.
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    trivet::cli::write_failure(error);
    return trivet::cli::not_computed;
  }
}
