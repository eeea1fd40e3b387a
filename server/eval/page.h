// A self-contained web page: text, tables, charts and pictures in one file that opens without a network.
#pragma once

#include <string>
#include <vector>

#include "eval/exr.h"

namespace saccade {

class Page {
 public:
  explicit Page(const std::string& title);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void svg(const std::string& svg);
  // Pictures in rows, each with a line of text below it; `columns` stand above.
  struct Cell {
    std::string caption;
    int width = 0, height = 0;
    std::vector<Rgb8> pixels;  // empty: only the caption
    int zoom = 1;
  };
  void pictures(const std::vector<std::string>& columns, const std::vector<std::string>& rows,
                const std::vector<std::vector<Cell>>& cells);

  void write(const std::string& path) const;  // throws std::runtime_error

 private:
  std::string html_;
};

}  // namespace saccade
