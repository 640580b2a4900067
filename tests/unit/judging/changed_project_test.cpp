// SPDX-License-Identifier: BSD-3-Clause
// A changed project is the project that its text gives with the same settings: models, warnings, places and errors.
#include <gmock/gmock.h>

#include <cctype>

#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/read_project.h"

namespace changed_project_test {

using namespace trivet;

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Path of a value of the model, and its value as a setting writes it.
struct Value {
  std::string path;
  const project::Node* node;
};

void list_values(const project::Node& node, const std::string& path, std::vector<Value>& values) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const project::Node& item = node.items[i];
    if (node.kind != project::Node::Kind::table) return;
    const std::string here = (path.empty() ? "" : path + ".") + foundation::path_key(node.keys[i]);
    if (item.kind == project::Node::Kind::table) list_values(item, here, values);
    else if (here != "trivet" && item.kind != project::Node::Kind::array) values.push_back({here, &item});
  }
}

/// Often a good setting, sometimes one that a project rejects.
std::string other_value(const project::Node& node, std::mt19937& random) {
  const auto one_of = [&](const std::vector<std::string>& words) { return words[random() % words.size()]; };
  if (node.kind == project::Node::Kind::boolean) return node.boolean ? "false" : "true";
  if (node.kind == project::Node::Kind::text) {
    const std::size_t end = node.text.find(' ');
    const bool has_unit =
        !node.text.empty() && std::isdigit(static_cast<unsigned char>(node.text[0])) && end != std::string::npos;
    if (has_unit) return "\"" + one_of({"1.1", "0.9", "2", "-1"}) + node.text.substr(end) + "\"";
    return one_of({"\"nonsense\"", "\"" + node.text + "\"", "1.5"});
  }
  return std::to_string(node.number * std::stod(one_of({"1.01", "0.9", "1.5", "1", "-1", "1000"})));
}

using Said =
    std::tuple<foundation::Severity, std::string, std::string, std::string, std::string, std::string, int, int>;

std::vector<Said> said(const foundation::Problems& problems) {
  std::vector<Said> all;
  for (const foundation::Problem& p : problems.list())
    all.emplace_back(p.severity, p.subject, p.finding, p.rule, p.remedy, p.origin.source, p.origin.line,
                     p.origin.column);
  return all;
}

void expect_same_quantities(const project::Node& a, const project::Node& b, const std::string& path) {
  EXPECT_EQ(a.quantity, b.quantity) << path;
  ASSERT_EQ(a.items.size(), b.items.size()) << path;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    expect_same_quantities(a.items[i], b.items[i], path + "." + (i < a.keys.size() ? a.keys[i] : std::to_string(i)));
}

void expect_same(const project::Case& changed, const project::Case& read) {
  EXPECT_EQ(changed.name, read.name);
  EXPECT_EQ(changed.changes, read.changes);
  EXPECT_EQ(said(changed.warnings), said(read.warnings));
  EXPECT_EQ(project::canonical(changed.written), project::canonical(read.written));
  EXPECT_EQ(project::canonical(changed.document), project::canonical(read.document));
  expect_same_quantities(changed.document, read.document, "");
  const assembly::Assembled a = assembly::assemble(changed.system), b = assembly::assemble(read.system);
  EXPECT_EQ(a.matrices.A, b.matrices.A);
  EXPECT_EQ(a.matrices.B, b.matrices.B);
  EXPECT_EQ(a.matrices.K, b.matrices.K);
}

class ChangedProject : public testing::TestWithParam<const char*> {};

TEST_P(ChangedProject, IsThatOfItsTextWithTheSameSettings) {
  const std::string path = std::string(TRIVET_SOURCE_DIR) + "/" + GetParam(), text = text_of(path);
  auto project = judging::project_from_text(text, path);
  ASSERT_TRUE(project.has_value());
  std::vector<Value> values;
  list_values(project->parsed->document, "", values);
  std::mt19937 random(20261128);
  int accepted = 0, rejected = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<std::string> settings;
    for (std::size_t i = 0; i < 1 + random() % 2; ++i) {
      const Value& value = values[random() % values.size()];
      settings.push_back(value.path + " = " + other_value(*value.node, random));
    }
    SCOPED_TRACE(testing::PrintToString(settings));
    const auto changed = judging::changed_project(*project, settings);
    const auto read = judging::project_from_text(text, path, settings);
    ASSERT_EQ(changed.has_value(), read.has_value());
    if (!read) {
      EXPECT_EQ(said(changed.error()), said(read.error()));
      ++rejected;
      continue;
    }
    ++accepted;
    EXPECT_EQ(changed->title, read->title);
    EXPECT_EQ(changed->sha256, read->sha256);
    EXPECT_EQ(changed->settings, read->settings);
    EXPECT_EQ(said(changed->unused_parts), said(read->unused_parts));
    ASSERT_EQ(changed->cases.size(), read->cases.size());
    for (std::size_t i = 0; i < read->cases.size(); ++i) expect_same(changed->cases[i], read->cases[i]);
    if (random() % 2 == 0) project = std::move(*changed);  // later changes are of a changed project
  }
  EXPECT_GT(accepted, 4);
  EXPECT_GT(rejected, 4);
}

// The samples have warnings of reading a part.
INSTANTIATE_TEST_SUITE_P(Files, ChangedProject,
                         testing::Values("examples/genset/genset.toml", "examples/genset/load_cases.toml",
                                         "examples/genset/mounts.toml", "examples/paper/map.toml",
                                         "examples/snubber/genset.toml", "examples/measured_mount/motor.toml",
                                         "examples/two_stage/pump_on_raft.toml", "examples/hydromount/engine.toml",
                                         "examples/powertrain/decoupled.toml", "examples/rubber_mounts/compressor.toml",
                                         "tests/samples/solids_with_a_warning.toml",
                                         "tests/samples/rubber_disc_with_a_warning.toml"));

}  // namespace changed_project_test
