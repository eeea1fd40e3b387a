// Files of messages in the JSON form of protobuf, a message on a line.
#pragma once

#include <google/protobuf/message.h>

#include <string>
#include <vector>

namespace saccade::farm {

// With the end of the line. Fields have the names of the schema, and those without a value are there too.
std::string jsonLine(const google::protobuf::Message& message);
// Throws std::runtime_error, which begins with `name`.
void parseJson(const std::string& text, const std::string& name, google::protobuf::Message& message);

std::string readText(const std::string& file);  // throws std::system_error
// Readers find the old file or the whole new one. Throws std::system_error.
void writeText(const std::string& file, const std::string& text);
void writeJson(const std::string& file, const google::protobuf::Message& message);  // likewise
// Removes what killed programs have left of such files in a folder.
void removeLeftTexts(const std::string& folder);

template <class Message>
Message readJson(const std::string& file) {
  Message message;
  parseJson(readText(file), file, message);
  return message;
}

// The messages of a file, one of each line.
template <class Message>
std::vector<Message> readJsonLines(const std::string& file) {
  const std::string text = readText(file);
  std::vector<Message> messages;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    parseJson(text.substr(at, end - at), file, messages.emplace_back());
    at = end + 1;
  }
  return messages;
}

}  // namespace saccade::farm
