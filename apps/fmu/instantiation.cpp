// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/instantiation.h"

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "fmu/guarded_call.h"
#include "fmu/resource_folder.h"

namespace trivet::fmu {

Instance* new_instance(InterfaceKind kind, const char* token, const std::function<std::string()>& folder,
                       const Log& log, bool reports_events) noexcept {
  try {
    const std::string wanted = &place(token, "the token");
    LinearModel model = linear_model(text_in_folder(folder(), "system.txt"));
    if (model.token != wanted)
      throw std::runtime_error("the token \"" + wanted + "\" is not that of the resources, \"" + model.token + "\"");
    auto instance = std::make_unique<Instance>(kind, std::move(model), log);
    instance->report_events(reports_events);
    instance->report_event("instantiated with " + std::to_string(instance->model().states()) + " states");
    return instance.release();
  } catch (const std::exception& error) {
    try_to_report([&] { log(Outcome::error, log_category::errors, std::string("instantiation: ") + error.what()); });
  } catch (...) {
    try_to_report([&] { log(Outcome::error, log_category::errors, "instantiation: unknown failure"); });
  }
  return nullptr;
}

}  // namespace trivet::fmu
