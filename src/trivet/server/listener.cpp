// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/listener.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "trivet/foundation/invalid_input.h"

namespace trivet::server {

using boost::asio::ip::tcp;

Listener::Listener(boost::asio::io_context& loop, std::uint16_t port, std::uint16_t preferred)
    : acceptor_(loop), pause_(loop) {
  boost::system::error_code error = open(port != 0 ? port : preferred);
  if (error && port == 0 && preferred != 0) error = open(0);
  if (error)
    throw foundation::InvalidInput(
        fmt::format("port {}: {}; choose another with --port, or leave it out for a free one", port, error.message()));
}

boost::system::error_code Listener::open(std::uint16_t port) {
  const tcp::endpoint place(boost::asio::ip::address_v4::loopback(), port);
  boost::system::error_code error, ignored;
  acceptor_.close(ignored);
  acceptor_.open(place.protocol(), error);
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);  // of an earlier server that has ended
  if (!error) acceptor_.bind(place, error);
  if (!error) acceptor_.listen(tcp::acceptor::max_listen_connections, error);
  return error;
}

std::uint16_t Listener::port() const { return acceptor_.local_endpoint().port(); }

void Listener::begin(Site& site) { accept(site); }

void Listener::accept(Site& site) {
  acceptor_.async_accept([this, &site](const boost::system::error_code& error, tcp::socket socket) {
    if (!error) {
      accept(site);  // first, so that a failure of this one connection does not end the loop
      return add(std::move(socket), site);
    }
    pause_.expires_after(std::chrono::milliseconds(50));  // no descriptors left, for instance
    pause_.async_wait([this, &site](const boost::system::error_code&) { accept(site); });
  });
}

void Listener::add(tcp::socket socket, Site& site) {
  if (!makes_room()) return;  // the destructor closes the socket
  const auto connection = std::make_shared<Connection>(std::move(socket), site);
  connections_.push_back(connection);
  connection->begin();
}

bool Listener::makes_room() {
  std::erase_if(connections_, [](const std::weak_ptr<Connection>& one) {
    const auto connection = one.lock();
    return !connection || connection->is_closed();
  });
  if (connections_.size() < most_connections) return true;
  std::shared_ptr<Connection> oldest;
  for (const std::weak_ptr<Connection>& one : connections_)
    if (const auto connection = one.lock(); connection && connection->waits_for_client())
      if (!oldest || connection->since() < oldest->since()) oldest = connection;
  if (oldest) oldest->close();
  return oldest != nullptr;
}

}  // namespace trivet::server
