// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/request_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <system_error>

namespace trivet::server {
namespace {

struct DataPath {
  const char* path;
  const char* method;
  Route route;
};
constexpr std::array<DataPath, 8> data_paths = {{{"/resume", "GET", Route::resume},
                                                 {"/project", "GET", Route::project},
                                                 {"/version", "GET", Route::version},
                                                 {"/progress", "GET", Route::progress},
                                                 {"/schema", "GET", Route::schema},
                                                 {"/ask", "POST", Route::ask},
                                                 {"/text", "POST", Route::text},
                                                 {"/save", "POST", Route::save}}};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return lower;
}

std::vector<std::string> values_of(const RequestHead& head, std::string_view lower_name) {
  std::vector<std::string> values;
  for (const auto& [name, value] : head.fields)
    if (lower_case(name) == lower_name) values.push_back(value);
  return values;
}

/// The value of a field that is there once; nullopt otherwise.
std::optional<std::string> single(const RequestHead& head, std::string_view lower_name) {
  const std::vector<std::string> values = values_of(head, lower_name);
  return values.size() == 1 ? std::optional(values.front()) : std::nullopt;
}

/// Is this "127.0.0.1:PORT" or another name of this server?
bool is_our_host(const std::string& host, std::uint16_t port) {
  const std::string given = lower_case(host);
  return std::ranges::any_of(std::array{"127.0.0.1", "localhost", "[::1]"}, [&](const char* name) {
    return given == fmt::format("{}:{}", name, port) || (port == 80 && given == name);
  });
}

/// Takes the same time wherever the two differ.
bool is_equal_token(std::string_view given, std::string_view token) {
  if (given.size() != token.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < token.size(); ++i)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(token[i]));
  return difference == 0;
}

std::optional<Refusal> form_refusal(const RequestHead& head) {
  if (head.fields.size() > most_fields) return Refusal{431, fmt::format("more than {} header fields", most_fields)};
  if (!values_of(head, "transfer-encoding").empty())
    return Refusal{411, "Transfer-Encoding is not accepted; send the body with its Content-Length"};
  if (head.method != "GET" && head.method != "POST") return Refusal{405, "the methods are GET and POST", "GET, POST"};
  if (!head.target.starts_with('/')) return Refusal{400, "the target of a request is a path, such as /project"};
  return std::nullopt;
}

/// A name that another site has directed to this machine, and a page of another site or port, are refused.
std::optional<Refusal> sender_refusal(const RequestHead& head, bool is_data, std::uint16_t port) {
  const auto host = single(head, "host");
  if (!host) return Refusal{400, "a request has one Host"};
  if (!is_our_host(*host, port))
    return Refusal{403, fmt::format("Host is not this server; open http://127.0.0.1:{}/", port)};
  for (const std::string& origin : values_of(head, "origin"))
    if (!origin.starts_with("http://") || !is_our_host(origin.substr(7), port))
      return Refusal{403, "Origin is another page"};
  const std::vector<std::string> sites = values_of(head, "sec-fetch-site");
  const bool is_opened = !is_data && single(head, "sec-fetch-mode") == "navigate" &&
      single(head, "sec-fetch-dest") == "document";  // by a link, a bookmark or the file that begins a session
  for (const std::string& site : sites)
    if (site != "same-origin" && !is_opened && (is_data || site != "none"))
      return Refusal{403, "Sec-Fetch-Site is \"" + site.substr(0, 20) + "\": another page asks"};
  return std::nullopt;
}

/// The length of the body, or why it is not read.
tl::expected<std::uint64_t, Refusal> judged_length(const RequestHead& head) {
  const std::vector<std::string> lengths = values_of(head, "content-length");
  const bool is_post = head.method == "POST";
  if (lengths.empty() && is_post) return tl::make_unexpected(Refusal{411, "POST needs a Content-Length"});
  if (lengths.empty()) return 0;
  std::uint64_t length = 0;
  const std::string& text = lengths.front();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (lengths.size() > 1 || text.empty() || end != text.data() + text.size() ||
      (error != std::errc() && error != std::errc::result_out_of_range))
    return tl::make_unexpected(Refusal{400, "Content-Length is not one number"});
  if (error == std::errc::result_out_of_range || length > longest_body)
    return tl::make_unexpected(Refusal{413, fmt::format("the body is longer than {} bytes", longest_body)});
  if (!is_post && length > 0) return tl::make_unexpected(Refusal{400, "GET has no body"});
  return length;
}

bool is_json(const RequestHead& head) {
  const auto type = single(head, "content-type");
  if (!type) return false;
  const std::string name = lower_case(type->substr(0, type->find(';')));
  return name.substr(0, name.find_last_not_of(" \t") + 1) == "application/json";
}

}  // namespace

tl::expected<AcceptedRequest, Refusal> judged(const RequestHead& head, const RequestRules& rules) {
  const auto refuse = [](Refusal refusal) { return tl::make_unexpected(std::move(refusal)); };
  if (auto refusal = form_refusal(head)) return refuse(*refusal);
  AcceptedRequest accepted{.path = head.target.substr(0, head.target.find_first_of("?#"))};
  const auto* data = std::ranges::find_if(data_paths, [&](const DataPath& one) { return accepted.path == one.path; });
  const bool is_data = data != data_paths.end();
  if (auto refusal = sender_refusal(head, is_data, rules.port)) return refuse(*refusal);
  if (!is_data && !rules.is_page_file(accepted.path)) return refuse({404, "there is nothing of this name"});
  const std::string method = is_data ? data->method : "GET";
  if (head.method != method) return refuse({405, "the method of " + accepted.path + " is " + method, method});
  if (is_data) {
    accepted.route = data->route;
    const auto token = single(head, "x-trivet-token");
    const bool needs_token = data->route != Route::resume;  // whose answer only a page with the key can read
    if (needs_token && (!token || !is_equal_token(*token, rules.token)))
      return refuse(
          {401, "X-Trivet-Token is missing or that of another start; open the address that `trivet serve` prints"});
  }
  const auto length = judged_length(head);
  if (!length) return refuse(length.error());
  accepted.content_length = *length;
  if (method == "POST" && !is_json(head)) return refuse({415, "the body of POST is application/json"});
  if (accepted.route == Route::save && rules.read_only)
    return refuse({403, "the server was started with --read-only; nothing is saved"});
  accepted.nonce = single(head, "x-trivet-nonce").value_or("");
  accepted.client = single(head, "x-trivet-client").value_or("").substr(0, 64);
  return accepted;
}

}  // namespace trivet::server
