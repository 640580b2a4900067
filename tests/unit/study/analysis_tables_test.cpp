// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/study/analyses/analysis_commands.h"
#include "trivet/study/analyses/analysis_run.h"

namespace analysis_tables_test {

using namespace trivet;

TEST(AnalysisTables, WriteTheResultOfEveryAnalysis) {
  std::vector<std::string> written;
  for (const results::ResultWriter& writer : results::result_writers()) {
    written.emplace_back(writer.name);
    EXPECT_FALSE(writer.tables.empty()) << writer.name << " has no table for --csv";
  }
  for (const study::AnalysisCommand& analysis : study::analysis_commands()) {
    EXPECT_THAT(written, testing::Contains(analysis.name));
    EXPECT_EQ(&study::analysis_command(analysis.name), &analysis);
  }
  EXPECT_ANY_THROW(static_cast<void>(study::analysis_command("weather")));
}

#define TRIVET_NAME(name) #name,
const std::vector<std::string> table = {TRIVET_ANALYSES(TRIVET_NAME)};
#undef TRIVET_NAME

template <typename Rows>
std::vector<std::string> names(const Rows& rows) {
  std::vector<std::string> result;
  for (const auto& row : rows) result.emplace_back(row.name);
  return result;
}

TEST(AnalysisTables, ReadRunAndWriteEachAnalysisUnderItsName) {
  EXPECT_EQ(names(project::analysis_readers()), table);
  EXPECT_EQ(names(study::analysis_runs()), table);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto& writers = results::result_writers();
    EXPECT_TRUE(std::ranges::any_of(writers, [&](const results::ResultWriter& writer) {
      return writer.name == table[i];
    })) << table[i];
    project::Analyses requested;
    EXPECT_FALSE(study::analysis_runs()[i].request({}, requested)) << table[i];
    ASSERT_EQ(project::independent_analyses(requested).size(), 1) << table[i];
    EXPECT_EQ(project::independent_analyses(requested).front().first, table[i]);
  }
}

}  // namespace analysis_tables_test
