#include "eval/page.h"

#include <cstdint>
#include <fstream>
#include <stdexcept>

#include "eval/markup.h"

namespace saccade {
namespace {

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

}  // namespace

Page::Page(const std::string& title) {
  html_ = "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escapeMarkup(title) +
          "</title><style>body{font:14px sans-serif;margin:24px;max-width:1800px}td,th{padding:2px "
          "6px;text-align:center;"
          "font-size:12px}img{image-rendering:pixelated;display:block;margin:auto}</style></head><body><h1>" +
          escapeMarkup(title) + "</h1>\n";
}

void Page::heading(const std::string& text) {
  html_ += "<h2>" + escapeMarkup(text) + "</h2>\n";
}
void Page::paragraph(const std::string& text) {
  html_ += "<p>" + escapeMarkup(text) + "</p>\n";
}
void Page::svg(const std::string& svg) {
  html_ += svg;
}

void Page::pictures(const std::vector<std::string>& columns, const std::vector<std::string>& rows,
                    const std::vector<std::vector<Cell>>& cells) {
  html_ += "<table><tr><th></th>";
  for (const std::string& column : columns) html_ += "<th>" + escapeMarkup(column) + "</th>";
  html_ += "</tr>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    html_ += "<tr><th>" + escapeMarkup(rows[r]) + "</th>";
    for (const Cell& cell : cells[r]) {
      html_ += "<td>";
      if (!cell.pixels.empty()) {
        html_ += "<img width=\"" + std::to_string(cell.width * cell.zoom) + "\" height=\"" +
                 std::to_string(cell.height * cell.zoom) + "\" src=\"data:image/png;base64," +
                 base64(encodePng(cell.width, cell.height, cell.pixels)) + "\">";
      }
      html_ += escapeMarkup(cell.caption) + "</td>";
    }
    html_ += "</tr>\n";
  }
  html_ += "</table>\n";
}

void Page::write(const std::string& path) const {
  std::ofstream file(path, std::ios::binary);
  file << html_ << "</body></html>\n";
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace saccade
