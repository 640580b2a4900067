// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/solid_states.h"

#include <utility>

#include "trivet/foundation/thread_progress.h"
#include "trivet/project/elements/element_cache.h"

namespace trivet::project {
namespace {

/// Change it whenever meshes or kernels change, so that older results in the cache are not used.
constexpr const char* method = "finite elements 1";

std::vector<double> numbers_of(const fem::SolidStiffness& s) {
  std::vector<double> numbers(s.stiffness.data(), s.stiffness.data() + 144);
  numbers.insert(numbers.end(), s.relative_error.data(), s.relative_error.data() + 144);
  numbers.insert(numbers.end(), {s.rigid_residual, double(s.unknowns), double(s.elements)});
  return numbers;
}

fem::SolidStiffness solid_stiffness(const std::vector<double>& numbers) {
  fem::SolidStiffness s;
  s.stiffness = Eigen::Map<const elements::Matrix12>(numbers.data());
  s.relative_error = Eigen::Map<const elements::Matrix12>(numbers.data() + 144);
  s.rigid_residual = numbers[288];
  s.unknowns = static_cast<int>(numbers[289]);
  s.elements = static_cast<int>(numbers[290]);
  return s;
}

std::vector<double> numbers_of(const LoadedSolid& p) {
  std::vector<double> numbers(p.stiffness.data(), p.stiffness.data() + 144);
  numbers.insert(numbers.end(), p.force.data(), p.force.data() + 12);
  numbers.insert(numbers.end(), {p.distance, p.deflection, double(p.negative_eigenvalues)});
  return numbers;
}

LoadedSolid loaded_solid(const std::vector<double>& numbers) {
  LoadedSolid p;
  p.stiffness = Eigen::Map<const elements::Matrix12>(numbers.data());
  p.force = Eigen::Map<const elements::Vector12>(numbers.data() + 144);
  p.distance = numbers[156];
  p.deflection = numbers[157];
  p.negative_eigenvalues = static_cast<int>(numbers[158]);
  return p;
}

}  // namespace

std::string solid_key(const std::string& description, const std::vector<std::string>& files) {
  return content_key(std::string(method) + " " + description, files);
}

fem::SolidStiffness free_solid(const std::string& key, const MeshedSolid& meshed) {
  constexpr std::size_t count = 291;
  const std::string whole_key = key + "-free";
  if (const auto kept = cached_numbers(whole_key); kept && kept->size() == count) return solid_stiffness(*kept);
  const Solid& it = meshed();
  const foundation::Progress& progress = foundation::thread_progress();
  fem::SolidStiffness found = it.coarse
      ? fem::condense(it.mesh, *it.coarse, it.refinement, it.materials, it.frame, {}, progress)
      : fem::condense(it.mesh, it.materials, it.frame, {}, progress);
  keep_numbers(whole_key, numbers_of(found));
  return found;
}

std::variant<LoadedSolid, std::string> solid_under(const std::string& key, const MeshedSolid& meshed,
                                                   const fem::Preload& load, int steps) {
  constexpr std::size_t count = 159;
  if (const auto kept = cached_numbers(key); kept && kept->size() == count) return loaded_solid(*kept);
  const Solid& it = meshed();
  const fem::PreloadedStiffness found =
      fem::preloaded_stiffness(it.mesh, it.materials, it.frame, load, {.steps = steps}, foundation::thread_progress());
  if (!found.converged) return found.failure_reason;
  LoadedSolid state{found.stiffness, found.preload, found.arm(2), found.motion(2), found.negative_eigenvalues};
  keep_numbers(key, numbers_of(state));
  return state;
}

}  // namespace trivet::project
