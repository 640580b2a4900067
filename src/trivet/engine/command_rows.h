// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "trivet/documents/html_table.h"
#include "trivet/engine/command.h"

/// The rows of the table of commands, by what they are about.
namespace trivet::engine {

/// run, export, and matrices, state_space and sweep for programs.
[[nodiscard]] std::vector<Command> whole_commands();
[[nodiscard]] std::vector<Command> data_commands();
/// check, element, scene, suspension, explain
[[nodiscard]] std::vector<Command> machine_commands();
/// One for each analysis of a case.
[[nodiscard]] std::vector<Command> analysis_commands();
/// verdict, map, optimize, sample, box, select
[[nodiscard]] std::vector<Command> design_commands();
[[nodiscard]] Command sample_command();
[[nodiscard]] Command box_command();

/// Something that a result refers to, with the project that it was computed from.
template <typename Found>
struct Held {
  std::shared_ptr<const project::Project> project;
  Found found;
};
template <typename Found>
[[nodiscard]] std::shared_ptr<const Held<Found>> hold(const Task& task, Found found) {
  return std::make_shared<const Held<Found>>(Held<Found>{task.project, std::move(found)});
}

/// A form that is a text as a whole.
template <typename Text>
[[nodiscard]] Writer writer(Text text) {
  return [text = std::move(text)](const Sink& sink) { sink(text()); };
}

/// All forms of a result that a document describes.
/// @param held  what the document refers to
/// @param own  units of the model
/// @param files  its tables; the command line prints the first
/// @param closing  sentences below the text
void set_forms(std::function<documents::Document(const project::DisplayUnits& display)> document,
               std::shared_ptr<const void> held, const project::DisplayUnits& own,
               const std::vector<std::string>& files, Result& result, const std::string& closing = "");

/// Pictures below the tables of a page. @param figures_of  makes them in the units of a display
template <typename FiguresOf>
void add_below_tables(FiguresOf figures_of, Result& result) {
  result.html = [figures_of = std::move(figures_of), tables = result.html](const project::DisplayUnits& display) {
    std::string html = tables(display);
    for (const auto& figure : figures_of(display))
      html += "<figure><div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"" +
          documents::escaped(figure.title) + "\">" + figure.html() + "</div></figure>\n";
    return html;
  };
}

/// The document of a case in the units of a display. @param document_of  makes it of the case with these units
template <typename DocumentOf>
[[nodiscard]] auto in_units(DocumentOf document_of, const project::Case& variant) {
  return [document_of = std::move(document_of), &variant](const project::DisplayUnits& display) {
    if (display == variant.display) return document_of(variant);
    auto shown = std::make_shared<project::Case>(variant);
    shown->display = display;
    documents::Document document = document_of(*shown);
    document.held = shown;
    return document;
  };
}

/// Warnings without those about analyses of the file, which concern no single command.
[[nodiscard]] foundation::Problems without_unused(const project::Project& project,
                                                  const foundation::Problems& warnings);

/// The parts of `run` and of the single analyses that are the same: warnings, notes, failures, findings.
void add_notices(const study::CaseResults& found, Result& result);

/// Tables of the file that a command looks at, with those that decide whether a design is good.
[[nodiscard]] std::vector<std::string> with_judged_tables(std::vector<std::string> tables);
[[nodiscard]] Key picture_key(const std::string& drawn);
[[nodiscard]] Key write_key(const std::string& best);

}  // namespace trivet::engine
