// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/documents/screen.h"
#include "trivet/engine/findings.h"
#include "trivet/foundation/problems.h"
#include "trivet/project/text/display_units.h"

namespace trivet::engine {

/// Takes a text piece by piece: those of large maps do not fit into the memory as a whole.
using Sink = std::function<void(std::string_view)>;

/// A form of a result, made when it is wanted.
using Writer = std::function<void(const Sink&)>;
using NamedWriters = std::vector<std::pair<std::string, Writer>>;

/// What one command found, in all its forms. Parts that it refers to live as long as it does.
struct Result {
  std::string command;
  std::string case_name;  ///< empty: the base model, or all cases
  std::string title;      ///< of the project

  foundation::Problems errors;  ///< the request is wrong; then there is nothing else
  std::string failure;          ///< why nothing could be computed; then there is nothing else

  foundation::Problems warnings;
  std::vector<std::string> failures;  ///< parts that could not be computed, with the reason
  std::vector<std::string> notes;     ///< free motions, directions that are left out
  std::vector<std::string> changes;   ///< of the best design, as settings: "elements.mount.scale = 1.5"
  std::vector<std::string> remarks;   ///< on files that were written
  std::string not_written;            ///< why files of the request could not be written; empty if they were
  std::string go_on;                  ///< command that goes on where this one has ended early; empty: it has not
  bool complete = true;               ///< false: a part could not be computed, or ended early
  Findings findings;

  /// Described once, in the units of a display; a view of what the result holds. Empty: no document describes it.
  std::function<documents::Document(const project::DisplayUnits& display)> document = {};
  // Its forms: those of the document, or its own.
  Writer json = {};
  Writer text = {};
  project::DisplayUnits display = {};  ///< of the model: units of `text`
  /// Tables and sentences as a part of a page; empty: it has none.
  std::function<std::string(const project::DisplayUnits& display)> html = {};
  /// The text with the units of another [display]; empty: it has no units that can change.
  std::function<std::string(const project::DisplayUnits& display)> text_in = {};
  /// The text fitted to a screen, a summary of it unless it is wanted in full; empty: there is only the whole text.
  std::function<std::string(const documents::Screen& screen)> text_on = {};
  NamedWriters tables = {};   ///< "random.csv", CSV; --csv prints the first
  NamedWriters figures = {};  ///< "front.svg", SVG
  std::function<documents::LabelledArrays()> arrays = {};
  /// The columns of one of its tables in the units of [display]; empty: its tables are not converted.
  std::function<std::vector<documents::TypedColumn>(const std::string& table, const project::DisplayUnits& display)>
      columns = {};
  std::vector<Result> cases = {};  ///< of `run`: the results of each case

  std::shared_ptr<const void> held = {};  ///< what the arrays refer to

  /// A file could not be written; the result is there nevertheless, and not complete.
  void add_not_written(const std::string& reason);
};

/// The whole text of a form.
[[nodiscard]] std::string whole(const Writer& writer);

/// The warnings of a result, but for those that its failures state.
[[nodiscard]] foundation::Problems shown_warnings(const Result& result);
/// Failures and notes of a result for the screen, before its text; empty without any.
[[nodiscard]] std::string remarks_before(const Result& result);
/// Warnings, failures and notes of a result in one text, before it; empty without any.
[[nodiscard]] std::string preface(const Result& result);

/// The errors of a project or a request as JSON: {"ok", "problems"}.
[[nodiscard]] std::string errors_json(const foundation::Problems& errors);

/// @param strict  findings count, too
[[nodiscard]] Outcome outcome(const Result& result, bool strict);

}  // namespace trivet::engine
