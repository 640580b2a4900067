// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/refusal_log.h"

#include <fmt/format.h>

#include "trivet/engine/program.h"

namespace trivet::server {
namespace {

constexpr std::size_t most_lines = 10;
constexpr std::size_t longest_about = 100;  // characters

}  // namespace

void RefusalLog::add(int status, std::string_view about, std::string_view reason, Clock::time_point now) {
  if (now - second_ >= std::chrono::seconds(1)) {
    if (in_second_ > most_lines) write_(fmt::format("refused: {} more\n", in_second_ - most_lines));
    second_ = now;
    in_second_ = 0;
  }
  if (++in_second_ <= most_lines)
    write_(fmt::format("refused: {} {}: {}\n", status, engine::on_one_line(about.substr(0, longest_about)),
                       engine::on_one_line(reason)));
}

}  // namespace trivet::server
