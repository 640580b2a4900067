// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/request_rules.h"

#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

namespace request_rules_test {
namespace {

using trivet::server::judged;
using trivet::server::RequestHead;
using trivet::server::RequestRules;
using trivet::server::Route;

const RequestRules rules{
    .port = 4711, .token = "0123abcd", .is_page_file = [](std::string_view path) { return path == "/"; }};

RequestHead get(const std::string& target) {
  return {
      "GET", target, {{"Host", "127.0.0.1:4711"}, {"X-Trivet-Token", "0123abcd"}, {"Sec-Fetch-Site", "same-origin"}}};
}

RequestHead post(const std::string& target) {
  RequestHead head = get(target);
  head.method = "POST";
  head.fields.emplace_back("Content-Type", "application/json");
  head.fields.emplace_back("Content-Length", "2");
  return head;
}

RequestHead with(RequestHead head, const std::string& name, const std::string& value) {
  for (auto& field : head.fields)
    if (field.first == name) {
      field.second = value;
      return head;
    }
  head.fields.emplace_back(name, value);
  return head;
}

RequestHead without(RequestHead head, const std::string& name) {
  std::erase_if(head.fields, [&](const auto& field) { return field.first == name; });
  return head;
}

/// 200, or the status of the refusal.
int status(const RequestHead& head, const RequestRules& by = rules) {
  const auto found = judged(head, by);
  return found ? 200 : found.error().status;
}

TEST(RequestRules, AcceptWhatThePageSends) {
  EXPECT_EQ(judged(get("/"), rules)->route, Route::page_file);
  EXPECT_EQ(judged(get("/project?x=1"), rules)->route, Route::project);
  const auto ask = judged(with(post("/ask"), "X-Trivet-Client", "tab 1"), rules);
  EXPECT_EQ(ask->route, Route::ask);
  EXPECT_EQ(ask->content_length, 2u);
  EXPECT_EQ(ask->client, "tab 1");
}

TEST(RequestRules, NamesOfFieldsAreInAnyCase) {
  EXPECT_EQ(status({"GET", "/project", {{"HOST", "LocalHost:4711"}, {"x-trivet-TOKEN", "0123abcd"}}}), 200);
}

TEST(RequestRules, TheTokenIsForDataAlone) {
  for (const char* wrong : {"", "0123abc", "0123abcD", "0123abcd0", "1123abcd"}) {
    EXPECT_EQ(status(with(get("/project"), "X-Trivet-Token", wrong)), 401) << wrong;
    EXPECT_EQ(status(with(get("/"), "X-Trivet-Token", wrong)), 200) << wrong;
  }
  EXPECT_EQ(status(without(get("/schema"), "X-Trivet-Token")), 401);
  RequestHead twice = get("/project");
  twice.fields.emplace_back("X-Trivet-Token", "0123abcd");
  EXPECT_EQ(status(twice), 401);
}

TEST(RequestRules, TheHostIsThisServer) {
  for (const char* path : {"/", "/project"}) {
    for (const char* ours : {"127.0.0.1:4711", "localhost:4711", "[::1]:4711"})
      EXPECT_EQ(status(with(get(path), "Host", ours)), 200) << ours;
    for (const char* foreign : {"127.0.0.1", "127.0.0.1:4712", "example.com:4711", "127.0.0.1:4711.example.com", ""})
      EXPECT_EQ(status(with(get(path), "Host", foreign)), 403) << foreign;
    EXPECT_EQ(status(without(get(path), "Host")), 400);
  }
  RequestRules usual = rules;
  usual.port = 80;
  EXPECT_EQ(status(with(get("/"), "Host", "localhost"), usual), 200);
}

TEST(RequestRules, TheSenderIsThePage) {
  EXPECT_EQ(status(with(post("/ask"), "Origin", "http://127.0.0.1:4711")), 200);
  for (const char* foreign :
       {"null", "http://127.0.0.1:4712", "https://127.0.0.1:4711", "http://example.com", "http://"})
    EXPECT_EQ(status(with(post("/ask"), "Origin", foreign)), 403) << foreign;
  EXPECT_EQ(status(without(get("/project"), "Sec-Fetch-Site")), 200);
  for (const char* foreign : {"same-site", "cross-site", "none", ""})
    EXPECT_EQ(status(with(get("/project"), "Sec-Fetch-Site", foreign)), 403) << foreign;
}

TEST(RequestRules, AnotherPageMayOpenThisOneButNotUseIt) {
  RequestHead opened = with(with(get("/"), "Sec-Fetch-Site", "cross-site"), "Sec-Fetch-Mode", "navigate");
  EXPECT_EQ(status(opened), 403);
  opened = with(opened, "Sec-Fetch-Dest", "document");
  EXPECT_EQ(status(opened), 200);
  opened.target = "/project";
  EXPECT_EQ(status(opened), 403);
}

TEST(RequestRules, MethodsAndPaths) {
  EXPECT_EQ(status(get("/nothing")), 404);
  EXPECT_EQ(status(get("http://127.0.0.1:4711/")), 400);
  EXPECT_EQ(status(get("*")), 400);
  EXPECT_EQ(judged(get("/ask"), rules).error().allow, "POST");
  EXPECT_EQ(judged(post("/project"), rules).error().allow, "GET");
  RequestHead head = get("/");
  for (const char* other : {"OPTIONS", "HEAD", "PUT", "DELETE", "get"}) {
    head.method = other;
    EXPECT_EQ(status(head), 405) << other;
  }
}

TEST(RequestRules, BodiesAreJsonOfAKnownLength) {
  for (const auto& [length, expected] : std::vector<std::pair<const char*, int>>{{"0", 200},
                                                                                 {"8000000", 200},
                                                                                 {"8000001", 413},
                                                                                 {"99999999999999999999999", 413},
                                                                                 {"-1", 400},
                                                                                 {"+1", 400},
                                                                                 {"1 ", 400},
                                                                                 {"0x10", 400},
                                                                                 {"", 400}})
    EXPECT_EQ(status(with(post("/ask"), "Content-Length", length)), expected) << length;
  EXPECT_EQ(status(without(post("/ask"), "Content-Length")), 411);
  RequestHead twice = post("/ask");
  twice.fields.emplace_back("Content-Length", "2");
  EXPECT_EQ(status(twice), 400);
  EXPECT_EQ(status(with(post("/ask"), "Transfer-Encoding", "chunked")), 411);
  EXPECT_EQ(status(with(get("/"), "Transfer-Encoding", "identity")), 411);
  EXPECT_EQ(status(with(get("/project"), "Content-Length", "1")), 400);
  for (const char* type : {"", "text/plain", "application/json-seq", "application/x-www-form-urlencoded"})
    EXPECT_EQ(status(with(post("/save"), "Content-Type", type)), 415) << type;
  EXPECT_EQ(status(with(post("/save"), "Content-Type", "Application/JSON ; charset=utf-8")), 200);
}

TEST(RequestRules, NumberOfFields) {
  RequestHead many = get("/");
  while (many.fields.size() < trivet::server::most_fields) many.fields.emplace_back("A", "");
  EXPECT_EQ(status(many), 200);
  many.fields.emplace_back("A", "");
  EXPECT_EQ(status(many), 431);
}

TEST(RequestRules, ReadOnlyRefusesToSaveAlone) {
  RequestRules read_only = rules;
  read_only.read_only = true;
  EXPECT_EQ(status(post("/save"), read_only), 403);
  EXPECT_EQ(status(post("/text"), read_only), 200);
}

}  // namespace
}  // namespace request_rules_test
