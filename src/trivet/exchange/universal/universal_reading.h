// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/foundation/problems.h"

namespace trivet::exchange {

struct UniversalRead {
  UniversalFile file;
  foundation::Problems warnings;  ///< what deviates from the standard and how it was read; sets that were ignored
};

/// Reads a universal file (UFF): sets 151, 164, 15, 2411, 18, 2420, 82, 55 and 2414 with modes, 2414 with frequency
/// responses, 58 and 58b. Numbers are converted to SI by set 164, which holds for the sets after it; frequencies of
/// axes stay in Hz. Other sets are ignored with one warning. Errors, each with the number and type of the set and the
/// line: not a universal file, a set that is cut off, counts that disagree, numbers that are not finite, a step or a
/// difference of times or frequencies ≤ 0, an unknown type of ordinates, numbers of a VAX. A file with an error gives
/// no content.
[[nodiscard]] foundation::Expected<UniversalRead> read_universal(const std::filesystem::path& path);

/// The same from the bytes of a file.
/// @param source  name of the file in messages
[[nodiscard]] foundation::Expected<UniversalRead> read_universal_text(std::string_view bytes,
                                                                      const std::string& source);

/// True if the first line that is not blank opens a set.
[[nodiscard]] bool begins_as_universal_file(std::string_view bytes);

/// The same of a file; also true if its name ends in .uff, .unv, .uf or .58.
[[nodiscard]] bool is_universal_file(const std::filesystem::path& path);

}  // namespace trivet::exchange
