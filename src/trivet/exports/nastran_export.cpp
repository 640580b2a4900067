// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "trivet/assembly/assembled.h"
#include "trivet/assembly/second_order.h"
#include "trivet/exports/format_table.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"

/// Nastran: every mount between two GRIDs, one at each end, as symmetric DMIG matrices in large fields: stiffness
/// (K2GG = MOUNTK), damping (B2GG = MOUNTB) and structural damping (K42GG = MOUNTS), in ground axes, SI.
namespace trivet::exports {
namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;
constexpr int first_grid = 1001;

/// A number in sixteen columns, with all digits that fit: 1.2345678901234+5.
std::string in_sixteen(double value) {
  constexpr std::size_t width = 16;
  for (int digits = 14; digits > 0; --digits) {
    std::string text = fmt::format("{:.{}e}", value, digits);
    const std::size_t exponent = text.find('e');
    std::string power = text.substr(exponent + 1);  // "+05"
    while (power.size() > 2 && power[1] == '0') power.erase(1, 1);
    text = text.substr(0, exponent) + power;
    if (text.size() <= width) return text;
  }
  return "0.";
}

/// @throws foundation::NotComputable for an unsymmetric matrix: the cards hold one triangle
void require_symmetric(const model::Element& element, const char* what, const Matrix12& matrix) {
  constexpr double round_off = 1e-9;
  if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > round_off * matrix.cwiseAbs().maxCoeff())
    throw foundation::NotComputable(fmt::format(
        "nastran: the {} of \"{}\" is not symmetric, and DMIG is written as a symmetric matrix; export it to "
        "matrix_market or matlab",
        what, element.name));
}

/// Stiffness of the ends at rest: internal coordinates condensed statically.
Matrix12 end_stiffness_at_rest(const model::Element& element, const Eigen::MatrixXd& stiffness) {
  const Eigen::Index internal = stiffness.rows() - 12;
  Matrix12 ends = stiffness.topLeftCorner<12, 12>();
  if (internal > 0) {
    const Eigen::MatrixXd inside = stiffness.bottomRightCorner(internal, internal),
                          to_ends = stiffness.bottomLeftCorner(internal, 12);
    ends -= stiffness.topRightCorner(12, internal) * numerics::lu_solution(inside, to_ends);
  }
  require_symmetric(element, "stiffness", ends);
  return ends;
}

/// The 12×12 of an element in ground axes, both ends about their reference points.
Matrix12 in_ground_axes(const model::System& system, const model::Element& element, const Eigen::MatrixXd& local) {
  Matrix12 turn = Matrix12::Zero();
  const std::array<const model::End*, 2> ends = {&element.n, &element.k};
  for (int e = 0; e < 2; ++e) {
    const Eigen::Matrix3d axes = model::end_in_ground(system.bodies(), *ends[static_cast<std::size_t>(e)]).rotation;
    turn.block<3, 3>(6 * e, 6 * e) = axes;
    turn.block<3, 3>(6 * e + 3, 6 * e + 3) = axes;
  }
  const Matrix12 in_axes = turn * local.topLeftCorner<12, 12>() * turn.transpose();
  return (in_axes + in_axes.transpose()) / 2;
}

/// Columns of the lower triangle of one element.
std::string columns(const char* name, int grid, const Matrix12& matrix) {
  const double scale = matrix.cwiseAbs().maxCoeff();
  constexpr double round_off = 1e-15;
  std::string text;
  for (int j = 0; j < 12; ++j) {
    std::string entries;
    for (int i = j; i < 12; ++i)
      if (std::abs(matrix(i, j)) > round_off * scale)
        entries += fmt::format("*       {:>16}{:>16}{:>16}\n", grid + i / 6, i % 6 + 1, in_sixteen(matrix(i, j)));
    if (!entries.empty()) text += fmt::format("DMIG*   {:<16}{:>16}{:>16}\n", name, grid + j / 6, j % 6 + 1) + entries;
  }
  return text;
}

std::string grid_card(int grid, const Eigen::Vector3d& at) {
  return fmt::format("GRID*   {:>16}{:>16}{:>16}{:>16}\n*       {:>16}{:>16}\n", grid, "", in_sixteen(at.x()),
                     in_sixteen(at.y()), in_sixteen(at.z()), "");
}

/// What the matrices of an element do not say.
void note_losses(const assembly::ElementMap& map, const model::Element& element, std::vector<std::string>& lost) {
  if (map.frequency_dependent())
    lost.push_back(fmt::format("{}: it depends on frequency; its nearest linear system is written", element.name));
  if (map.matrices.stiffness.rows() > 12)
    lost.push_back(fmt::format(
        "{}: its internal coordinates are condensed statically, without their damping and dynamics", element.name));
  if (map.matrices.mass.size() > 0 && !map.matrices.mass.isZero(0))
    lost.push_back(fmt::format("{}: its own mass is not written", element.name));
}

struct Deck {
  std::string grids, stiffness, damping, loss;
};

std::vector<std::string> write_nastran(const Content& content, const Target& target, const foundation::Progress&) {
  const model::System& system = content.variant.system;
  // The other program finds the forces at rest, and what they add to the stiffness, itself.
  const assembly::Assembled assembled = assembly::assemble_first_order(system);
  if (system.elements().empty()) throw foundation::NotComputable("nastran: the model has no elements to export");
  Deck deck;
  std::vector<std::string> lost;
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    const elements::Matrices& matrices = assembled.elements[e].matrices;
    const int grid = first_grid + 2 * static_cast<int>(e);
    note_losses(assembled.elements[e], element, lost);
    deck.grids += fmt::format("$ {}: {} at its end N, {} at its end K\n", element.name, grid, grid + 1);
    deck.grids += grid_card(grid, model::end_in_ground(system.bodies(), element.n).position);
    deck.grids += grid_card(grid + 1, model::end_in_ground(system.bodies(), element.k).position);
    deck.stiffness +=
        columns("MOUNTK", grid, in_ground_axes(system, element, end_stiffness_at_rest(element, matrices.stiffness)));
    require_symmetric(element, "damping", matrices.damping.topLeftCorner<12, 12>());
    if (!matrices.damping.isZero(0))
      deck.damping += columns("MOUNTB", grid, in_ground_axes(system, element, matrices.damping));
    if (matrices.loss_factor != 0)
      deck.loss +=
          columns("MOUNTS", grid, in_ground_axes(system, element, Matrix12(matrices.loss.topLeftCorner<12, 12>())));
  }
  if (assembly::has_second_order(system))
    lost.emplace_back("what the weight adds to the stiffness is not written: it belongs to the bodies");
  std::string selection = "$   K2GG = MOUNTK\n", cards;
  const auto add = [&](const char* name, const char* by, const std::string& text) {
    if (text.empty()) return;
    if (by) selection += fmt::format("$   {} = {}\n", by, name);
    cards += fmt::format("DMIG    {:<8}{:>8}{:>8}{:>8}{:>8}\n", name, 0, 6, 2, 0) + text;
  };
  add("MOUNTK", nullptr, deck.stiffness);
  add("MOUNTB", "B2GG", deck.damping);
  add("MOUNTS", "K42GG", deck.loss);
  write_bytes(target.path(),
              fmt::format("$ Mounts of {}, written by Trivet. SI: m, N, kg, s, rad; ground axes.\n"
                          "$ Numbers have up to 13 digits. Select the matrices in the case control:\n",
                          content.words()) +
                  selection + deck.grids + cards);
  return lost;
}

}  // namespace

const Format nastran_format = {
    "nastran", "Nastran bulk data: mounts as DMIG between GRIDs", Target::Kind::file, {}, true, write_nastran};

}  // namespace trivet::exports
