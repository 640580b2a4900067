// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Answers g_r + i g_i of a linear system to unit forces at the harmonics of a motion, for its coefficients
/// (fourier_basis.h). Coefficients a, b of a harmonic are the amplitude a − i b, which the answer turns into g_r a +
/// g_i b and g_r b − g_i a: each coefficient times `on_own`, and the other one of its harmonic times `on_other`.
struct HarmonicAnswers {
  Eigen::MatrixXd on_own, on_other;  ///< coefficients × answers; no answer of the mean to another coefficient
};

/// Adds the answers to courses, one per column: rows of all coefficients of one answer after another, as many as
/// answers.
/// @param first, count  columns of `answers`
/// @param courses       coefficients × courses
/// @param sums          count times coefficients × courses
void add_answers(const HarmonicAnswers& answers, Eigen::Index first, Eigen::Index count,
                 const Eigen::Ref<const Eigen::MatrixXd>& courses, Eigen::Ref<Eigen::MatrixXd> sums);

}  // namespace trivet::numerics
