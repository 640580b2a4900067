// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: any bytes as a universal file. What is read can be written in both forms and read again.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "trivet/exchange/universal/universal_reading.h"
#include "trivet/exchange/universal/universal_writing.h"
#include "trivet/foundation/invalid_input.h"

namespace {

using trivet::exchange::FunctionForm;
using trivet::exchange::UniversalFile;

/// The written file, or an empty text if it cannot hold the content.
std::string written(const UniversalFile& file, FunctionForm form) {
  try {
    return trivet::exchange::universal_text(file, form);
  } catch (const trivet::foundation::InvalidInput&) {
    return "";
  }
}

void read_again(const UniversalFile& file, FunctionForm form) {
  const std::string text = written(file, form);
  if (text.empty()) return;
  const auto read = trivet::exchange::read_universal_text(text, "fuzz");
  if (!read) std::fprintf(stderr, "%s\n", message(read.error().list().front()).c_str());
  if (!read || read->file.functions.size() != file.functions.size() || read->file.modes.size() != file.modes.size() ||
      read->file.nodes.size() != file.nodes.size() || read->file.lines.size() != file.lines.size())
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto read = trivet::exchange::read_universal_text(text, "fuzz");
  if (!read) return 0;
  for (const FunctionForm form : {FunctionForm::ascii, FunctionForm::binary}) read_again(read->file, form);
  return 0;
}
