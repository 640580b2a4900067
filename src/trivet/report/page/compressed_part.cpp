// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/compressed_part.h"

#include <zlib.h>

#include <cstdint>
#include <new>
#include <stdexcept>
#include <vector>

#include "trivet/documents/base64.h"

namespace trivet::report {
namespace {

/// Its header has no time and no name.
std::vector<std::uint8_t> gzip(std::string_view text) {
  constexpr int window_with_gzip_header = 15 + 16, memory = 9;
  z_stream stream = {};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window_with_gzip_header, memory, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::bad_alloc();
  std::vector<std::uint8_t> bytes(deflateBound(&stream, text.size()));
  // zlib only reads the input; its interface predates const.
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = bytes.data();
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::runtime_error("a part of the report cannot be compressed");
  return bytes;
}

}  // namespace

std::string compressed_part(std::string_view text) { return documents::base64(gzip(text)); }

}  // namespace trivet::report
