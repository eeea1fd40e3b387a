// A self-contained web page: text, tables, charts and pictures in one file that opens without a network.
#pragma once

#include <string>

namespace saccade::eval {

class Page {
 public:
  explicit Page(const std::string& title);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void svg(const std::string& svg);           // a chart, or pictures
  void write(const std::string& path) const;  // throws std::runtime_error

 private:
  std::string html_;
};

}  // namespace saccade::eval
