// `saccade record --labels` and `--max-artefact-odds`, and what other commands make of such files.
#include <set>

#include "client/command.h"
#include "client/formats/common/reader.h"
#include "client/recording/sidecar.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace test;

class LabelsCommand : public CommandAndServer {
 protected:
  Result record(const std::string& options) const {
    return run("record cornell-box --trajectory right --size 32x24 --duration 0.02 " + options +
               server_.option());
  }
};

TEST_F(LabelsCommand, AFormatThatCannotHoldThemIsRefusedBeforeTheStreamOpens) {
  const std::string nobody = " --control tcp://127.0.0.1:1";
  for (const char* file : {"a.raw", "a.aedat4", "a.bag", "a.mcap", "a.csv", "a.txt"}) {
    const Result result =
        run("record cornell-box --trajectory right --labels -o " + folder_.at(file) + nobody);
    EXPECT_EQ(result.code, 2) << file;
    EXPECT_TRUE(holds(result,
                      "does not hold the labels of events; those that do are .h5 dsec, .h5 "
                      "dsec-blosc, .npz npz"))
        << result.output;
  }
  EXPECT_TRUE(
      holds(run("record cornell-box --trajectory right --labels -o -" + nobody), "format csv does not"));
}

TEST_F(LabelsCommand, LabelsChangeNoEventAndFormatsWithoutThemLeaveThemOut) {
  const std::string csv = folder_.at("a.csv"), out = folder_.at("out.csv");
  ASSERT_EQ(record("-o " + csv).code, 0);
  EXPECT_FALSE(client::recordingOf(csv)->labels());
  for (const char* name : {"a.h5", "a.npz"}) {
    const std::string file = folder_.at(name);
    ASSERT_EQ(record("--labels -o " + file).code, 0);
    EXPECT_TRUE(client::recordingOf(file)->labels());
    const Result verified = run("verify " + file);
    EXPECT_TRUE(holds(verified, "are as recorded")) << verified.output;
    EXPECT_TRUE(holds(verified, "left out: the labels of the events")) << verified.output;
    const Result converted = run("convert --force " + file + " " + out);
    EXPECT_TRUE(holds(converted, "left out: the labels of the events")) << converted.output;
    EXPECT_EQ(textOf(out), textOf(csv));
    EXPECT_FALSE(client::recordingOf(out)->labels());
    EXPECT_FALSE(client::recordingOf(out)->request().sensors(0).labels());
  }
  const std::string replay = "replay " + folder_.at("a.npz") + ".json --force" + server_.option() + " -o ";
  EXPECT_TRUE(holds(run(replay + out), "does not hold the labels"));
  EXPECT_TRUE(holds(run(replay + folder_.at("b.npz")), "the events are those of the recording"));
}

Events eventsOf(const std::string& file) {
  const auto reader = client::readerFor(file).make(file);
  EXPECT_TRUE(reader->labels()) << file;
  Events all;
  for (Events batch; reader->read(batch);) all.insert(all.end(), batch.begin(), batch.end());
  return all;
}

TEST_F(LabelsCommand, ConvertTakesThemOverWhereBothFormatsHoldThem) {
  const std::string npz = folder_.at("a.npz");
  ASSERT_EQ(record("--labels --noise shot_hz=50 -o " + npz).code, 0);
  const Events events = eventsOf(npz);
  const auto noise = [](const Event& event) { return event.source == v1::EVENT_SOURCE_NOISE; };
  EXPECT_TRUE(std::ranges::any_of(events, noise));
  EXPECT_FALSE(std::ranges::all_of(events, noise));
  std::string from = npz;
  for (const bool described : {true, false}) {
    for (const char* extension : {".h5", ".npz"}) {
      const std::string to = folder_.at(std::string(described ? "b" : "c") + extension);
      const Result converted = run("convert --force " + from + " " + to);
      ASSERT_EQ(converted.code, 0) << converted.output;
      EXPECT_FALSE(holds(converted, "left out")) << converted.output;
      EXPECT_EQ(eventsOf(to), events);
      EXPECT_TRUE(client::recordingOf(to)->labels());
      EXPECT_EQ(client::recordingOf(to)->has_request(), described);
      from = to;
    }
    fs::remove(from + ".json");
  }
}

std::set<std::uint32_t> objectsOf(const std::string& file) {
  const auto reader = client::readerFor(file).make(file);
  EXPECT_TRUE(reader->objects()) << file;
  std::set<std::uint32_t> objects;
  for (Events batch; reader->read(batch);)
    for (const Event& event : batch) objects.insert(event.object);
  return objects;
}

TEST_F(LabelsCommand, ObjectsAreInTheFilesThatHoldThem) {
  const std::string npz = folder_.at("a.npz"), h5 = folder_.at("a.h5"), csv = folder_.at("a.csv");
  ASSERT_EQ(record("--object-ids -o " + npz).code, 0);
  EXPECT_TRUE(client::recordingOf(npz)->object_ids());
  EXPECT_GT(client::recordingOf(npz)->id_names().objects_size(), 0);
  const std::set<std::uint32_t> objects = objectsOf(npz);
  EXPECT_GT(objects.size(), 1u);
  ASSERT_EQ(run("convert " + npz + " " + h5).code, 0);
  EXPECT_EQ(objectsOf(h5), objects);
  ASSERT_EQ(run("convert " + h5 + " " + csv).code, 0);
  EXPECT_EQ(textOf(csv).substr(0, 15), "t,x,y,p,object\n");
  EXPECT_TRUE(holds(run("verify " + csv), "are as recorded"));
  EXPECT_TRUE(
      holds(run("convert " + npz + " " + folder_.at("a.raw")), "left out: the objects of the events"));
  const std::string nobody = " --control tcp://127.0.0.1:1";
  EXPECT_TRUE(
      holds(run("record cornell-box --trajectory right --object-ids -o " + folder_.at("b.raw") + nobody),
            "does not hold the objects of events; those that do are .h5 dsec"));
}

TEST_F(LabelsCommand, TheSummaryTellsWhatWasWithheldAndWhy) {
  const std::string file = folder_.at("a.csv");
  const Result plain = record("-o " + file);
  EXPECT_FALSE(holds(plain, "withheld")) << plain.output;
  EXPECT_FALSE(holds(plain, "readout")) << plain.output;
  const Result all = record("--max-artefact-odds 1 --force -o " + file);
  EXPECT_FALSE(holds(all, "withheld")) << all.output;
  const std::uint64_t events = client::recordingOf(file)->events();
  const Result likely = record("--max-artefact-odds 0.1 --force -o " + file);
  const std::uint64_t withheld = events - client::recordingOf(file)->events();
  EXPECT_GT(withheld, 0u);
  EXPECT_TRUE(holds(likely, "\n" + std::to_string(withheld) +
                                " events withheld: their odds to be artefacts are above 0.1\n"))
      << likely.output;
  const Result slow = record("--noise readout_hz=1000 --noise readout_buffer=0 --force -o " + file);
  EXPECT_TRUE(holds(slow, " events lost in the readout\n")) << slow.output;
  EXPECT_FALSE(holds(slow, "events withheld")) << slow.output;
}

}  // namespace
}  // namespace saccade
