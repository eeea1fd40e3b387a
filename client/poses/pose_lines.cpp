#include "client/poses/pose_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "client/formats/common/bounded_line.h"
#include "client/formats/text/text_reader.h"

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

// [Shepperd, "Quaternion from Rotation Matrix", 1978]: the largest part first, for the least rounding.
Quaternion quaternionOf(const Matrix3& r) {
  const double trace = r[0][0] + r[1][1] + r[2][2];
  if (trace > 0) {
    const double w = std::sqrt(1 + trace) / 2;
    return {(r[2][1] - r[1][2]) / (4 * w), (r[0][2] - r[2][0]) / (4 * w), (r[1][0] - r[0][1]) / (4 * w), w};
  }
  std::size_t i = r[1][1] > r[0][0] ? 1 : 0;
  if (r[2][2] > r[i][i]) i = 2;
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  const double part = std::sqrt(1 + r[i][i] - r[j][j] - r[k][k]) / 2;
  Quaternion q{};
  q[i] = part;
  q[j] = (r[i][j] + r[j][i]) / (4 * part);
  q[k] = (r[i][k] + r[k][i]) / (4 * part);
  q[3] = (r[k][j] - r[j][k]) / (4 * part);
  return q;
}

Matrix3 matrixOf(const Quaternion& unit) {
  const auto [x, y, z, w] = unit;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
           {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
           {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

std::string poseText(double frame, double rate_hz, const Vector3& position, const Quaternion& rotation) {
  std::string text = std::to_string(std::llround(frame / rate_hz * 1e9));
  for (const double number : position) append(text, number);
  for (const double number : rotation) append(text, number);
  return text + '\n';
}

}  // namespace saccade::client
