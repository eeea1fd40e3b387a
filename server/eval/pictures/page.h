// Writes a web page of text, charts and pictures.
#pragma once

#include <string>

namespace saccade::eval {

class Page {
 public:
  explicit Page(const std::string& title);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void svg(const std::string& svg);           // drawn into the page
  void picture(const std::string& file);      // shown from a file in the folder of the page
  void write(const std::string& path) const;  // throws std::runtime_error

 private:
  std::string html_;
};

}  // namespace saccade::eval
