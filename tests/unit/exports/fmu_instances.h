// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include "fmu/fmi2_interface.h"
#include "fmu/fmi3_interface.h"
#include "trivet/exports/linear_system.h"
#include "trivet/foundation/temporary_folder.h"
#include "two_masses.h"

namespace trivet::test {

using Messages = std::vector<std::string>;

inline void log_2(void* messages, const char*, fmi2Status, const char* category, const char* message, ...) {
  static_cast<Messages*>(messages)->push_back(std::string(category) + ": " + message);
}
inline void log_3(void* messages, fmi3Status, const char* category, const char* message) {
  static_cast<Messages*>(messages)->push_back(std::string(category) + ": " + message);
}

/// A folder of resources with the system of two masses: inputs 1 to 3, outputs 4 and 5, states 6 to 9, derivatives 10
/// to 13.
class FmuResources {
 public:
  FmuResources() { std::ofstream(folder_.path() / "system.txt") << exports::system_text(two_masses(), "{token}"); }
  [[nodiscard]] std::string path() const { return folder_.path().string(); }

  [[nodiscard]] fmi2Component new_2(fmi2Type type, bool reports_events = false) {
    const fmi2CallbackFunctions functions = {log_2, nullptr, nullptr, nullptr, &messages};
    return fmi2Instantiate("unit", type, "{token}", ("file://" + path()).c_str(), &functions, fmi2False,
                           reports_events ? fmi2True : fmi2False);
  }
  /// After initialization at time 0.
  [[nodiscard]] fmi2Component started_2(fmi2Type type, bool reports_events = false) {
    const fmi2Component c = new_2(type, reports_events);
    fmi2SetupExperiment(c, fmi2False, 0, 0, fmi2False, 0);
    fmi2EnterInitializationMode(c);
    fmi2ExitInitializationMode(c);
    return c;
  }
  [[nodiscard]] fmi3Instance new_3_co_simulation() {
    return fmi3InstantiateCoSimulation("unit", "{token}", path().c_str(), false, false, false, false, nullptr, 0,
                                       &messages, log_3, nullptr);
  }
  [[nodiscard]] fmi3Instance new_3_model_exchange() {
    return fmi3InstantiateModelExchange("unit", "{token}", path().c_str(), false, false, &messages, log_3);
  }

  Messages messages;

 private:
  foundation::TemporaryFolder folder_;
};

inline std::vector<double> values_2(fmi2Component c, const std::vector<fmi2ValueReference>& references) {
  std::vector<double> values(references.size());
  fmi2GetReal(c, references.data(), references.size(), values.data());
  return values;
}
inline std::vector<double> values_3(fmi3Instance instance, const std::vector<fmi3ValueReference>& references) {
  std::vector<double> values(references.size());
  fmi3GetFloat64(instance, references.data(), references.size(), values.data(), values.size());
  return values;
}

inline const std::vector<unsigned> fmu_inputs = {1, 2, 3}, fmu_outputs = {4, 5}, fmu_states = {6, 7, 8, 9},
                                   fmu_derivatives = {10, 11, 12, 13};

}  // namespace trivet::test
