// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "fmu/guarded_call.h"

/// Functions of both versions of the interface that read or set values of variables, or derivatives of them.
namespace trivet::fmu {

Outcome get_numbers(void* instance, const char* function, std::span<const ValueReference> references,
                    std::span<double> values);
/// Inputs; before and in initialization mode also states.
Outcome set_numbers(void* instance, const char* function, std::span<const ValueReference> references,
                    std::span<const double> values);
/// Reading or setting variables of a type that no variable has: correct only for none of them.
Outcome access_absent_type(void* instance, const char* function, std::size_t count);

/// Changes of outputs and derivatives of states that follow from changes of inputs and states.
Outcome get_directional_derivative(void* instance, const char* function, std::span<const ValueReference> unknowns,
                                   std::span<const ValueReference> knowns, std::span<const double> known_changes,
                                   std::span<double> unknown_changes);
/// The transposed product: weights of inputs and states from weights of outputs and derivatives of states.
Outcome get_adjoint_derivative(void* instance, const char* function, std::span<const ValueReference> unknowns,
                               std::span<const ValueReference> knowns, std::span<const double> unknown_weights,
                               std::span<double> known_weights);

/// Derivatives of outputs with respect to time.
Outcome get_output_derivatives(void* instance, const char* function, std::span<const ValueReference> references,
                               std::span<const int> orders, std::span<double> values);

}  // namespace trivet::fmu
