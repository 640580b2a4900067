// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/permitted_files.h"

#include <algorithm>
#include <system_error>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/unopened_text.h"

namespace trivet::server {
namespace {

namespace fs = std::filesystem;
using project::FileName;

fs::path without_links(const fs::path& file) {
  std::error_code error;
  fs::path found = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? fs::path() : found;
}

bool is_hidden(const fs::path& relative) {
  return std::ranges::any_of(relative, [](const fs::path& part) { return part.native().starts_with('.'); });
}

}  // namespace

PermittedFiles::PermittedFiles(const std::string& project_file, const std::string& text)
    : given_folder_(fs::path(project_file).parent_path()), folder_(without_links(project_file).parent_path()) {
  for (const FileName& name : project::files_named_in_tables(text, project_file))
    named_.insert(without_links(name.file));
}

bool PermittedFiles::permits(const fs::path& file) const {
  if (folder_.empty()) return false;
  const fs::path found = without_links(file);
  if (found.empty()) return false;
  if (named_.contains(found)) return true;
  const fs::path relative = found.lexically_relative(folder_);
  return !relative.empty() && !is_hidden(relative);  // "../other" begins with a dot, too
}

foundation::Problems PermittedFiles::refused(const std::vector<FileName>& names) const {
  foundation::Problems problems;
  for (const FileName& name : names)
    if (!permits(name.file))
      problems
          .error(name.path, foundation::quoted(name.text.substr(0, 200)),
                 "a page may name files in the folder of the project, and those that the saved file names",
                 "copy it there, or name it in the file with an editor and open the page again")
          .origin = name.origin;
  return problems;
}

foundation::Problems PermittedFiles::refused_in_text(const std::string& text, const std::string& source) const {
  foundation::Problems problems = refused(project::files_named_in_text(text, source));
  return problems.has_errors() ? problems : refused(project::files_named_in_tables(text, source));
}

foundation::Problems PermittedFiles::refused_in_settings(const std::vector<std::string>& settings) const {
  return refused(project::files_named_in_settings(settings, given_folder_));
}

}  // namespace trivet::server
