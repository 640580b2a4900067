// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

/// One function per part of an element's table.
namespace trivet::project {

/// What entry (i, j) of a 6×6 or 12×12 stiffness or damping matrix measures.
[[nodiscard]] Quantity matrix_entry(bool damping, int i, int j);

/// A 12×12 is taken as given; a 6×6 of the K end is completed by equilibrium.
[[nodiscard]] elements::Matrix12 full_matrix(const Eigen::MatrixXd& given, const model::Span& span);

/// `translation` and, if wanted, `rotation`: six constants along and about the local axes, each ≥ 0.
[[nodiscard]] elements::Vector6 read_constants(TableReader& reader, Quantity translation, Quantity rotation,
                                               bool with_rotation);

/// The table `damping` of an element into its law; constants act at the fraction `centre` of the span.
void read_damping(TableReader& reader, const model::Span& span, double centre, model::Element& element);

/// `damping = {loops = "file.csv", law = "best"}`: the law of the element out of measured hysteresis loops.
void read_loops(TableReader& damping, model::Element& element);

/// The distance from N to K [m], or nothing after reporting what is wrong.
using LengthOf = std::optional<double>;
[[nodiscard]] LengthOf read_step_mount(TableReader& reader,
                                       model::Element& element);  ///< a solid_mount out of a STEP file

/// Rubber is stiffer in vibration than at rest: found with the static moduli, the element then moves with
/// `material.stiffening` times the stiffness of its deformations; what a preload does in a rigid motion stays.
[[nodiscard]] LengthOf stiffened(TableReader& reader, LengthOf length, model::Element& element);

}  // namespace trivet::project
