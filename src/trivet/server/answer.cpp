// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/answer.h"

#include <fmt/format.h>

#include "trivet/documents/json_text.h"

namespace trivet::server {
namespace {

const char* status_words(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 401:
      return "Unauthorized";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 408:
      return "Request Timeout";
    case 409:
      return "Conflict";
    case 411:
      return "Length Required";
    case 412:
      return "Precondition Failed";
    case 413:
      return "Content Too Large";
    case 415:
      return "Unsupported Media Type";
    case 422:
      return "Unprocessable Content";
    case 431:
      return "Request Header Fields Too Large";
    default:
      return "Internal Server Error";
  }
}

// No script and no style but the embedded ones, no request to another machine, no frame around the page. No field
// permits another origin to read anything (CORS), and there are no cookies, which every port of this machine would get.
constexpr const char* fixed_fields =
    "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
    "img-src 'self' data: blob:; media-src blob:; font-src 'self'; worker-src 'self'; frame-ancestors 'none'; "
    "base-uri 'none'; form-action 'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Referrer-Policy: no-referrer\r\n";

}  // namespace

Answer error_answer(int status, const std::string& sentence) {
  return {.status = status, .body = documents::json::text({{"error", sentence}})};
}

Answer refusal_answer(const Refusal& refusal) {
  Answer answer = error_answer(refusal.status, refusal.reason);
  answer.allow = refusal.allow;
  return answer;
}

std::string head_of(const Answer& answer, bool keeps_alive) {
  std::string head =
      fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}; charset=utf-8\r\nContent-Length: {}\r\nCache-Control: {}\r\n{}",
                  answer.status, status_words(answer.status), answer.type, answer.content().size(),
                  answer.file.empty() ? "no-store" : "no-cache", fixed_fields);
  if (!answer.allow.empty()) head += "Allow: " + answer.allow + "\r\n";
  if (answer.status == 401) head += "WWW-Authenticate: X-Trivet-Token\r\n";
  return head + (keeps_alive ? "Connection: keep-alive\r\n\r\n" : "Connection: close\r\n\r\n");
}

}  // namespace trivet::server
