// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

/// The page of a project for a browser of this machine (docs/serve.md): judges requests, serves the embedded page, asks
/// the engine and saves. It computes nothing itself.
namespace trivet::server {

inline constexpr std::size_t most_fields = 64;            ///< header fields of a request
inline constexpr std::uint32_t longest_head = 8192;       ///< [bytes] request line and header fields
inline constexpr std::uint64_t longest_body = 8'000'000;  ///< [bytes]

/// A request up to its body.
struct RequestHead {
  std::string method, target;
  std::vector<std::pair<std::string, std::string>> fields = {};  ///< names in any case
};

/// Why a request is not served.
struct Refusal {
  int status = 400;
  std::string reason;      ///< a sentence
  std::string allow = {};  ///< of status 405: methods that the path has
};

enum class Route { page_file, resume, project, version, progress, schema, ask, text, save };

struct AcceptedRequest {
  Route route = Route::page_file;
  std::string path;    ///< without a query
  std::string client;  ///< X-Trivet-Client: which page asks; empty if it does not say
  std::string nonce;   ///< X-Trivet-Nonce, of a page that wants to go on with this start of the program
  std::uint64_t content_length = 0;
};

struct RequestRules {
  std::uint16_t port = 0;
  std::string token;
  bool read_only = false;
  std::function<bool(std::string_view path)> is_page_file;
};

/// Judges a request before its body is read: method, host, origin, site, path, token, length and type of the body.
[[nodiscard]] tl::expected<AcceptedRequest, Refusal> judged(const RequestHead& head, const RequestRules& rules);

}  // namespace trivet::server
