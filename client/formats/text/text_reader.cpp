// Text files, one line per event: .csv and .txt, as we write them and as others do. See text_head.h and
// text_form.h for what they may look like.
#include "client/formats/text/text_fields.h"
#include "client/formats/text/text_form.h"
#include "client/formats/text/text_lines.h"

namespace saccade::client {
namespace {

constexpr std::size_t kBatch = 1 << 16;        // events
constexpr std::size_t kSampleLines = 1 << 10;  // that tell the form

class TextReader : public Reader {
 public:
  TextReader(const std::string& path, const ColumnOptions& options)
      : path_(path),
        lines_(path),
        head_(parseHead(path, lines_.ahead(kSampleLines))),
        form_(findForm(path, head_, lines_.ahead(kSampleLines), options)),
        parser_(form_.row) {
    if (lines_.ahead(1).empty()) throw FileFault(path, "is empty: it has neither a heading nor events");
    std::string_view line;
    for (std::size_t i = 0; i < head_.lines; ++i) lines_.next(line);
  }

  ImageSize size() const override { return head_.size; }
  std::string leftOut() const override { return form_.left_out; }
  std::string assumed() const override { return form_.assumed; }

  bool read(Events& events) override {
    events.clear();
    Event event;
    for (std::string_view line; events.size() < kBatch && lines_.next(line);) {
      if (parser_.parse(line, event))
        events.push_back(event);
      else if (!isComment(line))
        fail();
    }
    return !events.empty();
  }

 private:
  [[noreturn]] void fail() const {
    throw FileFault(path_,
                    "line " + std::to_string(lines_.number()) + " is not of the form '" + form_.text +
                        "': " + (form_.row.decimals ? "" : "t is a whole number, unless --unit is given, ") +
                        "x and y are 0 to 65535, " + kPolarities);
  }

  const std::string path_;
  TextLines lines_;
  const TextHead head_;
  const TextForm form_;
  RowParser parser_;
};

std::unique_ptr<Reader> makeBy(const std::string& path, const ColumnOptions& options) {
  return std::make_unique<TextReader>(path, options);
}

std::unique_ptr<Reader> make(const std::string& path) {
  return makeBy(path, {});
}

}  // namespace

extern const ReaderInfo kCsvReader{".csv", "t,x,y,p in any order under a heading", make, makeBy};
extern const ReaderInfo kTxtReader{".txt", "t x y p, under a line \"width height\" or none", make, makeBy};

}  // namespace saccade::client
