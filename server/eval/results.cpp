#include "eval/results.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace saccade {
namespace {

constexpr const char* kHeader =
    "scene,method,spp,cpu_ms,trace_ms,reference_error,dI_l1,dI_mape,dL_l1,dL_mape,false_events,missed_events,"
    "false_pixels,missed_pixels";

// The numbers of a row, in the order of the header.
template <class R>
auto numbers(R& r) {
  return std::array{&r.cpu_ms,
                    &r.trace_ms,
                    &r.reference_error,
                    &r.errors.dI_l1,
                    &r.errors.dI_mape,
                    &r.errors.dL_l1,
                    &r.errors.dL_mape,
                    &r.errors.rates.false_events,
                    &r.errors.rates.missed_events,
                    &r.errors.rates.false_pixels,
                    &r.errors.rates.missed_pixels};
}

}  // namespace

ResultTable::ResultTable(std::string path, std::string settings)
    : path_(std::move(path)), settings_("# " + std::move(settings)) {
  std::filesystem::create_directories(std::filesystem::path(path_).parent_path());
  if (std::filesystem::exists(path_)) {
    read();
    return;
  }
  std::ofstream(path_) << settings_ << '\n' << kHeader << '\n';
}

void ResultTable::read() {
  std::ifstream file(path_);
  std::string line;
  if (!std::getline(file, line) || line != settings_) {
    throw std::runtime_error(path_ + " was made with other settings (" + line +
                             "); choose another folder or remove it");
  }
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    Result r;
    std::string number;
    std::getline(fields, r.scene, ',');
    std::getline(fields, r.method, ',');
    std::getline(fields, number, ',');
    r.spp = std::atoi(number.c_str());
    for (double* value : numbers(r)) {
      std::getline(fields, number, ',');
      char* end = nullptr;
      *value = std::strtod(number.c_str(), &end);  // reads inf and nan, as a stream does not
      if (end == number.c_str()) fields.setstate(std::ios::failbit);
    }
    if (!fields) throw std::runtime_error(path_ + ": cannot read the row \"" + line + "\"; remove it");
    rows_.push_back(r);
  }
}

bool ResultTable::has(const std::string& scene, const std::string& method, int spp) const {
  for (const Result& r : rows_) {
    if (r.scene == scene && r.method == method && r.spp == spp) return true;
  }
  return false;
}

void ResultTable::add(const Result& r) {
  std::ostringstream line;
  line << r.scene << ',' << r.method << ',' << r.spp;
  for (const double* value : numbers(r)) line << ',' << *value;
  std::ofstream file(path_, std::ios::app);
  file << line.str() << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path_);
  rows_.push_back(r);
}

}  // namespace saccade
