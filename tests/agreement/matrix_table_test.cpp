// SPDX-License-Identifier: BSD-3-Clause
// A full dynamic stiffness matrix over frequency: the same results as its independent directions in their own axes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "trivet/foundation/index.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/analyses/case_results.h"

namespace matrix_table_test {

using namespace trivet;
using Complex = std::complex<double>;

constexpr int rows = 40;
constexpr double step_hz = 2;

/// Six independent relaxing directions at row i.
Eigen::Matrix<Complex, 6, 1> constants(int i) {
  Eigen::Matrix<Complex, 6, 1> k;
  k << 4e4, 7e4, 9e4, 300, 500, 800;
  const Complex s(0, 2 * std::numbers::pi * step_hz * i);
  for (int j = 0; j < 6; ++j) k(j) *= 1.0 + 0.4 * s * 4e-3 * (1.0 + j) / (1.0 + s * 4e-3 * (1.0 + j));
  return k;
}

class Folder {
 public:
  Folder() { std::filesystem::create_directories(path_); }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// Writes the entries (i, j) with `is_selected` of the matrix of every row.
  template <typename Predicate, typename MatrixOf>
  std::string table(const std::string& name, int size, const Predicate& is_selected,
                    const std::function<std::string(int, int)>& word, const MatrixOf& matrix_of) const {
    std::ofstream file(path_ / name);
    file << "frequency_hz";
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        if (is_selected(i, j)) file << "," << word(i, j) << "," << word(i, j) << "_loss";
    for (int row = 0; row < rows; ++row) {
      const Eigen::MatrixXcd m = matrix_of(row);
      file << "\n" << step_hz * row;
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j)
          if (is_selected(i, j)) file << fmt::format(",{:.17g},{:.17g}", m(i, j).real(), m(i, j).imag());
    }
    file << "\n";
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / fmt::format("trivet-matrix-table-{}", ::getpid());
};

Eigen::VectorXcd result(const std::string& file, const std::string& extra) {
  const auto project = test::project(fmt::format(
      "trivet = 1\n[bodies.frame]\nmass = 10\ninertia = {{about = \"pole\", xx = 1, yy = 1.2, zz = 1.5}}\n"
      "[elements.mount]\ntype = \"table\"\non = \"frame\"\nat = [0.1, -0.2, 0.3]\nfile = \"{}\"\n{}"
      "[excitations.push]\ntype = \"harmonic\"\non = \"frame\"\nat = [0, 0, 0]\nforce = [1, 2, 3]\nmoment = [0.1, 0, "
      "0.2]\n"
      "[analyses]\nresponse = {{of = [\"frame\", \"ground\"], at = [\"1.3 Hz\", \"17.7 Hz\", \"63.1 Hz\"]}}\n",
      file, extra));
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses, {});
  std::vector<Complex> values;
  for (const auto& curve : results.response->curves.curves)
    values.insert(values.end(), curve.value.begin(), curve.value.end());
  return Eigen::Map<const Eigen::VectorXcd>(values.data(), to_index(values.size()));
}

TEST(MatrixTable, AgreesWithItsDirectionsInTheirOwnAxes) {
  constexpr double round_off = 1e-11;  // condition of Z times ε
  const Folder folder;
  test::RandomSystem random(7);
  const Eigen::Matrix3d turn = random.rotation();
  const Eigen::AngleAxisd own(turn);
  const spatial::Matrix6 both = spatial::both_blocks(turn);
  const auto turned_block = [&](int row) -> Eigen::MatrixXcd {
    return both.cast<Complex>() * constants(row).asDiagonal() * both.transpose().cast<Complex>();
  };
  const auto full = [&](int row) -> Eigen::MatrixXcd {
    Eigen::MatrixXcd m(12, 12);
    m << turned_block(row), -turned_block(row), -turned_block(row), turned_block(row);
    return m;
  };
  const auto numbered = [](int i, int j) { return fmt::format("k_{}_{}", i + 1, j + 1); };
  const auto upper = [](int i, int j) { return i <= j; };
  const std::array<const char*, 6> letters = {"x", "y", "z", "rx", "ry", "rz"};
  const std::string directions = folder.table(
      "directions.csv", 6, [](int i, int j) { return i == j; },
      [&](int i, int) { return std::string("k_") + letters[i]; },
      [](int row) -> Eigen::MatrixXcd { return constants(row).asDiagonal(); });
  const Eigen::VectorXcd expected = result(
      directions,
      fmt::format(
          "interpolation = \"linear\"\norientation = {{axis = [{:.17g}, {:.17g}, {:.17g}], angle = \"{:.17g} rad\"}}\n",
          own.axis().x(), own.axis().y(), own.axis().z(), own.angle()));
  const Eigen::VectorXcd of_end = result(folder.table("end.csv", 6, upper, numbered, turned_block), "");
  const Eigen::VectorXcd of_both = result(folder.table("both.csv", 12, upper, numbered, full), "");
  const Eigen::VectorXcd unsymmetric =
      result(folder.table("all.csv", 6, [](int, int) { return true; }, numbered, turned_block), "symmetric = false\n");
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    EXPECT_LE(std::abs(of_end(i) - expected(i)), round_off * std::abs(expected(i))) << i;
    EXPECT_LE(std::abs(of_both(i) - expected(i)), round_off * std::abs(expected(i))) << i;
    EXPECT_LE(std::abs(unsymmetric(i) - expected(i)), round_off * std::abs(expected(i))) << i;
  }
}

}  // namespace matrix_table_test
