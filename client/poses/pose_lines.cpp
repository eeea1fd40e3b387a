#include "client/poses/pose_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "client/formats/common/bounded_line.h"
#include "client/formats/text/text_numbers.h"

namespace saccade::client {
namespace {

constexpr std::size_t kLongestLine = 16 << 20;  // COLMAP writes all points of a picture into one

void splitWords(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.empty()) return;
    words.push_back(line.substr(0, line.find_first_of(" \t")));
    line.remove_prefix(words.back().size());
  }
}

void append(std::string& text, double number) {
  char digits[32];
  text += ',';
  text.append(digits, std::to_chars(digits, std::end(digits), number).ptr);
}

}  // namespace

PoseLines::PoseLines(const std::string& path)
    : path_(path), file_(path, std::ios::binary), buffer_(kLongestLine) {
  if (!file_) throw std::invalid_argument("'" + path + "' cannot be read");
}

bool PoseLines::next(std::vector<std::string_view>& words) {
  ++number_;
  std::string_view line;
  const LineRead read = takeLine(file_, buffer_, line);
  if (read == LineRead::kTooLong) fail("a line of more than 16 MiB");
  if (file_.bad()) fail("cannot be read");
  splitWords(line, words);
  return read == LineRead::kLine;
}

void PoseLines::fail(const std::string& what) const {
  throw std::invalid_argument(path_ + ":" + std::to_string(number_) + ": " + what);
}

double PoseLines::number(std::string_view word) const {
  std::string_view rest = word;
  const auto value = takeNumber<double>(rest, kEnd);
  if (!value || !std::isfinite(*value))
    fail("'" + std::string(word.substr(0, 40)) + "' is not a finite number");
  return *value;
}

std::string poseText(double frame, double rate_hz, const Vector3& position, const Quaternion& rotation) {
  std::string text = std::to_string(std::llround(frame / rate_hz * 1e9));
  for (const double number : position) append(text, number);
  for (const double number : rotation) append(text, number);
  return text + '\n';
}

}  // namespace saccade::client
