// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include "fmu/instance.h"

/// What every exported function does: check the arguments, do its work, and let no exception reach the importer, which
/// may be written in C.
namespace trivet::fmu {

/// An array of the importer. @throws std::runtime_error if it is null and has elements
template <typename T>
std::span<T> array(T* first, std::size_t count, const char* name) {
  if (first == nullptr && count > 0) throw std::runtime_error(std::string(name) + " is a null pointer");
  return {first, count};
}

/// Where the importer wants a result. @throws std::runtime_error if the pointer is null
template <typename T>
T& place(T* pointer, const char* name) {
  if (pointer == nullptr) throw std::runtime_error(std::string(name) + " is a null pointer");
  return *pointer;
}

/// @throws std::runtime_error if the numbers differ
inline void check_count(std::size_t count, std::size_t needed, const char* name) {
  if (count != needed)
    throw std::runtime_error(std::string(name) + " is " + std::to_string(count) + ", but must be " +
                             std::to_string(needed));
}

/// Calls `report` and ignores a failure, such as a lack of memory, while a failure is reported.
template <typename Report>
void try_to_report(Report report) noexcept {
  try {
    report();
  } catch (...) {
  }
}

/// Does work on an instance, if it is in one of the permitted phases. A failure is reported in its log.
template <typename Work>
Outcome guarded_call(void* pointer, const char* function, Phases permitted, Work work) noexcept {
  if (pointer == nullptr) return Outcome::error;
  Instance& instance = *static_cast<Instance*>(pointer);
  const std::size_t earlier_warnings = instance.warnings();
  const auto fail = [&](const char* reason) {
    try_to_report([&] { instance.report_error(std::string(function) + ": " + reason); });
    return Outcome::error;
  };
  try {
    if ((instance.phase() & permitted) == 0)
      throw std::runtime_error("must not be called in " + phase_name(instance.phase()));
    work(instance);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  } catch (...) {
    return fail("unknown failure");
  }
  return instance.warnings() == earlier_warnings ? Outcome::ok : Outcome::warning;
}

}  // namespace trivet::fmu
