// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_reader.h"

#include <utility>

#include "trivet/project/analyses/request_readers.h"

namespace trivet::project {
namespace {

const std::vector<std::string>& excitations_for(Drive drive, const SymbolTable& symbols) {
  switch (drive) {
    case Drive::random:
      return symbols.random_excitations;
    case Drive::time:
      return symbols.time_excitations;
    case Drive::orders:
      return symbols.order_excitations;
    case Drive::harmonic_or_orders:
      return symbols.harmonic_excitations.empty() ? symbols.order_excitations : symbols.harmonic_excitations;
    case Drive::harmonic:
    case Drive::none:
      break;
  }
  return symbols.harmonic_excitations;
}

}  // namespace

const std::vector<AnalysisReader>& analysis_readers() {
#define TRIVET_READER(name) named(#name, name##_analysis),
  static const std::vector<AnalysisReader> list = {TRIVET_ANALYSES(TRIVET_READER)};
#undef TRIVET_READER
  return list;
}

std::vector<std::pair<std::string, const Analysis&>> independent_analyses(const Analyses& request) {
  std::vector<std::pair<std::string, const Analysis&>> list;
  for (const AnalysisReader& reader : analysis_readers())
    if (const Analysis* analysis = reader.of(request)) list.emplace_back(reader.name, *analysis);
  return list;
}

void read_independent_analyses(TableReader& owner, const bool at_top, const ResultNames& names,
                               const SymbolTable& symbols, Analyses& result) {
  for (const AnalysisReader& analysis : analysis_readers()) {
    const Node* table = analysis.at_top == at_top ? owner.table(analysis.name) : nullptr;
    if (!table) continue;
    const bool driven = analysis.drive == Drive::none || (analysis.moves_by_itself && analysis.moves_by_itself(*table));
    if (!driven && excitations_for(analysis.drive, symbols).empty())
      owner.error(analysis.name, missing_excitation(analysis.drive).finding, "this analysis needs one",
                  missing_excitation(analysis.drive).remedy);
    TableReader reader(*table, table_path(analysis.name), owner.problems());
    analysis.read(reader, names, symbols, result);
    reader.finish();
  }
}

void check_analyses(const model::System& system, const Analyses& request,
                    const std::function<bool(const std::string&)>& computed, foundation::Problems& problems) {
  refuse_left_out_results(system, request, problems);
  for (const AnalysisReader& reader : analysis_readers())
    if (reader.of(request) && reader.check && computed(reader.name)) reader.check(request, system, problems);
}

}  // namespace trivet::project
