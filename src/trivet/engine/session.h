// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trivet/engine/command.h"
#include "trivet/engine/request.h"
#include "trivet/engine/result.h"

/// The one door to everything the program can do with a project: the command line, Python, and pages open a session and
/// ask it.
namespace trivet::engine {

/// Name of a project that came from standard input, in its messages.
inline constexpr const char* standard_input = "standard input";

/// A project file, or a text in its place.
struct Source {
  std::string name;                      ///< of the file; of a text, the name in its messages
  std::optional<std::string> text = {};  ///< instead of that of the file
  std::string folder = {};               ///< to which names of files are relative; empty: the folder of `name`
};

/// A project that passed its checks. It does not change, and it may be asked on several threads at once; copies share
/// everything. A result keeps what it refers to, so it may outlive its session.
class Session {
 public:
  /// @param settings  changes of the file: "elements.mount.scale = 1.5"
  /// @param only_for  errors in tables that this request does not look at are ignored; the session is then good for
  /// this request alone
  [[nodiscard]] static foundation::Expected<Session> open(const Source& source,
                                                          const std::vector<std::string>& settings = {},
                                                          const Request* only_for = nullptr);

  /// The project with these changes of its file in place of the earlier ones; the same as opening it so, but only what
  /// moved is read again, and files are not.
  [[nodiscard]] foundation::Expected<Session> changed(const std::vector<std::string>& settings) const;

  /// The result of a command. Data that are wrong are errors of the result, nothing is thrown for them.
  /// @throws foundation::Interrupted from the progress, std::bad_alloc, std::system_error of files
  [[nodiscard]] Result ask(const Request& request, const foundation::Progress& progress = {}) const;

  /// The bodies, elements, excitations, foundations, points, limits of a case as data. @throws foundation::InvalidInput
  /// with the nearest name if there is no such case
  [[nodiscard]] const project::Case& model(const std::string& case_name = "") const;
  /// The same as JSON, as results.json has it (docs/json.md).
  [[nodiscard]] std::string model_json(const std::string& case_name = "") const;

  [[nodiscard]] const std::string& title() const { return project_->title; }
  [[nodiscard]] const std::string& source() const { return project_->source; }
  [[nodiscard]] const std::vector<std::string>& settings() const { return settings_; }
  /// The text of the project file.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Names of the cases, the base model "" first.
  [[nodiscard]] std::vector<std::string> case_names() const;
  /// Names of the elements of the base model.
  [[nodiscard]] std::vector<std::string> element_names() const;
  /// A hash, equal for projects of equal content, also of the files that they name: as they were when the project was
  /// opened; of a changed one when this is first called. Empty with `only_for`.
  [[nodiscard]] const std::string& content() const;
  /// The text with the settings for a file; comments, order and format stay. @param target  the file: names of files
  /// become relative to its folder; empty: stay
  [[nodiscard]] foundation::Expected<std::string> text_with_settings(const std::string& target = "") const;

 private:
  Session() = default;
  static Session of(project::Project project, std::string text, const std::vector<std::string>& settings);

  struct Content;

  std::string text_;
  std::vector<std::string> settings_;
  std::shared_ptr<const project::Project> project_;
  std::shared_ptr<SolvedCases> solved_;
  std::shared_ptr<Content> content_;
};

/// Does the request have a key that asks about no project, such as the status of a study folder?
[[nodiscard]] bool is_without_project(const Request& request);
/// The result of such a request; its other keys are errors.
[[nodiscard]] Result ask_without_project(const Request& request);

}  // namespace trivet::engine
