// From the options of a sequence to what is to be recorded, as `saccade record` reads them.
#pragma once

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/options/record_job.h"
#include "saccade/v1/dataset.pb.h"

namespace saccade::farm {

// A fault of one option. `option`: its name without dashes; empty where the message is of none.
struct OptionFault : std::invalid_argument {
  OptionFault(std::string option, const std::string& message)
      : std::invalid_argument(message), option(std::move(option)) {}
  std::string option;
};

// The jobs of a sequence, one for each file of events in `folder`. They have the same request. Names of files
// in the options are relative to the present folder. Throws OptionFault.
std::vector<client::RecordJob> jobsOf(const v1::DataSetSequence& sequence,
                                      const std::vector<std::string>& outputs, const std::string& folder);

// VALUE of a word --NAME=VALUE, or PATH of --object=NAME=PATH.
std::string valueOf(const std::string& word);

// The first name of the option: "trajectory" of "motion". Throws OptionFault, with similar names, where a
// recipe may not have it.
std::string optionNamed(const std::string& name);

}  // namespace saccade::farm
