#include <filesystem>
#include <stdexcept>

#include "client/formats/common/writer.h"

namespace saccade::client {

// Each in the file of its format.
extern const WriterInfo kEvt3Writer, kEvt2Writer, kAedat4Writer, kDsecWriter, kDsecBloscWriter, kNpzWriter,
    kBagWriter, kMcapWriter, kCsvWriter, kTxtWriter;

namespace {

const WriterInfo* find(const char* WriterInfo::*key, const std::string& value) {
  for (const WriterInfo* writer : writerTable()) {
    if (value == writer->*key) return writer;
  }
  return nullptr;
}

// "is for evt3, evt2"
std::string formatsOf(const std::string& extension) {
  std::string names;
  for (const WriterInfo* writer : writerTable())
    if (extension == writer->extension)
      names += (names.empty() ? "is for " : ", ") + std::string(writer->name);
  return names.empty() ? "has no known extension" : names;
}

std::string namesWith(bool WriterInfo::*ability) {
  std::string names;
  for (const WriterInfo* writer : writerTable())
    if (writer->*ability)
      names += (names.empty() ? "" : ", ") + std::string(writer->extension) + " " + writer->name;
  return names;
}

}  // namespace

const std::vector<const WriterInfo*>& writerTable() {
  static const std::vector<const WriterInfo*> table{
      &kEvt3Writer, &kEvt2Writer, &kAedat4Writer, &kDsecWriter, &kDsecBloscWriter,
      &kNpzWriter,  &kBagWriter,  &kMcapWriter,   &kCsvWriter,  &kTxtWriter};
  return table;
}

std::string writerNames() {
  std::string names;
  for (const WriterInfo* writer : writerTable()) {
    names += (names.empty() ? "" : ", ") + std::string(writer->extension) + " " + writer->name + " (" +
             writer->description + ")";
  }
  return names;
}

std::string writerExtensions() {
  std::string list, last;
  for (const WriterInfo* writer : writerTable()) {
    if (writer->extension == last) continue;
    last = writer->extension;
    list += (list.empty() ? "" : ", ") + last;
  }
  return list;
}

std::string labelWriterNames() {
  return namesWith(&WriterInfo::labels);
}

std::string objectWriterNames() {
  return namesWith(&WriterInfo::objects);
}

const WriterInfo& writerFor(const std::string& path, const std::string& name) {
  const bool pipe = path == kStandardOutput;
  const std::string extension =
      pipe ? kCsvWriter.extension : std::filesystem::path(path).extension().string();
  const WriterInfo* writer =
      name.empty() ? find(&WriterInfo::extension, extension) : find(&WriterInfo::name, name);
  if (!writer && name.empty())
    throw std::invalid_argument("the output '" + path + "' has no known extension; known are " +
                                writerNames());
  if (!writer)
    throw std::invalid_argument("--format: '" + name + "' is not known; known are " + writerNames());
  if (!pipe && extension != writer->extension)
    throw std::invalid_argument("--format: " + name + " makes " + writer->extension + " files, and '" + path +
                                "' " + formatsOf(extension));
  if (pipe && !writer->pipe)
    throw std::invalid_argument("--format: " + name + " cannot be written to standard output");
  return *writer;
}

}  // namespace saccade::client
