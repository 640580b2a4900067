// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/model_description.h"

#include <gmock/gmock.h>

#include <string>

#include "trivet/foundation/invalid_input.h"
#include "two_masses.h"

namespace model_description_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using trivet::exports::FmiVersion;
using trivet::exports::LinearSystem;
using trivet::exports::model_description;
using trivet::exports::model_identifier;
using trivet::foundation::InvalidInput;
using trivet::test::two_masses;

TEST(ModelDescription, OfVersion2CountsVariablesFromOne) {
  const std::string text = model_description(two_masses(), FmiVersion::two, "{1}");
  EXPECT_THAT(
      text,
      AllOf(HasSubstr("fmiVersion=\"2.0\""), HasSubstr("guid=\"{1}\""), HasSubstr("variableNamingConvention=\"flat\""),
            HasSubstr("numberOfEventIndicators=\"0\""), HasSubstr("canInterpolateInputs=\"true\"")));
  EXPECT_THAT(text,
              HasSubstr("<ScalarVariable name=\"time\" valueReference=\"0\" causality=\"independent\" "
                        "variability=\"continuous\"><Real unit=\"s\"/></ScalarVariable>"));
  EXPECT_THAT(text,
              HasSubstr("<ScalarVariable name=\"force\" valueReference=\"1\" "
                        "description=\"on &quot;mass 2&quot; &lt;&amp;&gt;\" causality=\"input\" "
                        "variability=\"continuous\"><Real unit=\"N\" start=\"0\"/>"));
  EXPECT_THAT(text,
              HasSubstr("name=\"v2\" valueReference=\"9\" causality=\"local\" variability=\"continuous\" "
                        "initial=\"exact\"><Real unit=\"m/s\" nominal=\"0.1\" start=\"0.3333333333333333\"/>"));
  EXPECT_THAT(text,
              HasSubstr("name=\"der(v2)\" valueReference=\"13\" description=\"time derivative of v2\" "
                        "causality=\"local\" variability=\"continuous\" initial=\"calculated\">"
                        "<Real unit=\"m/s2\" derivative=\"10\"/>"));
  EXPECT_THAT(text,
              HasSubstr("<Unknown index=\"5\" dependencies=\"2 7 8 9 10\" "
                        "dependenciesKind=\"constant constant constant constant constant\"/>"));
  EXPECT_THAT(text, HasSubstr("<Unknown index=\"11\" dependencies=\"9\" dependenciesKind=\"constant\"/>"));
}

TEST(ModelDescription, OfVersion3NamesValueReferences) {
  const std::string text = model_description(two_masses(), FmiVersion::three, "{1}");
  EXPECT_THAT(text,
              AllOf(HasSubstr("fmiVersion=\"3.0\""), HasSubstr("instantiationToken=\"{1}\""),
                    HasSubstr("providesAdjointDerivatives=\"true\""), Not(HasSubstr("canInterpolateInputs"))));
  EXPECT_THAT(text,
              HasSubstr("<Float64 name=\"der(v2)\" valueReference=\"13\" description=\"time derivative of v2\" "
                        "causality=\"local\" variability=\"continuous\" initial=\"calculated\" unit=\"m/s2\" "
                        "derivative=\"9\"/>"));
  EXPECT_THAT(text, HasSubstr("<Output valueReference=\"4\" dependencies=\"1 6 7 8 9\""));
  EXPECT_THAT(text, HasSubstr("<ContinuousStateDerivative valueReference=\"10\" dependencies=\"8\""));
  EXPECT_THAT(text, HasSubstr("<InitialUnknown valueReference=\"13\""));
}

TEST(ModelDescription, DefinesEachUnitOnce) {
  const std::string text = model_description(two_masses(), FmiVersion::two, "{1}");
  const std::string definition = "<Unit name=\"N\"><BaseUnit kg=\"1\" m=\"1\" s=\"-2\"/></Unit>";
  const std::size_t first = text.find(definition);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(text.find(definition, first + 1), std::string::npos);
}

TEST(ModelDescription, SaysThatAVariableWithoutCausesDependsOnNothing) {
  LinearSystem system = two_masses();
  system.C.row(1).setZero();
  const std::string text = model_description(system, FmiVersion::two, "{1}");
  EXPECT_THAT(text, HasSubstr("<Unknown index=\"6\" dependencies=\"\" dependenciesKind=\"\"/>"));
}

TEST(ModelDescription, MayHaveNoStatesInputsOrOutputs) {
  LinearSystem system;
  for (auto* matrix : {&system.A, &system.B, &system.C, &system.D}) matrix->resize(0, 0);
  EXPECT_THAT(model_description(system, FmiVersion::two, "{1}"),
              AllOf(Not(HasSubstr("<Derivatives>")), HasSubstr("modelName=\"trivet_system\"")));
}

TEST(ModelDescription, RejectsUnknownUnitsAndNamesItNeedsItself) {
  LinearSystem system = two_masses();
  system.outputs[0].unit = "mm";
  EXPECT_THROW(static_cast<void>(model_description(system, FmiVersion::two, "{1}")), InvalidInput);
  for (const char* name : {"time", "der(x1)"}) {
    system = two_masses();
    system.outputs[0].name = name;
    EXPECT_THROW(static_cast<void>(model_description(system, FmiVersion::two, "{1}")), InvalidInput) << name;
  }
}

TEST(ModelDescription, HasAnIdentifierOfLettersDigitsAndUnderscores) {
  LinearSystem system;
  const auto identifier = [&](const std::string& title) {
    system.title = title;
    return model_identifier(system);
  };
  EXPECT_EQ(identifier("Two masses"), "Two_masses");
  EXPECT_EQ(identifier("  Motor – größer (2) "), "Motor_gr_er_2");
  EXPECT_EQ(identifier("3 masses"), "trivet_3_masses");
  EXPECT_EQ(identifier(""), "trivet_system");
  EXPECT_EQ(identifier("→"), "trivet_system");
  EXPECT_EQ(identifier(std::string(200, 'a')).size(), 60u);
}

}  // namespace model_description_test
