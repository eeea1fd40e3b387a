#include "client/terminal/console.h"

#include <cstdarg>

namespace saccade::client {
namespace {

// Bytes of the control character that `text` begins with, which are its number too; 0: it is another
// character. U+0080 to U+009F are two bytes of UTF-8.
std::size_t controlBytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  if (byte(0) < ' ' || byte(0) == 0x7F) return 1;
  return byte(0) == 0xC2 && byte(1) >= 0x80 && byte(1) < 0xA0 ? 2 : 0;
}

std::string escapeOf(std::string_view control) {
  if (control == "\n") return "\\n";
  char text[8];
  std::snprintf(text, sizeof text, "\\u%04x", static_cast<unsigned char>(control.back()));
  return text;
}

std::string escape(std::string_view text, std::string_view spared) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t control = controlBytes(text);
    const std::string_view character = text.substr(0, control == 0 ? 1 : control);
    escaped += control == 0 || character == spared ? std::string(character) : escapeOf(character);
    text.remove_prefix(character.size());
  }
  return escaped;
}

void printAll(std::FILE* out, const char* format, std::va_list args) {
  std::va_list again;
  va_copy(again, args);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, again)), '\0');
  va_end(again);
  std::vsnprintf(text.data(), text.size() + 1, format, args);
  std::fputs(escape(text, "\n").c_str(), out);
}

}  // namespace

std::string printable(std::string_view text) {
  return escape(text, "");
}

void print(std::FILE* out, const char* format, ...) {
  std::va_list args;
  va_start(args, format);
  printAll(out, format, args);
  va_end(args);
}

void print(const char* format, ...) {
  std::va_list args;
  va_start(args, format);
  printAll(stdout, format, args);
  va_end(args);
}

}  // namespace saccade::client
