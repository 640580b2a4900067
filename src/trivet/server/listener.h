// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "trivet/server/connection.h"

namespace trivet::server {

/// Accepts connections of this machine. There are at most 64; for a further one the oldest that waits for its
/// client is closed, so slow clients do not keep others out.
class Listener {
 public:
  static constexpr std::size_t most_connections = 64;

  /// @param port       0: `preferred` if it is free (0: none is preferred), otherwise any free one
  /// @throws foundation::InvalidInput if the port cannot be used
  Listener(boost::asio::io_context& loop, std::uint16_t port, std::uint16_t preferred);

  [[nodiscard]] std::uint16_t port() const;
  /// @param site  must outlive the loop
  void begin(Site& site);

 private:
  [[nodiscard]] boost::system::error_code open(std::uint16_t port);
  void accept(Site& site);
  void add(boost::asio::ip::tcp::socket socket, Site& site);
  /// @returns false if all connections are at work
  [[nodiscard]] bool makes_room();

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_;
  std::vector<std::weak_ptr<Connection>> connections_;
};

}  // namespace trivet::server
