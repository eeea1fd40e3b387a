// Reports the progress of a long command on stderr: one line that is rewritten on a terminal, a line every
// ten seconds in a log.
#pragma once

#include <chrono>
#include <string>

namespace saccade::eval {

class Progress {
 public:
  Progress(std::string what, double total);
  ~Progress();
  void add(double done);
  void clear() const;  // takes the line off a terminal, before others write there

 private:
  void print();

  std::string what_;
  double total_, done_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point start_, printed_;
};

}  // namespace saccade::eval
