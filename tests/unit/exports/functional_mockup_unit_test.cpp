// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/functional_mockup_unit.h"

#include <gmock/gmock.h>

#include <cstring>
#include <limits>
#include <string>

#include "trivet/foundation/invalid_input.h"
#include "two_masses.h"

namespace functional_mockup_unit_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using namespace trivet::exports;
using trivet::foundation::InvalidInput;
using trivet::test::two_masses;

constexpr FmuBinaries binaries = {.linux_x86_64 = "ELF", .windows_x86_64 = "MZ", .licence = "licence"};

TEST(FunctionalMockupUnit, HasTheFilesOfItsVersion) {
  EXPECT_THAT(functional_mockup_unit(two_masses(), FmiVersion::two, binaries),
              AllOf(HasSubstr("modelDescription.xml"), HasSubstr("binaries/linux64/Two_masses.so"),
                    HasSubstr("binaries/win64/Two_masses.dll"), HasSubstr("resources/system.txt"),
                    HasSubstr("documentation/licenses/license.txt")));
  EXPECT_THAT(
      functional_mockup_unit(two_masses(), FmiVersion::three, binaries),
      AllOf(HasSubstr("binaries/x86_64-linux/Two_masses.so"), HasSubstr("binaries/x86_64-windows/Two_masses.dll")));
}

TEST(FunctionalMockupUnit, HasOnlyTheBinariesThatExist) {
  EXPECT_THAT(functional_mockup_unit(two_masses(), FmiVersion::two, {.linux_x86_64 = "ELF"}),
              AllOf(HasSubstr(".so"), Not(HasSubstr(".dll")), Not(HasSubstr("license"))));
  EXPECT_THROW(static_cast<void>(functional_mockup_unit(two_masses(), FmiVersion::two, {})), InvalidInput);
}

TEST(FunctionalMockupUnit, HasTheSameBytesForTheSameSystemOnly) {
  const std::string bytes = functional_mockup_unit(two_masses(), FmiVersion::two, binaries);
  EXPECT_EQ(functional_mockup_unit(two_masses(), FmiVersion::two, binaries), bytes);
  LinearSystem other = two_masses();
  other.A(3, 3) *= 1 + 1e-15;
  EXPECT_NE(functional_mockup_unit(other, FmiVersion::two, binaries), bytes);
}

TEST(FunctionalMockupUnit, RejectsAWrongSystem) {
  LinearSystem system = two_masses();
  system.A(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(functional_mockup_unit(system, FmiVersion::two, binaries)), InvalidInput);
}

TEST(FunctionalMockupUnit, HasTheLibraryThatWasBuiltWithThisProgram) {
  const FmuBinaries built = built_fmu_binaries();
#if defined(__linux__) && defined(__x86_64__)
  EXPECT_THAT(std::string(built.linux_x86_64.substr(0, 4)),
              "\x7f"
              "ELF");
#endif
  EXPECT_TRUE(built.windows_x86_64.empty() || built.windows_x86_64.starts_with("MZ"));
  EXPECT_THAT(std::string(built.licence), HasSubstr("Copyright"));
}

}  // namespace functional_mockup_unit_test
