// SPDX-License-Identifier: BSD-3-Clause
#include "core/answers.h"

#include <nanobind/stl/string.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/task.h"
#include "trivet/engine/answer.h"
#include "trivet/engine/question.h"
#include "trivet/engine/session.h"

namespace trivet::python {
namespace {

namespace nb = nanobind;
using engine::Session;
using Shared = std::shared_ptr<const Session>;

/// A project and its session with the last settings, so that a slider costs `Session::changed` alone. Thread-safe.
class ChangedProject {
 public:
  ChangedProject(Session project, std::string folder) : project_(std::move(project)), folder_(std::move(folder)) {}

  [[nodiscard]] engine::Questioned with(const std::vector<std::string>& settings) const {
    return {.session = changed(settings), .only_for = [this, settings](const engine::Request& want) {
              return Session::open({project_.source(), project_.text(), folder_}, settings, &want);
            }};
  }

 private:
  [[nodiscard]] foundation::Expected<Shared> changed(const std::vector<std::string>& settings) const {
    {
      const std::scoped_lock guard(lock_);
      if (last_ && last_->settings() == settings) return last_;
    }
    auto session = project_.changed(settings);
    if (!session) return tl::make_unexpected(std::move(session.error()));
    auto shared = std::make_shared<const Session>(std::move(*session));
    const std::scoped_lock guard(lock_);
    last_ = shared;
    return shared;
  }

  const Session project_;
  const std::string folder_;
  mutable std::mutex lock_;
  mutable Shared last_;
};

/// Shared with the work that computes an answer, which may outlive its caller.
class Answers {
 public:
  Answers(const Session& project, const std::string& folder)
      : project_(std::make_shared<const ChangedProject>(project, folder)) {}

  [[nodiscard]] std::string answer(const std::string& question) const {
    const auto text = std::make_shared<std::string>();
    engine::Question asked = engine::read_question(question);
    if (asked.text) throw foundation::InvalidInput("\"text\" is no key of a question to a widget, whose file is fixed");
    run_task({.name = "answer"}, [project = project_, text, asked = std::move(asked)](const auto& report) {
      *text = engine::answer_json(asked, project->with(asked.settings), report);
    });
    return *text;
  }

 private:
  std::shared_ptr<const ChangedProject> project_;
};

}  // namespace

void bind_answers(nb::module_& module) {
  nb::class_<Answers>(module, "Answers", "Answers to the questions of a widget about one project.")
      .def(nb::init<const Session&, const std::string&>(), nb::arg("project"), nb::arg("folder"),
           "folder: to which names of files are relative")
      .def("answer", &Answers::answer, nb::arg("question"),
           "The answer to a question of the page, both as JSON (/ask in docs/serve.md). Its settings take the place of "
           "those of the project. It has no text.");
}

}  // namespace trivet::python
