// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/program.h"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "trivet/exports/format.h"
#include "trivet/foundation/freed_memory.h"
#include "trivet/foundation/message_list.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/setting_words.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/foundation/version.h"
#include "trivet/project/schema.h"
#include "trivet/project/text/embedded_text.h"
#include "trivet/project/text/source_file.h"

namespace trivet::engine {

std::string version() { return foundation::version(); }
void keep_freed_memory() { foundation::keep_freed_memory(); }
void remove_leftovers() { foundation::remove_leftovers(); }
std::string starter_text() { return project::starter_text(); }
std::string project_schema() { return project::project_schema(); }
foundation::Expected<std::string> read_source(const std::string& file) { return project::read_source(file); }

std::vector<std::pair<std::string, std::string>> export_formats() {
  std::vector<std::pair<std::string, std::string>> list;
  for (const exports::Format& format : exports::formats()) list.emplace_back(format.name, format.about);
  return list;
}

std::string message_list(const foundation::Problems& problems) { return foundation::message_list(problems); }

foundation::Problem with_word_of_settings(const foundation::Problem& problem, std::string_view word) {
  return foundation::with_word_of_settings(problem, word);
}
std::string on_one_line(std::string_view text) { return foundation::on_one_line(text); }
std::string quoted(std::string_view text) { return foundation::quoted(text); }

std::string failure_words(const std::exception& failure) {
  std::string words = failure.what();
  if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&failure))
    words = of_file->path1().string() + (of_file->path1().empty() ? "" : ": ") + of_file->code().message();
  else if (const auto* of_system = dynamic_cast<const std::system_error*>(&failure))
    words = of_system->code().message();
  else if (dynamic_cast<const std::bad_alloc*>(&failure) || dynamic_cast<const std::length_error*>(&failure))
    words = "not enough memory; request fewer points, results or cases at once";
  return foundation::on_one_line(words);
}

}  // namespace trivet::engine
