#include "farm/worker/make_sequence.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "app/request/refusal.h"
#include "farm/worker/failures.h"
#include "farm/worker/record_words.h"
#include "farm/worker/sequence_folder.h"
#include "scene/files/scene_error.h"

namespace saccade::farm {
namespace {

// A limit may have room again, and a server's words fit a farm too.
bool mayPass(const Refusal& refusal) {
  return refusal.code == v1::CODE_RESOURCE_EXHAUSTED || refusal.code == v1::CODE_UNAVAILABLE;
}

// A disk that is full takes no record either.
Made failed(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& message, bool retry) {
  try {
    recordFailure(set, sequence, message, retry);
  } catch (const std::exception&) {
    std::fprintf(stderr, "saccade-farm: sequence %s: %s\n", set.sequenceName(sequence.number()).c_str(),
                 message.c_str());
  }
  return retry ? Made::kRetry : Made::kNever;
}

}  // namespace

void tryToMake(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& worker,
               SequenceRenderer& renderer) {
  const std::vector<std::string> outputs(set.plan().outputs().begin(), set.plan().outputs().end());
  SequenceFolder folder(set, sequence, worker);
  const std::vector<client::RecordJob> jobs = jobsOf(sequence, outputs, folder.path());
  std::vector<v1::DataSetRecording> recordings;
  for (const auto& [file, recording] : renderer.render(jobs))
    recordings.push_back(summaryOf(recording, std::filesystem::path(file).filename()));
  folder.publish(sequence, recordings);
}

Made makeSequence(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& worker,
                  SequenceRenderer& renderer) {
  try {
    tryToMake(set, sequence, worker, renderer);
    forgetFailure(set, sequence);
    return Made::kDone;
  } catch (const Refusal& refusal) {
    return failed(set, sequence, (refusal.field.empty() ? "" : refusal.field + ": ") + refusal.what(),
                  mayPass(refusal));
  } catch (const SceneError& fault) {
    return failed(set, sequence, fault.what(), false);
  } catch (const std::invalid_argument& fault) {  // of an option, or of a format that cannot hold it
    return failed(set, sequence, fault.what(), false);
  } catch (const std::range_error& fault) {
    return failed(set, sequence, fault.what(), false);
  } catch (const std::exception& fault) {
    return failed(set, sequence, fault.what(), true);
  }
}

}  // namespace saccade::farm
