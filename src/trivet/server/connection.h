// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "trivet/server/answer.h"
#include "trivet/server/refusal_log.h"
#include "trivet/server/request_rules.h"

namespace trivet::server {

using HasLeft = std::shared_ptr<const std::atomic<bool>>;  ///< true once the client has closed its connection
using Reply = std::function<void(Answer)>;                 ///< called once, on any thread

/// What connections need of the server.
struct Site {
  RequestRules rules;
  std::function<void(const AcceptedRequest& request, std::string body, HasLeft has_left, Reply reply)> respond;
  RefusalLog log;
};

/// One connection of a client: reads a request under a deadline, judges it before its body, has it answered, and waits
/// for the next. All members but the reply are called on the thread of the event loop.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param site  must outlive the connection
  Connection(boost::asio::ip::tcp::socket socket, Site& site);

  void begin();
  void close();

  [[nodiscard]] bool is_closed() const { return state_ == State::closed; }
  /// Does it wait for its client: for a whole request, or for an answer to be read?
  [[nodiscard]] bool waits_for_client() const { return state_ != State::working && state_ != State::closed; }
  /// Since when it has waited for what it does now.
  [[nodiscard]] Clock::time_point since() const { return since_; }

 private:
  enum class State { idle, reading, working, writing, draining, closed };
  using Error = boost::system::error_code;

  void enter(State state, std::chrono::milliseconds deadline);
  void wait_for_request();
  void read_head();
  void judge();
  void read_body(const AcceptedRequest& request);
  void work(const AcceptedRequest& request);
  void on_answer(Answer answer, bool keeps_alive);
  void watch_client();
  void refuse(const Refusal& refusal);
  void send(Answer answer, bool keeps_alive);
  void after_answer(bool keeps_alive);
  void drain(std::size_t drained);
  void on_deadline();
  void on_read_error(const Error& error);

  boost::asio::ip::tcp::socket socket_;
  Site& site_;
  boost::asio::steady_timer deadline_;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  State state_ = State::idle;
  Clock::time_point since_ = Clock::now();
  std::shared_ptr<std::atomic<bool>> has_left_ = std::make_shared<std::atomic<bool>>(false);
  std::string about_;  ///< the request, for the log
  Answer answer_;
  std::string head_;
  std::array<char, 4096> drained_{};
};

}  // namespace trivet::server
