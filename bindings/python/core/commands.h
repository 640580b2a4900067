// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/answer.h"
#include "trivet/project/project.h"

/// The commands of the command line as functions from a project to an answer. They use no Python; each owns the project
/// through its pointer.
namespace trivet::python {

using ProjectPointer = std::shared_ptr<const project::Project>;
using foundation::Progress;

/// The base model (""), or a case. @throws foundation::InvalidInput with the nearest name
[[nodiscard]] const project::Case& case_of(const project::Project& project, const std::string& name);

/// One question of the table of questions.
[[nodiscard]] Answer asked(const ProjectPointer& project, const std::string& question, const std::string& case_name,
                           const Progress& progress);

/// @param nx, ny  designs along the axes instead of those of the file; 0: of the file
[[nodiscard]] Answer mapped(const ProjectPointer& project, const std::string& case_name, int nx, int ny,
                            const Progress& progress);
/// @param by  "margin", "isolation", "price" or "mass"
[[nodiscard]] Answer selected(const ProjectPointer& project, int most, const std::string& by, const Progress& progress);
/// The optimum, or the front if the file asks for one.
[[nodiscard]] Answer optimized(const ProjectPointer& project, const Progress& progress);
[[nodiscard]] Answer judged(const ProjectPointer& project, const Progress& progress);
[[nodiscard]] Answer checked(const ProjectPointer& project, bool deep);
/// Warnings of a case, without those about the analyses of the file: these concern no single question.
[[nodiscard]] foundation::Problems without_unused(const project::Project& project,
                                                  const foundation::Problems& warnings);
[[nodiscard]] Answer explained(const ProjectPointer& project, const std::string& case_name,
                               const std::vector<std::string>& of, int most, const Progress& progress);
/// @param excitations  [rad/s]
[[nodiscard]] Answer suspended(const ProjectPointer& project, const std::string& case_name,
                               const std::vector<std::vector<double>>& torques, const std::vector<double>& excitations);
[[nodiscard]] Answer element(const ProjectPointer& project, const std::string& name, const std::string& case_name,
                             bool all, const Progress& progress);
/// Everything the file asks for, written to a folder. @returns the answers of each case: their warnings and text
[[nodiscard]] std::vector<Answer> ran(const ProjectPointer& project, const std::string& folder,
                                      const Progress& progress);

/// Files of other programs. @returns notes on what is lost
[[nodiscard]] std::vector<std::string> exported(const ProjectPointer& project, const std::string& format,
                                                const std::string& target, const std::vector<std::string>& what,
                                                const std::string& case_name, const Progress& progress);

}  // namespace trivet::python
