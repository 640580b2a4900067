// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/functional_mockup_unit.h"

#include <fmt/format.h>

#include "trivet/exports/linear_system.h"
#include "trivet/exports/model_description.h"
#include "trivet/exports/zip_archive.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/text/source_file.h"

namespace trivet::exports {
namespace {

/// "{01234567-89ab-…}": the beginning of the SHA-256 of the content, in the form of a GUID.
std::string content_token(const LinearSystem& system, FmiVersion version) {
  const std::string digest = project::sha256(model_description(system, version, "") + system_text(system, "-"));
  return fmt::format("{{{}-{}-{}-{}-{}}}", digest.substr(0, 8), digest.substr(8, 4), digest.substr(12, 4),
                     digest.substr(16, 4), digest.substr(20, 12));
}

constexpr const char* description_name = "modelDescription.xml";

}  // namespace

std::string functional_mockup_unit(const LinearSystem& system, FmiVersion version, const FmuBinaries& binaries) {
  if (binaries.linux_x86_64.empty() && binaries.windows_x86_64.empty())
    throw foundation::InvalidInput("this program was built without a shared library for functional mock-up units");
  const bool two = version == FmiVersion::two;
  const std::string token = content_token(system, version), identifier = model_identifier(system);
  ZipArchive archive;
  archive.add(description_name, model_description(system, version, token));
  if (!binaries.linux_x86_64.empty())
    archive.add(fmt::format("binaries/{}/{}.so", two ? "linux64" : "x86_64-linux", identifier), binaries.linux_x86_64);
  if (!binaries.windows_x86_64.empty())
    archive.add(fmt::format("binaries/{}/{}.dll", two ? "win64" : "x86_64-windows", identifier),
                binaries.windows_x86_64);
  archive.add("resources/system.txt", system_text(system, token));
  if (!binaries.licence.empty()) archive.add("documentation/licenses/license.txt", binaries.licence);
  return archive.bytes();
}

}  // namespace trivet::exports
