// Goes through a shard's index.jsonl, beside its table.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "farm/dataset/line_file.h"

namespace saccade::farm {

class IndexWalk {
 public:
  explicit IndexWalk(const std::filesystem::path& file);  // which need not be there

  // The line of this sequence, with its end, if it is the next one. Numbers come in order.
  std::optional<std::string> take(std::uint64_t number);
  void setWrong() { sound_ = false; }  // it lacks a line, or has one too many
  // After all sequences: false where the file is there and wrong.
  bool sound() const { return !there_ || (sound_ && !has_line_); }

 private:
  void advance();

  std::optional<LineFile> file_;
  std::string line_;
  bool there_ = false, has_line_ = false, sound_ = true;
};

}  // namespace saccade::farm
