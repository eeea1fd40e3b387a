#include "eval/pictures/picture_grid.h"

#include <algorithm>
#include <cstdint>

#include "eval/pictures/format.h"
#include "eval/pictures/markup.h"

namespace saccade::eval {
namespace {

constexpr int kPictureWidth = 192, kGap = 8, kRowLabel = 120, kHeadLine = 14, kCaption = 18;

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string text(int x, int y, const std::string& what) {
  return "<text x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" text-anchor=\"middle\">" +
         escapeMarkup(what) + "</text>\n";
}

std::string drawPicture(const GridPicture& cell, int x, int y, int height) {
  return "<image x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" width=\"" +
         std::to_string(kPictureWidth) + "\" height=\"" + std::to_string(height) +
         "\" style=\"image-rendering:pixelated\" xlink:href=\"data:image/png;base64," +
         base64(encodePng(cell.width, cell.height, cell.pixels)) + "\"/>\n" +
         text(x + kPictureWidth / 2, y + height + kCaption - 4, cell.caption);
}

// A column's name breaks at its commas and colons: methods carry their settings behind them.
std::vector<std::string> headLines(const std::string& name) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t end = std::min(name.find_first_of(",:", at), name.size());
    lines.push_back(name.substr(at, end - at));
    at = name.find_first_not_of(' ', end + 1);
  }
  return lines;
}

}  // namespace

std::string drawPictureGrid(const std::vector<std::string>& columns, const std::vector<std::string>& rows,
                            const std::vector<std::vector<GridPicture>>& cells) {
  const int width = kRowLabel + static_cast<int>(columns.size()) * (kPictureWidth + kGap);
  std::string body;
  int center = kRowLabel + kPictureWidth / 2, head_end = 0;
  for (const std::string& column : columns) {
    int y = 0;
    for (const std::string& line : headLines(column)) body += text(center, y += kHeadLine, line);
    center += kPictureWidth + kGap;
    head_end = std::max(head_end, y);
  }
  int y = head_end + kGap;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const GridPicture& first = cells[r].front();
    const int height = kPictureWidth * first.height / first.width;
    body += text(kRowLabel / 2, y + height / 2, rows[r]);
    int x = kRowLabel;
    for (const GridPicture& cell : cells[r]) {
      body += drawPicture(cell, x, y, height);
      x += kPictureWidth + kGap;
    }
    y += height + kCaption + kGap;
  }
  const std::string head = format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"%d\" height=\"%d\" font-family=\"sans-serif\" font-size=\"11\">\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
      width, y);
  return head + body + "</svg>\n";
}

}  // namespace saccade::eval
