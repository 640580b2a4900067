// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

#include "trivet/exchange/universal/universal_writing.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/project.h"

namespace mobility_reader_test {

using namespace trivet;
using exchange::UniversalQuantity;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using Complex = std::complex<double>;

constexpr int lines = 20;

/// Mobility of two equal ground points with a coupling: share of the driving-point mobility.
exchange::UniversalFunction function(int node, int reference, double share, double first_hz = 5) {
  exchange::UniversalFunction result;
  result.type = exchange::UniversalFunctionType::frequency_response;
  result.response = {"", node, 3};
  result.reference = {"", reference, 3};
  result.abscissa_axis.quantity = UniversalQuantity::frequency;
  result.numerator.quantity = UniversalQuantity::velocity;
  result.denominator.quantity = UniversalQuantity::excitation_force;
  result.abscissa = exchange::EvenAbscissa{first_hz, 1};
  for (int line = 0; line < lines; ++line) {
    const Complex s(0, foundation::two_pi * (first_hz + line));
    result.values.push_back(share * s / (300.0 * s * s + 3e4 * s + 2e6));
  }
  return result;
}

/// Messages about a machine on the points that nodes 11 and 12 of a file are.
std::vector<std::string> messages(const std::vector<exchange::UniversalFunction>& functions,
                                  const std::string& nodes = R"({"11" = "left", "12" = "right"})",
                                  const std::vector<exchange::UniversalNode>& geometry = {},
                                  const std::string& keys = "",
                                  const std::function<std::string(std::string)>& edited = {}) {
  exchange::UniversalFile file;
  file.nodes = geometry;
  file.functions = functions;
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("trivet-mobility-messages-{}.uff", ::getpid());
  std::string bytes = exchange::universal_text(file, exchange::FunctionForm::binary);
  if (edited) bytes = edited(std::move(bytes));
  std::ofstream(path, std::ios::binary) << bytes;
  const auto project = judging::project_from_text(
      fmt::format(
          "trivet = 1\n[bodies.m]\nmass = 100\nfree = [\"z\"]\n"
          "[elements.left]\ntype = \"three_springs\"\non = \"m\"\nat = [1, 0, 0]\ntranslation = [1e5, 1e5, 1e5]\n"
          "foundation = \"deck\"\n[elements.right]\ntype = \"three_springs\"\non = \"m\"\nat = [-1, 0, 0]\n"
          "translation = [1e5, 1e5, 1e5]\nfoundation = \"deck\"\n"
          "[foundations.deck]\ntype = \"mobility\"\nfile = \"{}\"\nnodes = {}\n{}",
          path.string(), nodes, keys),
      "machine.toml");
  std::filesystem::remove(path);
  std::vector<std::string> result;
  for (const auto& problem : (project ? project->base().warnings : project.error()).list())
    result.push_back(foundation::message(problem));
  return result;
}

const std::vector<exchange::UniversalFunction> complete = {function(11, 11, 1), function(12, 12, 1),
                                                           function(11, 12, 0.3)};

std::vector<exchange::UniversalFunction> with(exchange::UniversalFunction more) {
  auto result = complete;
  result.push_back(std::move(more));
  return result;
}

TEST(MobilityReader, AcceptsOneFunctionPerPair) {
  for (const std::string& message : messages(complete)) EXPECT_THAT(message, Not(HasSubstr("deck"))) << message;
}

TEST(MobilityReader, WarnsOfCouplingsThatWereNotMeasured) {
  EXPECT_THAT(messages({function(11, 11, 1), function(12, 12, 1)}),
              Contains(HasSubstr("the coupling 12:+z per 11:+z was not measured")));
}

TEST(MobilityReader, WarnsOfCouplingsThatAreNotReciprocal) {
  EXPECT_THAT(messages(with(function(12, 11, 0.6))), Contains(HasSubstr("and back differ by 30 % rms")));
}

TEST(MobilityReader, RejectsPointsThatFeedEnergy) {
  EXPECT_THAT(messages({function(11, 11, 1), function(12, 12, 1), function(11, 12, 1.5)}),
              Contains(HasSubstr("a passive ground absorbs energy in every motion")));
}

TEST(MobilityReader, RejectsPointsOnOneRigidPart) {
  EXPECT_THAT(messages({function(11, 11, 1), function(12, 12, 1), function(11, 12, 1)}),
              Contains(HasSubstr("Y is singular")));
}

TEST(MobilityReader, RejectsOtherFrequencies) {
  EXPECT_THAT(messages({function(11, 11, 1), function(12, 12, 1), function(11, 12, 0.3, 6)}),
              Contains(HasSubstr("function 11:+z per 12:+z has other frequencies than function 11:+z per 11:+z")));
}

TEST(MobilityReader, AcceptsFrequenciesThatDifferByTheDigitsOfText) {
  exchange::UniversalFunction coupling = function(11, 12, 0.3);
  std::get<exchange::EvenAbscissa>(coupling.abscissa).step = 1.000004;
  for (const std::string& message : messages({function(11, 11, 1), function(12, 12, 1), coupling}))
    EXPECT_THAT(message, Not(HasSubstr("deck"))) << message;
  std::get<exchange::EvenAbscissa>(coupling.abscissa).step = 1.001;
  EXPECT_THAT(messages({function(11, 11, 1), function(12, 12, 1), coupling}), Contains(HasSubstr("other frequencies")));
}

TEST(MobilityReader, ReadsUnknownAbscissasAsFrequenciesWithAWarning) {
  auto functions = complete;
  for (auto& one : functions) one.abscissa_axis.quantity = UniversalQuantity::unknown;
  EXPECT_THAT(messages(functions), Contains(HasSubstr("3 functions with an abscissa of unknown quantity")));
  functions.front().abscissa_axis.unit = "s";
  EXPECT_THAT(messages(functions), Contains(HasSubstr("its abscissa has no quantity and the unit \"s\"")));
}

TEST(MobilityReader, WarnsOfDirectionsInACoordinateSystem) {
  std::vector<exchange::UniversalNode> nodes = {{.label = 11, .displacement_system = 3}, {.label = 12}};
  EXPECT_THAT(messages(complete, R"({"11" = "left", "12" = "right"})", nodes),
              Contains(HasSubstr("displacements of the nodes 11 in a coordinate system not 0")));
}

/// The file without its set 164, and with a label of the numerators.
std::string labelled(std::string bytes, const std::string& label, bool with_units) {
  if (!with_units)
    if (const std::size_t at = bytes.find("    -1\n   164"); at != std::string::npos)
      bytes.erase(at, bytes.find("    -1\n", at + 7) + 7 - at);
  const std::string none = "        11    0    0    0 NONE                 NONE                ";
  for (std::size_t at = bytes.find(none); at != std::string::npos; at = bytes.find(none, at))
    bytes.replace(at, none.size(), fmt::format("        11    0    0    0 {:<20} {:<20}", "Velocity", label));
  return bytes;
}

TEST(MobilityReader, NamesUnitsThatContradictEachOther) {
  const std::string nodes = R"({"11" = "left", "12" = "right"})";
  const auto with_label = [](const char* label, bool with_units) {
    return [=](std::string bytes) { return labelled(std::move(bytes), label, with_units); };
  };
  EXPECT_THAT(messages(complete, nodes, {}, "", with_label("mm/s", true)),
              Contains(AllOf(HasSubstr("set 164"), HasSubstr("the label \"mm/s\" of the numerator"))));
  EXPECT_THAT(messages(complete, nodes, {}, "unit = \"(in/s)/N\"\n", with_label("mm/s", false)),
              Contains(AllOf(HasSubstr("unit = \"(in/s)/N\""), HasSubstr("the label \"mm/s\""))));
  EXPECT_THAT(messages(complete, nodes, {}, "unit = \"g/N\"\n"), Contains(HasSubstr("the numerator has the type 11")));
  EXPECT_THAT(messages(complete, nodes, {}, "", with_label("furlong", false)),
              Contains(HasSubstr("the label \"furlong\" of the numerator is not a known unit")));
  for (const char* unit : {"(mm/s)/N", "(m/s)/N"})  // the project decides between set 164 and the label
    for (const std::string& message :
         messages(complete, nodes, {}, fmt::format("unit = \"{}\"\n", unit), with_label("mm/s", true)))
      EXPECT_THAT(message, Not(HasSubstr("error"))) << message;
}

TEST(MobilityReader, AppliesAUnitToTheFunctionsThatItFits) {
  exchange::UniversalFunction tilt = function(11, 11, 1);
  tilt.response.direction = tilt.reference.direction = 4;
  const std::string nodes = R"({"11" = "left", "12" = "right"})";
  const auto errors = [&](const std::string& keys) {
    const auto all = messages(with(tilt), nodes, {}, keys);
    return std::ranges::count_if(all, [](const std::string& one) { return one.find("error") != std::string::npos; });
  };
  EXPECT_EQ(errors("unit = \"(m/s)/N\"\n"), 0);
  EXPECT_EQ(errors("unit = [\"(m/s)/N\", \"(rad/s)/(N m)\"]\n"), 0);
  EXPECT_EQ(errors("unit = [\"(m/s)/N\", \"(rad/s)/(kN m)\"]\n"), 1);  // set 164 is SI
  EXPECT_THAT(messages(with(tilt), nodes, {}, "unit = [\"(m/s)/N\", \"(rad/s)/N\"]\n"),
              Contains(HasSubstr("unit = \"(rad/s)/N\" of the project fits no function")));
}

TEST(MobilityReader, RejectsTablesInOtherUnitsThanMobilities) {
  const auto of_table = [](const std::string& heading) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("trivet-mobility-units-{}.csv", ::getpid());
    std::ofstream(path) << heading << "\n10,1e-5,0\n20,1e-5,0\n";
    const auto project = judging::project_from_text(
        fmt::format("trivet = 1\n[bodies.m]\nmass = 100\nfree = [\"z\"]\n[elements.left]\ntype = \"three_springs\"\n"
                    "on = \"m\"\nat = [1, 0, 0]\ntranslation = [1e5, 1e5, 1e5]\nfoundation = \"deck\"\n"
                    "[foundations.deck]\ntype = \"mobility\"\nfile = \"{}\"\n",
                    path.string()),
        "machine.toml");
    std::filesystem::remove(path);
    std::string text;
    if (!project)
      for (const auto& problem : project.error().list()) text += foundation::message(problem) + "\n";
    return text;
  };
  EXPECT_EQ(of_table("frequency [Hz],y_z_z [m/(N s)],y_z_z_im [m/(N s)]"), "");
  EXPECT_EQ(of_table("frequency_hz,y_rx_rx [rad/(N m s)],y_rx_rx_im [(deg/s)/(N m)]"), "");
  EXPECT_THAT(of_table("frequency [Hz],y_z_z [m/N],y_z_z_im [m/N]"),
              AllOf(HasSubstr("column \"y_z_z [m/N]\""), HasSubstr("converts to (m/s)/N")));
  EXPECT_THAT(of_table("frequency [mm],y_z_z,y_z_z_im"), HasSubstr("converts to Hz"));
  EXPECT_THAT(of_table("frequency [Hz],x [m/(N s)],x_im [m/(N s)]"),
              AllOf(HasSubstr("column \"x [m/(N s)]\""), HasSubstr("with a unit: y_z_z [(mm/s)/N]")));
}

TEST(MobilityReader, RejectsTransmissibilities) {
  exchange::UniversalFunction other = function(12, 11, 0.3);
  other.denominator.quantity = UniversalQuantity::velocity;
  EXPECT_THAT(messages(with(other)), Contains(HasSubstr("function 12:+z per 11:+z is not a motion per force")));
}

TEST(MobilityReader, RejectsRepeatedFunctions) {
  EXPECT_THAT(messages(with(function(11, 12, 0.3))), Contains(HasSubstr("function 11:+z per 12:+z twice")));
}

TEST(MobilityReader, RejectsNodesWithoutDrivingPoint) {
  EXPECT_THAT(messages({function(11, 11, 1), function(11, 12, 0.3)}),
              Contains(HasSubstr("node 12 has no driving-point function")));
  EXPECT_THAT(messages(complete, R"({"21" = "left", "22" = "right"})"),
              Contains(HasSubstr("no frequency response between the nodes")));
}

TEST(MobilityReader, NamesElementsWithoutNodesAndNodesWithoutElements) {
  EXPECT_THAT(messages(complete, R"({"11" = "left"})"),
              Contains(HasSubstr("elements.right.foundation: \"deck\"; this foundation has no node for this element")));
  EXPECT_THAT(messages(complete, R"({"11" = "left", "12" = "rigth"})"), Contains(HasSubstr("did you mean \"right\"?")));
  EXPECT_THAT(messages(complete, R"({"11" = "left", "twelve" = "right"})"),
              Contains(HasSubstr("the key is the number of a node of the file")));
}

TEST(MobilityReader, RejectsANodeWhoseElementIsElsewhere) {
  // Its point would be free of forces, but the inverse of all of Y would hold it in place.
  EXPECT_THAT(messages(complete, R"({"11" = "left", "12" = "right", "13" = "absent"})"),
              Contains(HasSubstr("no element has this name")));
}

TEST(MobilityReader, RejectsRepeatedNodes) {
  EXPECT_THAT(messages(complete, R"({"11" = "left", "011" = "right"})"),
              Contains(HasSubstr("each node is named once")));
}

TEST(MobilityReader, RejectsFunctionsOfSpeed) {
  exchange::UniversalFunction other = function(12, 11, 0.3);
  other.abscissa_axis.quantity = UniversalQuantity::shaft_speed;
  EXPECT_THAT(messages(with(other)), Contains(HasSubstr("abscissa of type 19")));
}

TEST(MobilityReader, WarnsOfPointsThatMoveAlmostAsOne) {
  EXPECT_THAT(messages({function(11, 11, 1), function(12, 12, 1), function(11, 12, 0.9999)}),
              Contains(HasSubstr("Y is nearly singular")));
}

}  // namespace mobility_reader_test
