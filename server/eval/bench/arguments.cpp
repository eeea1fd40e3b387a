#include "eval/bench/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>

#include "base/names.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

// The whole of `text` as a number from 1 to `max`.
std::optional<int> number(std::string_view text, int max) {
  int value = 0;  // as it stays if there is no number, or too large a one
  const char* end = text.data() + text.size();
  const bool whole = std::from_chars(text.data(), end, value).ptr == end;
  return whole && value >= 1 && value <= max ? std::optional(value) : std::nullopt;
}

// The numbers before and after `separator`.
std::optional<std::pair<int, int>> numbers(std::string_view text, char separator, int max) {
  const std::size_t at = text.find(separator);
  if (at == text.npos) return std::nullopt;
  const auto first = number(text.substr(0, at), max), second = number(text.substr(at + 1), max);
  return first && second ? std::optional(std::pair(*first, *second)) : std::nullopt;
}

}  // namespace

Size parseSize(const std::string& text) {
  const auto size = numbers(text, 'x', 16384);
  if (size) return {size->first, size->second};
  throw CLI::ValidationError("--size", "must be WxH, each from 1 to 16384, not " + text);
}

FrameRange parseFrameRange(const std::string& text) {
  const bool one = text.find(':') == text.npos;
  const auto range = numbers(one ? text + ':' + text : text, ':', 1'000'000);
  if (range && range->first <= range->second) return {range->first, range->second};
  throw CLI::ValidationError("--frames",
                             "must be A:B with 1 <= A <= B <= 1000000 (the change of frame 1 is since frame "
                             "0), or one frame, not " +
                                 text);
}

double parseTolerance(const std::string& text) {
  double percent = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, percent);
  const bool whole = error == std::errc() && std::string_view(rest, end) == "%";
  if (whole && percent > 0 && percent <= 100) return percent / 100;
  throw CLI::ValidationError("--tolerance",
                             "must be a share of the events, over 0% and up to 100%, not " + text);
}

namespace {

MethodSpec methodOf(const std::string& flag, const std::string& text) {
  try {
    return parseMethod(text);
  } catch (const std::exception& fault) {
    throw CLI::ValidationError(flag, fault.what());
  }
}

}  // namespace

Setting parseSetting(const std::string& flag, const std::string& text) {
  const std::size_t at = text.rfind('@');
  const auto spp =
      at == text.npos ? std::nullopt : number(std::string_view(text).substr(at + 1), ranges::kSpp.max);
  if (!spp) {
    throw CLI::ValidationError(flag, "must be METHOD@SPP with 1 to " + std::to_string(ranges::kSpp.max) +
                                         " paths per pixel and frame, such as svgf@2, not " + text);
  }
  const Setting setting{methodOf(flag, text.substr(0, at)), *spp};
  if (setting.method.takes(*spp)) return setting;
  throw CLI::ValidationError(flag, text + ": the paths must be even, half of them for each pass");
}

void checkSpp(const MethodSpec& method, int spp) {
  if (method.takes(spp)) return;
  throw CLI::ValidationError("--spp", "must be even for " + method.text +
                                          ", half of the paths for each pass, not " + std::to_string(spp));
}

void checkSpp(const std::vector<std::string>& methods, const std::vector<int>& spp) {
  for (const std::string& text : methods) {
    const MethodSpec method = parseMethod(text);
    for (const int n : spp) checkSpp(method, n);
  }
}

void checkOutputFile(const std::string& path, const std::vector<std::string>& extensions) {
  const std::filesystem::path file(path), folder = file.parent_path();
  if (std::find(extensions.begin(), extensions.end(), file.extension()) == extensions.end())
    throw CLI::ValidationError("--output",
                               "'" + path + "' names no known format; known are " + joinNames(extensions));
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw CLI::ValidationError("--output", "there is no folder " + folder.string());
}

}  // namespace saccade::eval
