// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

/// One function per part of an element's table.
namespace trivet::project {

/// Quantity of entry (i, j) of a 6×6 or 12×12 stiffness or damping matrix.
[[nodiscard]] Quantity matrix_entry(bool damping, int i, int j);

/// The 12×12 of a given matrix: a 12×12 as it is, a 6×6 of the K end completed by equilibrium.
[[nodiscard]] elements::Matrix12 full_matrix(const Eigen::MatrixXd& given, const model::Span& span);

/// `translation` and, if wanted, `rotation`: six constants along and about the local axes, each ≥ 0.
[[nodiscard]] elements::Vector6 read_constants(TableReader& reader, Quantity translation, Quantity rotation,
                                               bool with_rotation);

/// Reads the table `damping` of an element into its law; constants act at the fraction `centre` of the span.
void read_damping(TableReader& reader, const model::Span& span, double centre, model::Element& element);

/// Reads `damping = {loops = "file.csv", law = "best"}`: a damping law fitted to measured hysteresis loops.
void read_loops(TableReader& damping, model::Element& element);

/// Reads `laws`: forces over the deflections of an element, in addition to its stiffness.
void read_laws(TableReader& reader, const model::Span& span, model::Element& element);

/// Distance from N to K [m]; none after reporting errors.
using ElementLength = std::optional<double>;
[[nodiscard]] ElementLength read_step_mount(TableReader& reader,
                                            model::Element& element);  ///< a solid_mount from a STEP file

/// `stiffening` of an element or mount with static constants: its stiffness in vibration over the static one, 1 by
/// default.
[[nodiscard]] double stiffening_of(TableReader& reader);
/// The law of static constants becomes that of vibration.
void stiffen(double stiffening, model::Element& element);
/// Reports stiffening together with what already states the stiffness over frequency or deflection.
void check_stiffening(TableReader& reader, const model::Element& element);

/// Multiplies the deformation stiffness of an element, computed with static moduli, by `material.stiffening`: rubber is
/// stiffer in vibration than at rest. The effect of a preload in a rigid motion is unchanged. Returns `length`.
[[nodiscard]] ElementLength stiffened(TableReader& reader, ElementLength length, model::Element& element);

/// Sets the creep factor of an element of rubber, `material.creep`.
void read_creep_of_rubber(TableReader& reader, model::Element& element);

}  // namespace trivet::project
