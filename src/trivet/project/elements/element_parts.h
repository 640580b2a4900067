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
[[nodiscard]] elements::Vector6 read_constants(TableReader& reader, Quantity translation, Quantity rotation, bool with_rotation);

/// The table `damping` of an element into its law; constants act at the fraction `centre` of the span.
void read_damping(TableReader& reader, const model::Span& span, double centre, model::Element& element);

/// `damping = {loops = "file.csv", law = "best"}`: the law of the element out of measured hysteresis loops.
void read_loops(TableReader& damping, model::Element& element);

/// A law that knows its own size: it fills law and facts, in local axes with e3 from N to K, and returns the distance from N to K [m],
/// or nothing after reporting what is wrong.
using LengthOf = std::optional<double>;
[[nodiscard]] LengthOf read_coil_spring(TableReader& reader, model::Element& element);
[[nodiscard]] LengthOf read_rubber_disc(TableReader& reader, model::Element& element);
[[nodiscard]] LengthOf read_rubber_block(TableReader& reader, model::Element& element);
[[nodiscard]] LengthOf read_rubber_bush(TableReader& reader, model::Element& element);
[[nodiscard]] LengthOf read_sandwich(TableReader& reader, model::Element& element);
[[nodiscard]] LengthOf read_solid_mount(TableReader& reader, model::Element& element);
[[nodiscard]] LengthOf read_step_mount(TableReader& reader, model::Element& element);   ///< a solid_mount out of a STEP file
[[nodiscard]] LengthOf read_beam(TableReader& reader, model::Element& element);
[[nodiscard]] LengthOf read_link(TableReader& reader, model::Element& element);

/// Rubber is stiffer in vibration than at rest: found with the static moduli, the element then moves with `material.stiffening` times the
/// stiffness of its deformations; what a preload does in a rigid motion stays.
[[nodiscard]] LengthOf stiffened(TableReader& reader, LengthOf length, model::Element& element);

/// Laws from files, between ends that the project file places.
void read_imported(TableReader& reader, const model::Span& span, model::Element& element);
void read_measured(TableReader& reader, const model::Span& span, model::Element& element);
/// Per direction k'(f) and k''(f) out of a table: air springs, wire-rope isolators, hydraulic mounts.
void read_tabulated(TableReader& reader, const model::Span& span, model::Element& element);
/// `type = "catalogue:NAME"`.
void read_catalogue_mount(TableReader& reader, const std::string& name, const model::Span& span, model::Element& element);

}  // namespace trivet::project
