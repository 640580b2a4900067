// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/labelled_arrays.h"
#include "trivet/results/format/in_documents.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "support/projects.h"
#include "trivet/judging/read_project.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/results/format/written_results.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/whole_study.h"

namespace labelled_arrays_test {

using namespace trivet;
using results::LabelledArray;
using results::LabelledArrays;
using testing::ElementsAre;
using testing::NanSensitiveDoubleEq;
using testing::Pointwise;

/// A machine with an analysis of every kind.
const std::string request = R"(trivet = 1
gravity = [0, 0, -9.81]
[bodies.machine]
mass = 40
free = ["x", "z", "ry"]
inertia = {about = "center_of_mass", xx = 1, yy = 1.2, zz = 0.9}
[element_types.mount]
type = "bushing"
translation = [2e4, 2e4, 3e4]
damping = {translation = [60, 60, 90]}
laws.z = {cubic = 1e6}
[elements]
peak = {type = "mount", on = "machine", at = [0.2, 0, 0]}
result = {type = "mount", on = "machine", at = [-0.2, 0, 0.01]}
[excitations.motor]
type = "harmonic"
on = "machine"
at = [0, 0, 0.1]
force = [3, 0, 10]
[excitations.crank]
type = "orders"
on = "machine"
at = [0, 0, 0.1]
table = [{order = 0.5, force = [0, 0, 4]}, {order = 2, force = [2, 0, 0]}]
[excitations.floor]
type = "random"
base = true
translation = [0, 0, 1]
quantity = "acceleration"
psd = [[2, 1e-3], [80, 1e-3]]
[excitations.drop]
type = "time"
base = true
translation = [0, 0, 1]
quantity = "acceleration"
history = {half_sine = {amplitude = "10 g", duration = "11 ms"}}
[operation]
speeds = ["300 rpm", ["400 rpm", "500 rpm"]]
[limit_lines.severity]
of = "machine.z"
rows = [[2, 1e-4], [40, 1e-4]]
[limits]
"machine.z" = "2 mm"
[tolerances.weight]
path = "bodies.machine.mass"
half_width = "5 %"
[tolerances.rubber]
path = "element_types.mount.scale"
half_width = "10 %"
[parameters.stiffness]
path = "element_types.mount.scale"
from = 0.5
to = 2
[parameters.mass]
path = "bodies.machine.mass"
from = "30 kg"
to = "50 kg"
[parameters.damping]
path = "element_types.mount.damping_factor"
from = 0.5
to = 2
[analyses]
modes = {}
roots = {}
response = {band = ["2 Hz", "40 Hz"]}
peaks = {}
static = {}
random = {}
transient = {to = "0.2 s", step = "1 ms"}
orders = {speed = ["300 rpm", "900 rpm"]}
transmissibility = {force = "motor", band = ["1 Hz", "20 Hz"]}
power = {band = ["2 Hz", "40 Hz"]}
shapes = {at = ["7 Hz", "9 Hz"]}
steady = {band = ["2 Hz", "9 Hz"], harmonics = 3}
backbone = {modes = [1, 2], up_to = "2 mm", harmonics = 3}
shock_spectrum = {band = ["5 Hz", "50 Hz"]}
earthquake = {direction = "z", rows = [[0.15, 9], [0.5, 9], [2, 2]]}
sample = {designs = 400, bands = ["machine.z"]}
)";
const std::string one_map_and_an_optimum = R"(optimize = {starts = 2}
map.x = {parameter = "stiffness", points = 4}
map.y = {parameter = "mass", points = 3}
)";
const std::string pairs_and_a_front = R"(optimize = {starts = 2, front = ["machine.z", "ground.force.z"]}
map = {pairs = [["stiffness", "mass"], ["mass", "damping"]], points = 3}
)";

struct Computed {
  project::Project project;
  study::CaseResults results;

  explicit Computed(const std::string& designs) : project(test::project(request + designs)) {
    results = study::run(project).front();
    EXPECT_THAT(results.failures, testing::IsEmpty());
  }
  LabelledArrays arrays(const std::string& analysis) const {
    return results::result_arrays(analysis, project.base(), results);
  }
  /// A column of a table.
  std::vector<double> csv(const std::string& analysis, const std::string& header) const {
    std::istringstream lines(results::result_csv(analysis, project.base(), results));
    std::string line, cell;
    std::vector<double> numbers;
    std::ptrdiff_t column = -1;
    while (std::getline(lines, line)) {
      std::istringstream row(line);
      std::vector<std::string> cells;
      while (std::getline(row, cell, ',')) cells.push_back(cell);
      if (column < 0) column = std::ranges::find(cells, header) - cells.begin();
      else numbers.push_back(cells.at(column).empty() ? std::nan("") : std::stod(cells.at(column)));
    }
    return numbers;
  }
};

const Computed& with_optimum() {
  static const Computed computed(one_map_and_an_optimum);
  return computed;
}

std::vector<double> real(const LabelledArrays& arrays, const std::string& name) {
  const LabelledArray* array = arrays.find(name);
  if (array) return array->real_numbers();
  ADD_FAILURE() << "no array " << name;
  return {};
}

bool has_units_of_rows(const LabelledArray& array, const LabelledArrays& arrays) {
  return std::ranges::any_of(array.axes, [&](const std::string& axis) {
    const LabelledArray* of_axis = arrays.find(axis + ".unit");
    const LabelledArray* plain = arrays.find("unit");
    return of_axis || (plain && plain->axes.front() == axis);
  });
}

void expect_consistent(const LabelledArrays& arrays, const std::string& analysis) {
  std::set<std::string> names;
  std::map<std::string, std::size_t> sizes;
  EXPECT_FALSE(arrays.list().empty()) << analysis;
  for (const LabelledArray& array : arrays.list()) {
    const std::string where = analysis + ": " + array.name;
    EXPECT_TRUE(names.insert(array.name).second) << where;
    ASSERT_EQ(array.shape.size(), array.axes.size()) << where;
    for (std::size_t i = 0; i < array.axes.size(); ++i)
      EXPECT_EQ(sizes.emplace(array.axes[i], array.shape[i]).first->second, array.shape[i]) << where;
    EXPECT_EQ(array.is_text(), array.unit.empty()) << where;
    if (array.is_text()) {
      EXPECT_EQ(array.texts().size(), array.size()) << where;
    }
    if (array.unit.starts_with(results::unit_of_the_row)) {
      EXPECT_TRUE(has_units_of_rows(array, arrays)) << where;
    }
  }
  for (const auto& [axis, size] : sizes) {
    const LabelledArray* coordinates = arrays.find(axis);
    EXPECT_TRUE(!coordinates || coordinates->axes == std::vector<std::string>{axis}) << analysis << ": " << axis;
  }
}

TEST(LabelledArrays, HaveUniqueNamesAndOneSizePerAxisInEveryResult) {
  const Computed with_front(pairs_and_a_front);
  for (const Computed* computed : {&with_optimum(), &with_front})
    for (const results::ResultWriter& writer : results::result_writers()) {
      if (std::string(writer.name) == "measurements") continue;  // below: they need a file
      ASSERT_TRUE(writer.is_there(computed->project.base(), computed->results)) << writer.name;
      expect_consistent(computed->arrays(writer.name), writer.name);
    }
}

TEST(LabelledArrays, OfMeasurementsAreConsistentToo) {
  const auto read = judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/measured_response/machine.toml");
  ASSERT_TRUE(read);
  const study::CaseResults results = study::run(*read).front();
  expect_consistent(results::result_arrays("measurements", read->base(), results), "measurements");
}

TEST(LabelledArrays, HaveTheNumbersOfTheTables) {
  const Computed& a = with_optimum();
  const auto expect_equal = [&](const std::string& analysis, const std::string& name, const std::string& header) {
    const std::vector<double> column = a.csv(analysis, header);
    EXPECT_FALSE(column.empty()) << analysis << ": " << header;
    EXPECT_THAT(real(a.arrays(analysis), name), Pointwise(NanSensitiveDoubleEq(), column)) << analysis << ": " << name;
  };
  expect_equal("response", "machine.z phase", "machine.z phase [rad]");
  expect_equal("peaks", "angular_frequency", "angular_frequency [rad/s]");
  expect_equal("peaks", "amplitude", "amplitude");
  expect_equal("peaks", "nearest_mode", "nearest_mode");
  expect_equal("modes", "frequency", "frequency [Hz]");
  expect_equal("transient", "time", "time [s]");
  expect_equal("transient", "machine.z", "machine.z [m]");
  expect_equal("optimize", "optimum", "optimum");

  constexpr double digits_of_a_float = 1e-6;  // margins of a map are below 10
  EXPECT_THAT(real(a.arrays("map"), "margin"),
              Pointwise(testing::DoubleNear(digits_of_a_float), a.csv("map", "margin")));

  std::vector<double> amplitudes;
  const LabelledArrays response = a.arrays("response");
  for (const auto& value : response.find("machine.z")->complex_numbers()) amplitudes.push_back(std::abs(value));
  EXPECT_EQ(amplitudes, a.csv("response", "machine.z amplitude [m]"));

  const std::vector<double> shapes = real(a.arrays("modes"), "shape"), z = a.csv("modes", "shape machine.z");
  ASSERT_EQ(shapes.size(), 6 * z.size());
  for (std::size_t mode = 0; mode < z.size(); ++mode) EXPECT_EQ(shapes[6 * mode + 2], z[mode]);
}

TEST(LabelledArrays, HaveNoNumberForModesOutsideAnEarthquakeSpectrum) {
  const LabelledArrays earthquake = with_optimum().arrays("earthquake");
  const std::vector<double> maxima = real(earthquake, "modal_maxima");
  const std::vector<double> accelerations = real(earthquake, "mode.spectral_acceleration");
  ASSERT_EQ(maxima.size(), 3 * accelerations.size());
  for (std::size_t i = 0; i < maxima.size(); ++i)
    EXPECT_EQ(std::isnan(maxima[i]), std::isnan(accelerations[i % accelerations.size()]));
  EXPECT_THAT(accelerations, testing::Contains(testing::IsNan()));
}

TEST(LabelledArrays, ReferToTheCurvesOfTheResult) {
  const Computed& a = with_optimum();
  const LabelledArrays response = a.arrays("response"), transient = a.arrays("transient");
  for (const auto& curve : a.results.response->curves.curves)
    EXPECT_EQ(std::get<const std::complex<double>*>(response.find(curve.name)->values), curve.value.data());
  for (const auto& curve : a.results.transient->response.curves)
    EXPECT_EQ(std::get<const double*>(transient.find(curve.name)->values), curve.values.data());
}

TEST(LabelledArrays, GiveNumbersWithTheLastAxisFastest) {
  struct Row {
    double first, second;
  };
  const std::vector<Row> rows = {{1, 2}, {3, 4}};
  const Eigen::MatrixXd by_columns{{1, 2, 3}, {4, 5, 6}};
  LabelledArrays list;
  list.view("matrix", "1", {"row", "column"}, by_columns);
  list.field("second", "1", "row", rows, &Row::second);
  list.lists("lists", "1", {"row", "column"}, 3, rows,
             [](const Row& row) { return std::vector<double>{row.first, row.second}; });
  EXPECT_THAT(real(list, "matrix"), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(real(list, "second"), ElementsAre(2, 4));
  EXPECT_THAT(real(list, "lists"), ElementsAre(1, 2, testing::IsNan(), 3, 4, testing::IsNan()));
}

}  // namespace labelled_arrays_test
