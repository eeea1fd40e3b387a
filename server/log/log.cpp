#include "log/log.h"

#include <spdlog/async.h>
#include <spdlog/formatter.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <ctime>
#include <future>
#include <iterator>
#include <thread>

#include "log/escape.h"

namespace saccade {
namespace {

class TextFormatter : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override {
    const std::string text = escapeControls({message.payload.data(), message.payload.size()});
    spdlog::details::log_msg escaped = message;
    escaped.payload = text;
    pattern_.format(escaped, line);
    message.color_range_start = escaped.color_range_start;
    message.color_range_end = escaped.color_range_end;
  }
  std::unique_ptr<formatter> clone() const override { return std::make_unique<TextFormatter>(); }

 private:
  spdlog::pattern_formatter pattern_{"[%Y-%m-%d %H:%M:%S.%e] [%^%l%$] %v"};
};

class JsonFormatter : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override {
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(message.time.time_since_epoch()).count();
    const std::time_t seconds = ms / 1000;
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    char time[32];
    std::strftime(time, sizeof time, "%FT%T", &utc);
    const auto level = spdlog::level::to_string_view(message.level);
    fmt::format_to(std::back_inserter(line),
                   R"({{"time":"{}.{:03}Z","level":"{}","message":{}}})"
                   "\n",
                   time, ms % 1000, std::string_view(level.data(), level.size()),
                   quoteJson({message.payload.data(), message.payload.size()}));
  }
  std::unique_ptr<formatter> clone() const override { return std::make_unique<JsonFormatter>(); }
};

}  // namespace

void setUpLog(const std::string& level, const std::string& format) {
  spdlog::init_thread_pool(kLogQueue, 1);
  const auto sink = std::make_shared<spdlog::sinks::stdout_color_sink_mt>();
  const auto logger = std::make_shared<spdlog::async_logger>("saccaded", sink, spdlog::thread_pool(),
                                                             spdlog::async_overflow_policy::overrun_oldest);
  logger->set_error_handler([](const std::string&) {});
  spdlog::set_default_logger(logger);
  spdlog::set_level(spdlog::level::from_str(level));
  if (format == "json") {
    spdlog::set_formatter(std::make_unique<JsonFormatter>());
  } else {
    spdlog::set_formatter(std::make_unique<TextFormatter>());
  }
}

bool finishLog() {
  std::promise<void> finished;
  const std::future<void> result = finished.get_future();
  std::thread([pool = spdlog::thread_pool(), finished = std::move(finished)]() mutable {
    spdlog::details::registry::instance().set_tp(nullptr);
    pool.reset();  // the last one: writes what waits, and ends its thread
    finished.set_value();
  }).detach();
  return result.wait_for(kLogTimeout) == std::future_status::ready;
}

std::size_t droppedLogLines() {
  const auto pool = spdlog::thread_pool();
  return pool ? pool->overrun_counter() : 0;
}

}  // namespace saccade
