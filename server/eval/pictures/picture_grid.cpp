#include "eval/pictures/picture_grid.h"

#include <algorithm>
#include <cstdint>

#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

constexpr int kPictureWidth = 192, kGap = 8, kRowLabel = 130, kHeadLine = 14, kCaption = 18, kKey = 24;
constexpr std::size_t kAcross = 6;  // columns side by side

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

// The lines of a name. Methods carry their settings behind colons.
std::vector<std::string> linesOf(const std::string& name) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t end = std::min(name.find_first_of(",:", at), name.size());
    lines.push_back(name.substr(at, end - at));
    at = name.find_first_not_of(' ', end + 1);
  }
  return lines;
}

// Draws a name around `x`, from `y` on; returns where it ends.
int drawName(const std::string& name, int x, int y, std::string& svg) {
  for (const std::string& line : linesOf(name)) svg += text(x, y += kHeadLine, line);
  return y;
}

// Draws all rows of the columns from `first` to `end`, from `y` on; returns where they end.
int drawBand(const std::vector<std::string>& columns, const std::vector<std::string>& rows,
             const std::vector<std::vector<GridPicture>>& cells, std::size_t first, std::size_t end, int y,
             std::string& svg) {
  const auto left = [&](std::size_t c) {
    return kRowLabel + static_cast<int>(c - first) * (kPictureWidth + kGap);
  };
  int head_end = y;
  for (std::size_t c = first; c < end; ++c)
    head_end = std::max(head_end, drawName(columns[c], left(c) + kPictureWidth / 2, y, svg));
  y = head_end + kGap;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const int height = kPictureWidth * cells[r][first].height / cells[r][first].width;
    drawName(rows[r], kRowLabel / 2, y + height / 2 - kHeadLine, svg);
    for (std::size_t c = first; c < end; ++c) svg += drawPicture(cells[r][c], left(c), y, height);
    y += height + kCaption + kGap;
  }
  return y;
}

// Three squares with their meaning.
std::string drawKey(const ColorKey& key, int y) {
  const std::pair<const char*, const std::string&> entries[] = {
      {"#0000ff", key.blue}, {"#ffffff", key.white}, {"#ff0000", key.red}};
  std::string svg;
  int x = kRowLabel;
  for (const auto& [color, meaning] : entries) {
    svg += format("<rect x=\"%d\" y=\"%d\" width=\"12\" height=\"12\" fill=\"%s\" stroke=\"#888\"/>", x, y,
                  color) +
           format("<text x=\"%d\" y=\"%d\">", x + 18, y + 10) + escapeMarkup(meaning) + "</text>\n";
    x += kPictureWidth;
  }
  return svg;
}

}  // namespace

std::string drawPictureGrid(const std::vector<std::string>& columns, const std::vector<std::string>& rows,
                            const std::vector<std::vector<GridPicture>>& cells, const ColorKey& key) {
  const std::size_t across = std::max<std::size_t>(3, std::min(kAcross, columns.size()));  // the key takes 3
  const int width = kRowLabel + static_cast<int>(across) * (kPictureWidth + kGap);
  std::string body;
  int y = 0;
  for (std::size_t first = 0; first < columns.size(); first += kAcross)
    y = drawBand(columns, rows, cells, first, std::min(first + kAcross, columns.size()), y, body);
  body += drawKey(key, y);
  const std::string head = format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"%d\" height=\"%d\" font-family=\"sans-serif\" font-size=\"11\">\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
      width, y + kKey);
  return head + body + "</svg>\n";
}

}  // namespace saccade::eval
