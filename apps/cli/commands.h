// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "trivet/project/project.h"
#include "trivet/project/questions.h"
#include "trivet/results/picture_file.h"
#include "trivet/study/answers.h"

namespace trivet::cli {

/// Options of the command line.
struct Options {
  std::string project;
  std::string case_name;
  std::vector<std::string> settings;
  bool json = false;
  bool csv = false;
  bool deep = false;
  bool strict = false;
  std::string at;
  std::string band;
  std::string element;
  bool all = false;
  std::string picture;
  std::string output = "trivet-results";
  std::vector<std::string> of;
  int most = 10;
  std::string by = "margin";
  int lowest = 0;  ///< modes; 0: those of the file, or all
  std::string torque;
  std::string excitations;
  std::string points;
  std::string write;       ///< project file with the best design
  std::string time_limit;  ///< of a search: "10 min"
  std::string format, what;
};

/// Each returns the exit code.
int check_command(const Options& options);
int answer_command(const std::string& which, const Options& options);
int element_command(const Options& options);
int run_command(const Options& options);
int explain_command(const Options& options);
int suspension_command(const Options& options);
int map_command(const Options& options);
int verdict_command(const Options& options);
int optimize_command(const Options& options);
int select_command(const Options& options);
int export_command(const Options& options);

/// The command line requests something that the project does not have.
struct BadArgument : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The base model, or the case of this name. @throws BadArgument if there is none
[[nodiscard]] const project::Case& chosen_case(const project::Project& project, const std::string& name);

/// Angular frequencies [rad/s] from "1,2.7,15.6" in rad/s, or each with a unit. @throws BadArgument, naming the option
[[nodiscard]] std::vector<double> frequencies(const std::string& option, const std::string& text);

/// The requested picture file, prepared; nullptr if none was requested. @throws BadArgument if it cannot be written
/// there
[[nodiscard]] std::unique_ptr<results::PictureFile> new_picture(const Options& options);

/// The project; empty if it has errors, which are then printed. Errors in questions that are not requested are ignored.
[[nodiscard]] std::optional<project::Project> read_or_complain(const Options& options,
                                                               const project::Questions& questions = {});

/// Shows problems, on the screen and with --json as JSON; returns the exit code.
int complain(const Options& options, const foundation::Problems& problems);

/// The questions of a command on one case.
[[nodiscard]] project::Questions questions_of(const Options& options, std::vector<std::string> names);

/// Warnings and rigid-body modes, which are part of every answer.
[[nodiscard]] std::string warnings_text(const study::Answers& answers);

}  // namespace trivet::cli
