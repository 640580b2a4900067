// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace trivet::server {

struct ServeOptions {
  std::string file;                                     ///< the project; empty: a page that offers examples
  std::uint16_t port = 0;                               ///< of 127.0.0.1; 0: any free one
  bool read_only = false;                               ///< the page cannot save
  std::function<void(std::string_view text)> say, log;  ///< standard output and standard error; any thread
  /// Shows a file in a browser; the reason if that fails. Empty: the address is printed instead.
  std::function<std::string(const std::string& file)> show;
};

/// Serves the page until the process ends. A wrong project is served, too; its problems are content.
/// @throws foundation::InvalidInput with a message if the port cannot be used
[[noreturn]] void serve(const ServeOptions& options);

}  // namespace trivet::server
