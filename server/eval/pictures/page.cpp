#include "eval/pictures/page.h"

#include "eval/pictures/text.h"

namespace saccade::eval {

Page::Page(const std::string& title) {
  html_ = "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escapeMarkup(title) +
          "</title><style>body{font:14px sans-serif;margin:24px;}svg{display:block;margin:8px "
          "0}</style></head><body><h1>" +
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
void Page::picture(const std::string& file) {
  html_ += "<h2>" + escapeMarkup(file) + "</h2>\n<img src=\"" + escapeMarkup(file) + "\" alt=\"\">\n";
}

void Page::write(const std::string& path) const {
  writeText(path, html_ + "</body></html>\n");
}

}  // namespace saccade::eval
