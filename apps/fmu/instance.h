// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fmu/phase.h"
#include "fmu/saved_state.h"
#include "fmu/simulation.h"

namespace trivet::fmu {

enum class Outcome { ok, warning, error };

/// Passes a message to the importer; the category is one of `log_categories`.
using Log = std::function<void(Outcome, const char* category, const std::string& message)>;

namespace log_category {
inline constexpr const char *events = "logEvents", *warnings = "logStatusWarning", *errors = "logStatusError";
}

/// One instance of the unit. Instances share nothing, so that each may be used by its own thread.
class Instance {
 public:
  Instance(InterfaceKind kind, LinearModel model, Log log);

  [[nodiscard]] InterfaceKind kind() const { return kind_; }
  [[nodiscard]] Phases phase() const { return phase_; }
  void enter(Phases phase) { phase_ = phase; }
  [[nodiscard]] Simulation& simulation() { return simulation_; }
  [[nodiscard]] const LinearModel& model() const { return simulation_.model(); }

  /// Errors and warnings are always reported, events only if they are switched on.
  void report_events(bool on) { reports_events_ = on; }
  void report_event(const std::string& message);
  void report_warning(const std::string& message);
  void report_error(const std::string& message);
  [[nodiscard]] std::size_t warnings() const { return warnings_; }

  void advance(double from, double step);
  void reset();

  /// Copies of the state, which stay valid until they are forgotten or the instance ends. All functions throw
  /// std::runtime_error if a pointer is not such a copy.
  void* save(void* earlier);  ///< @param earlier  copy to overwrite, or null for a new one
  void restore(void* saved);
  void forget(void* saved);
  [[nodiscard]] std::string bytes(void* saved) const;
  [[nodiscard]] void* save_bytes(const std::string& bytes, void* earlier);

 private:
  [[nodiscard]] SavedState& known(void* saved) const;
  void* store(SavedState state, void* earlier);

  InterfaceKind kind_;
  Phases phase_ = phase::instantiated;
  Simulation simulation_;
  Log log_;
  bool reports_events_ = false;
  std::size_t warnings_ = 0;
  std::vector<std::unique_ptr<SavedState>> saved_;
};

}  // namespace trivet::fmu
