// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/connection.h"

#include <sys/socket.h>

#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/read.hpp>
#include <cerrno>
#include <limits>
#include <utility>

namespace trivet::server {
namespace {

namespace net = boost::asio;
namespace http = boost::beast::http;
using namespace std::chrono_literals;

constexpr auto request_time = 5000ms;  // for a whole request, from its first byte (the first one: from the connection)
constexpr auto idle_time = 60'000ms;   // between two requests of a connection
constexpr auto answer_time = 10'000ms;
constexpr auto drain_time = 1000ms;
constexpr auto no_deadline = std::chrono::milliseconds::max();
constexpr std::size_t most_drained = 1u << 20;    // bytes after a refusal
constexpr std::size_t largest_buffer = 1u << 17;  // bytes that wait for the parser

RequestHead head_from(const http::request<http::string_body>& request) {
  RequestHead head{std::string(request.method_string()), std::string(request.target())};
  for (const auto& field : request)
    head.fields.emplace_back(std::string(field.name_string()), std::string(field.value()));
  return head;
}

}  // namespace

Connection::Connection(net::ip::tcp::socket socket, Site& site)
    : socket_(std::move(socket)), site_(site), deadline_(socket_.get_executor()), buffer_(largest_buffer) {}

void Connection::begin() {
  Error ignored;
  socket_.set_option(net::ip::tcp::no_delay(true), ignored);
  wait_for_request();
  if (state_ == State::idle) read_head();  // the deadline of the first request begins with the connection
}

void Connection::close() {
  state_ = State::closed;
  *has_left_ = true;
  deadline_.cancel();
  Error ignored;
  socket_.close(ignored);
}

void Connection::enter(State state, std::chrono::milliseconds deadline) {
  state_ = state;
  if (deadline == no_deadline) {
    deadline_.cancel();
    return;
  }
  deadline_.expires_after(deadline);
  deadline_.async_wait([self = shared_from_this()](const Error& error) {
    if (!error && self->deadline_.expiry() <= Clock::now()) self->on_deadline();
  });
}

void Connection::wait_for_request() {
  parser_.emplace();
  parser_->header_limit(longest_head);
  parser_->body_limit(std::numeric_limits<std::uint64_t>::max());  // judged with the head, before the body is read
  about_ = "a request without a head";
  since_ = Clock::now();
  state_ = State::idle;
}

void Connection::read_head() {
  enter(State::reading, request_time);
  http::async_read_header(socket_, buffer_, *parser_, [self = shared_from_this()](const Error& error, std::size_t) {
    if (self->state_ != State::reading) return;
    if (error) self->on_read_error(error);
    else self->judge();
  });
}

void Connection::judge() {
  const RequestHead head = head_from(parser_->get());
  about_ = head.method + " " + head.target;
  const auto accepted = judged(head, site_.rules);
  if (!accepted) return refuse(accepted.error());
  if (accepted->content_length == 0) return work(*accepted);
  read_body(*accepted);
}

void Connection::read_body(const AcceptedRequest& request) {
  http::async_read(socket_, buffer_, *parser_, [self = shared_from_this(), request](const Error& error, std::size_t) {
    if (self->state_ != State::reading) return;
    if (error) self->on_read_error(error);
    else self->work(request);
  });
}

void Connection::work(const AcceptedRequest& request) {
  enter(State::working, no_deadline);
  watch_client();
  const bool keeps_alive = parser_->get().keep_alive();
  // The reply leaves nothing of the connection on its thread, so that the loop's thread destroys it.
  Reply reply = [self = shared_from_this(), keeps_alive](Answer answer) mutable {
    const auto loop = self->socket_.get_executor();
    net::post(loop, [self = std::move(self), keeps_alive, answer = std::move(answer)]() mutable {
      self->on_answer(std::move(answer), keeps_alive);
    });
  };
  site_.respond(request, std::move(parser_->get().body()), has_left_, std::move(reply));
}

void Connection::on_answer(Answer answer, bool keeps_alive) {
  if (state_ != State::working) return;
  Error ignored;
  socket_.cancel(ignored);                                                // ends watch_client
  const bool is_everyday = answer.status == 409 || answer.status == 412;  // a newer question, a changed file
  if (answer.status >= 400 && !is_everyday) site_.log.add(answer.status, about_, answer.body);
  send(std::move(answer), keeps_alive);
}

/// A client that closes its connection needs no answer, and its computation ends.
void Connection::watch_client() {
  socket_.async_wait(net::ip::tcp::socket::wait_read, [self = shared_from_this()](const Error& error) {
    char byte = 0;
    if (error || self->state_ != State::working) return;
    const ssize_t count = recv(self->socket_.native_handle(), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) self->close();
  });
}

void Connection::refuse(const Refusal& refusal) {
  site_.log.add(refusal.status, about_, refusal.reason);
  send(refusal_answer(refusal), false);
}

void Connection::send(Answer answer, bool keeps_alive) {
  enter(State::writing, answer_time);
  answer_ = std::move(answer);
  head_ = head_of(answer_, keeps_alive);
  const std::array<net::const_buffer, 2> pieces = {net::buffer(head_),
                                                   net::buffer(answer_.content().data(), answer_.content().size())};
  net::async_write(socket_, pieces, [self = shared_from_this(), keeps_alive](const Error& error, std::size_t) {
    if (self->state_ != State::writing) return;
    if (error) self->close();
    else self->after_answer(keeps_alive);
  });
}

void Connection::after_answer(bool keeps_alive) {
  answer_ = {};
  if (!keeps_alive) {
    Error ignored;
    socket_.shutdown(net::ip::tcp::socket::shutdown_send, ignored);
    since_ = Clock::now();
    enter(State::draining, drain_time);
    return drain(0);
  }
  wait_for_request();
  if (buffer_.size() > 0) return read_head();
  enter(State::idle, idle_time);
  socket_.async_wait(net::ip::tcp::socket::wait_read, [self = shared_from_this()](const Error& error) {
    if (self->state_ != State::idle) return;
    if (error) self->close();
    else self->read_head();
  });
}

/// Closing a socket with unread bytes can take the answer from the client, so a part of them is read first.
void Connection::drain(std::size_t drained) {
  socket_.async_read_some(net::buffer(drained_),
                          [self = shared_from_this(), drained](const Error& error, std::size_t count) {
                            if (self->state_ != State::draining) return;
                            if (error || drained + count > most_drained) self->close();
                            else self->drain(drained + count);
                          });
}

void Connection::on_deadline() {
  if (state_ == State::working) return;  // it passed just before the request was complete
  if (state_ == State::reading && parser_->got_some()) {
    const Refusal refusal{408, "the request is not complete after 5 s"};
    site_.log.add(refusal.status, about_, refusal.reason);
    const std::string text = head_of(refusal_answer(refusal), false) + refusal_answer(refusal).body;
    Error ignored;
    socket_.non_blocking(true, ignored);
    socket_.write_some(net::buffer(text), ignored);  // whoever reads it
  }
  close();
}

void Connection::on_read_error(const Error& error) {
  if (error == http::error::header_limit) return refuse({431, "the head of the request is longer than 8192 bytes"});
  const bool is_malformed = error.category() == http::make_error_code(http::error::bad_method).category() &&
      error != http::error::end_of_stream && error != http::error::partial_message;
  if (is_malformed) return refuse({400, "no valid HTTP request: " + error.message()});
  close();
}

}  // namespace trivet::server
