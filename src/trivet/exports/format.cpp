// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "trivet/exports/format_table.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::exports {
namespace {

const Format& format_of(const std::string& name) {
  const std::vector<Format>& all = formats();
  const auto found = std::ranges::find(all, name, &Format::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  std::string list;
  for (const Format& format : all) {
    names.emplace_back(format.name);
    list += (list.empty() ? "" : ", ") + names.back();
  }
  const std::string guess = foundation::nearest_name(name, names);
  throw foundation::InvalidInput("format \"" + name + "\": not known, or not built in; " +
                                 (guess.empty() ? "known are " + list : "did you mean \"" + guess + "\"?"));
}

/// @throws foundation::InvalidInput for groups that the format cannot hold
void require_enough_memory(const Format& format, const std::vector<std::string>& what) {
  if (format.fixed && !what.empty())
    throw foundation::InvalidInput(std::string("what: the format ") + format.name +
                                   " has a fixed content; leave it out");
  for (const std::string& name : what) {
    const std::vector<std::string>& groups = format.groups;
    if (groups.empty() || std::ranges::find(groups, name) != groups.end()) continue;
    throw foundation::InvalidInput(fmt::format("what: the format {} holds no \"{}\", only {}; take excel, hdf5 or csv",
                                               format.name, name, fmt::join(groups, " and ")));
  }
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> all = {
#define TRIVET_FORMAT(name) name##_format,
      TRIVET_FORMATS(TRIVET_FORMAT)
#undef TRIVET_FORMAT
  };
  return all;
}

std::vector<std::string> export_project(const project::Project& project, const project::Case& variant,
                                        const std::string& format_name, const std::vector<std::string>& what,
                                        const std::filesystem::path& path, const foundation::Progress& progress) {
  const Format& format = format_of(format_name);
  require_known(what);
  require_enough_memory(format, what);
  const Target target(path, format.kind, format.side);
  const Content found =
      format.fixed ? Content{project, variant, {}, {}} : content(project, variant, what, format.groups, progress);
  std::vector<std::string> notes = found.notes;
  const std::vector<std::string> lost = format.write(found, target, progress);
  notes.insert(notes.end(), lost.begin(), lost.end());
  target.publish();
  return notes;
}

}  // namespace trivet::exports
