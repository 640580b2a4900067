// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/drive.h"

#include <algorithm>

#include "trivet/project/analyses/analysis_reader.h"

namespace trivet::project {

Drive drive_of(const std::string& analysis) {
  for (const AnalysisReader& reader : analysis_readers())
    if (reader.name == analysis) return reader.drive;
  return Drive::harmonic;
}

std::string table_path(const std::string& analysis) {
  for (const AnalysisReader& reader : analysis_readers())
    if (reader.at_top && reader.name == analysis) return analysis;
  return "analyses." + analysis;
}

bool drives(const model::Excitation& excitation, Drive drive) {
  switch (drive) {
    case Drive::harmonic:
      return std::holds_alternative<model::Harmonic>(excitation.course);
    case Drive::random:
      return std::holds_alternative<model::Random>(excitation.course);
    case Drive::time:
      return std::holds_alternative<model::History>(excitation.course);
    case Drive::orders: {  // an unbalance is order 1
      const auto* harmonic = std::get_if<model::Harmonic>(&excitation.course);
      return std::holds_alternative<model::Orders>(excitation.course) ||
          (harmonic && harmonic->power_of_frequency == 2);
    }
    case Drive::harmonic_or_orders:
      return drives(excitation, Drive::harmonic) || drives(excitation, Drive::orders);
    case Drive::none:
      break;
  }
  return false;
}

bool is_driven(const model::System& system, Drive drive) {
  const auto& excitations = system.description().excitations;
  return std::ranges::any_of(excitations,
                             [&](const model::Excitation& excitation) { return drives(excitation, drive); });
}

MissingExcitation missing_excitation(Drive drive) {
  switch (drive) {
    case Drive::random:
      return {"no random excitation in the model", "add [excitations.NAME] with type = \"random\""};
    case Drive::time:
      return {"no time excitation in the model", "add [excitations.NAME] with type = \"time\""};
    case Drive::orders:
      return {"no order excitation in the model", "add [excitations.NAME] with type = \"orders\" or \"unbalance\""};
    case Drive::harmonic_or_orders:
      return {"no harmonic or order excitation in the model",
              "add [excitations.NAME] with type = \"harmonic\", \"unbalance\", \"base\" or \"orders\""};
    case Drive::harmonic:
    case Drive::none:
      break;
  }
  return {"no harmonic excitation in the model",
          "add [excitations.NAME] with type = \"harmonic\", \"unbalance\" or \"base\""};
}

}  // namespace trivet::project
