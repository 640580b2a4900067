// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/page_server.h"

#include <fmt/format.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "trivet/documents/json_text.h"
#include "trivet/engine/program.h"
#include "trivet/server/listener.h"
#include "trivet/server/page_files.h"
#include "trivet/server/project_service.h"
#include "trivet/server/resumption.h"
#include "trivet/server/session_start.h"
#include "trivet/server/worker.h"

namespace trivet::server {
namespace {

Answer page_file_answer(const std::string& path) {
  const EmbeddedFile* file = find_page_file(path);  // judged to exist
  const std::string_view name = file->name;
  return {.file = file->content, .type = media_type(name)};
}

constexpr std::size_t nonce_length = 64;  // hexadecimal

Answer resume_answer(const std::string& token, const Resumption& resumption, const std::string& page_nonce) {
  if (page_nonce.size() != nonce_length) return error_answer(400, "X-Trivet-Nonce must have 64 characters");
  const SealedToken sealed = sealed_token(token, resumption, page_nonce, new_token());
  return {.body = documents::json::text({{"nonce", sealed.nonce}, {"sealed", sealed.sealed}, {"proof", sealed.proof}})};
}

/// Pages whose results are computed side by side; each computation may use all processors.
constexpr std::size_t most_computing_pages = 4;

Answer progress_answer(const std::optional<Doing>& doing) {
  if (!doing) return {.body = documents::json::text({{"task", nullptr}})};
  return {.body = documents::json::text({{"task", doing->task}, {"fraction", doing->fraction}})};
}

/// Who computes what: files of the page at once, results on a thread for each page, reading and saving on another one.
class Responder {
 public:
  Responder(const ServeOptions& options, std::string token, Resumption resumption)
      : token_(std::move(token)),
        resumption_(std::move(resumption)),
        service_(options.file, options.read_only, resumption_.key) {}

  void respond(const AcceptedRequest& request, std::string body, HasLeft has_left, Reply reply) {
    WorkerTask task{.reply = std::move(reply), .has_left = std::move(has_left)};
    switch (request.route) {
      case Route::page_file:
        return task.reply(page_file_answer(request.path));
      case Route::resume:
        return task.reply(resume_answer(token_, resumption_, request.nonce));
      case Route::schema:
        return task.reply(schema_answer());
      case Route::progress:
        return task.reply(progress_answer(results_.doing(request.client)));
      case Route::ask:
        task.client = request.client;
        task.compute = [this, client = request.client, body = std::move(body)](const auto& progress) {
          return service_.ask(client, body, progress);
        };
        return results_.put(std::move(task));
      case Route::project:
        task.compute = [this](const auto& progress) { return service_.project(progress); };
        break;
      case Route::version:
        task.compute = [this](const auto&) { return service_.version(); };
        break;
      case Route::text:
        task.compute = [this, client = request.client, body = std::move(body)](const auto&) {
          return service_.text(client, body);
        };
        break;
      case Route::save:
        task.compute = [this, client = request.client, body = std::move(body)](const auto&) {
          return service_.save(client, body);
        };
        task.has_left = std::make_shared<const std::atomic<bool>>(false);  // saved, even if the page is closed
        break;
    }
    files_.put(std::move(task));
  }

 private:
  const std::string token_;
  const Resumption resumption_;
  ProjectService service_;
  Worker results_{most_computing_pages}, files_{1};
};

/// The browser may be this call until it is closed, so it has its own thread.
void show_in_browser(const ServeOptions& options, const std::string& address, const std::string& redirect) {
  std::thread([&options, address, redirect] {
    const std::string reason = options.show(redirect);
    if (!reason.empty())
      options.log(fmt::format("the page is not shown: {}\nopen {}\n", engine::on_one_line(reason), address));
  }).detach();
}

}  // namespace

void serve(const ServeOptions& options) {
  boost::asio::io_context loop(1);
  Resumption resumption = last_resumption(options.file, options.log);
  Listener listener(loop, options.port, resumption.port);
  resumption.port = listener.port();
  keep(resumption, options.file);
  const std::string token = new_token();
  Responder responder(options, token, resumption);
  Site site{{.port = listener.port(),
             .token = token,
             .read_only = options.read_only,
             .is_page_file = [](std::string_view path) { return find_page_file(path) != nullptr; }},
            [&](const AcceptedRequest& request, std::string body, HasLeft has_left, Reply reply) {
              responder.respond(request, std::move(body), std::move(has_left), std::move(reply));
            },
            RefusalLog(options.log)};
  listener.begin(site);
  const std::string place = fmt::format("http://127.0.0.1:{}/", site.rules.port);
  const std::string address = place + "#token=" + site.rules.token;
  std::optional<RedirectFile> redirect;  // as long as the server: a browser may start slowly
  if (options.show) {
    show_in_browser(options, address, redirect.emplace(address).path());
    const std::string name = options.file.empty() ? "examples" : engine::on_one_line(options.file);
    options.say(fmt::format("{}: open in your browser at {}; Ctrl-C ends it\n", name, place));
  } else {
    options.say(address + "\n");
  }
  for (;;) {
    try {
      loop.run();
    } catch (const std::exception& failure) {  // of one connection: no memory, for instance
      options.log("error: " + engine::failure_words(failure) + "\n");
    }
  }
}

}  // namespace trivet::server
