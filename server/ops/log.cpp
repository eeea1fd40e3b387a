#include "ops/log.h"

#include <spdlog/async.h>
#include <spdlog/formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <ctime>

#include "base/text_cut.h"

namespace saccade {
namespace {

std::string quoteAscii(char c) {
  if (c == '"' || c == '\\') return {'\\', c};
  if (c == '\n') return "\\n";
  if (c >= ' ' && c != 0x7F) return {c};
  char escape[8];
  std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
  return escape;
}

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

std::string quoteJson(std::string_view text) {
  std::string quoted = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    if (length == 0) {
      quoted += "\uFFFD";
    } else {
      quoted += length == 1 ? quoteAscii(text[0]) : std::string(text.substr(0, length));
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return quoted + '"';
}

void setUpLog(const std::string& level, const std::string& format) {
  spdlog::init_thread_pool(kLogQueue, 1);
  spdlog::set_default_logger(spdlog::create_async_nb<spdlog::sinks::stdout_color_sink_mt>("saccaded"));
  spdlog::set_pattern("[%Y-%m-%d %H:%M:%S.%e] [%^%l%$] %v");
  spdlog::set_level(spdlog::level::from_str(level));
  if (format == "json") spdlog::set_formatter(std::make_unique<JsonFormatter>());
}

void finishLog() {
  spdlog::shutdown();
}

std::size_t droppedLogLines() {
  const auto pool = spdlog::thread_pool();
  return pool ? pool->overrun_counter() : 0;
}

}  // namespace saccade
