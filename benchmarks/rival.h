// SPDX-License-Identifier: BSD-3-Clause
// A program in another language that solves the same problem in its own process. It stays alive to take turns with the
// others, and reports its own CPU time.
#pragma once

#include <complex>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "measure.h"

namespace trivet::benchmarks {

/// Writes numbers for rivals: raw doubles, matrices by columns.
void write_numbers(const std::filesystem::path& file, const double* values, std::size_t count);

class Rival {
 public:
  /// Starts rivals/SCRIPT (.m by Octave, .py by Python) on the problem in a folder.
  Rival(const std::string& script, const std::filesystem::path& folder);
  ~Rival();
  Rival(const Rival&) = delete;
  Rival& operator=(const Rival&) = delete;

  /// True if the rival has this method. (A library may be absent.)
  [[nodiscard]] bool has(const std::string& name) const { return names_.contains(name); }
  /// Reads the problem again.
  void read();
  /// The answers, in the order in which the script stores them.
  [[nodiscard]] std::vector<std::complex<double>> answers(const std::string& name);
  /// Method timed per item; one turn is one call of the script's function, or more if that is short.
  [[nodiscard]] Method method(const std::string& name, std::string label, double items, double goal = 0);

 private:
  std::string ask(const std::string& request);

  std::string script_;
  std::filesystem::path folder_;
  std::set<std::string> names_;
  int process_ = 0;
  std::FILE *to_ = nullptr, *from_ = nullptr;
};

}  // namespace trivet::benchmarks
