// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/unopened_text.h"

#include "trivet/foundation/plain_text.h"
#include "trivet/project/settings.h"
#include "trivet/project/text/part_tables.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/toml_text.h"

namespace trivet::project {
namespace {

void add_file_names(const Node& node, const std::string& path, std::vector<FileName>& names) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node& item = node.items[i];
    const bool is_table = node.kind == Node::Kind::table;
    const std::string here = is_table ? (path.empty() ? "" : path + ".") + foundation::path_key(node.keys[i]) : path;
    if (is_table && item.kind == Node::Kind::text && is_file_key(node.keys[i]))
      names.push_back({here, item.text, named_file(item), item.origin});
    add_file_names(item, here, names);
  }
}

}  // namespace

std::string title_in_text(const std::string& text, const std::string& source) {
  const auto document = parse_toml(text, source);
  const Node* title = document ? document->find("title") : nullptr;
  return title && title->kind == Node::Kind::text ? title->text : "";
}

std::vector<FileName> files_named_in_text(const std::string& text, const std::string& source) {
  std::vector<FileName> names;
  if (const auto document = parse_toml(text, source)) add_file_names(*document, "", names);
  return names;
}

std::vector<FileName> files_named_in_tables(const std::string& text, const std::string& source) {
  auto document = parse_toml(text, source);
  if (!document) return {};
  std::vector<FileName> names;
  foundation::Problems reported_when_read;
  add_file_names(*document, "", names);
  put_tables_in_place(*document, reported_when_read);
  add_file_names(*document, "", names);
  return names;
}

std::vector<FileName> files_named_in_settings(const std::vector<std::string>& settings,
                                              const std::filesystem::path& folder) {
  std::vector<FileName> names;
  foundation::Problems reported_when_read;
  for (const Node& change : read_settings(settings, folder, reported_when_read).changes)
    add_file_names(change, "", names);
  return names;
}

}  // namespace trivet::project
