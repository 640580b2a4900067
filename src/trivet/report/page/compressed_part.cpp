// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/compressed_part.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

#include "trivet/documents/base64.h"

namespace trivet::report {
namespace {

constexpr std::size_t most_bytes = std::numeric_limits<uInt>::max();  // of one call of zlib

[[noreturn]] void fail(std::size_t size, const std::string& reason) {
  throw std::runtime_error(fmt::format("a part of the report, {} bytes, cannot be compressed: {}", size, reason));
}

void check(int status, int wanted, std::size_t size) {
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  if (status != wanted) fail(size, fmt::format("zlib {}: status {}", zlibVersion(), status));
}

/// Its header has no time and no name.
std::vector<std::uint8_t> gzip(std::string_view text) {
  constexpr int window_with_gzip_header = 15 + 16, memory = 9;
  z_stream stream = {};
  if (text.size() > most_bytes) fail(text.size(), fmt::format("it has more than {}", most_bytes));
  check(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window_with_gzip_header, memory, Z_DEFAULT_STRATEGY),
        Z_OK, text.size());
  const std::unique_ptr<z_stream, int (*)(z_stream*)> ended(&stream, deflateEnd);
  std::vector<std::uint8_t> bytes(std::min<std::size_t>(deflateBound(&stream, text.size()), most_bytes));
  // zlib only reads the input; its interface predates const.
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = bytes.data();
  stream.avail_out = static_cast<uInt>(bytes.size());
  check(deflate(&stream, Z_FINISH), Z_STREAM_END, text.size());
  bytes.resize(stream.total_out);
  return bytes;
}

}  // namespace

std::string compressed_part(std::string_view text) { return documents::base64(gzip(text)); }

}  // namespace trivet::report
