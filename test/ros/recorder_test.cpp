#include "recorder.h"

#include <algorithm>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "file_size_limit.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/recording/run.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag.h"
#include "read_bags.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Records the small mixture from `start` to `end`; hands frames to the sink at the rates of the topics.
void recordRun(Recorder& recorder, FrameSink& sink, double start = 0.0, double end = 2.0)
{
  Run run(Simulation(smallMixture(), start), end);
  run.add(sink, FrameRates());
  run.add(recorder, recorder.rates());
  run.takeDue();
  while (!run.finished())
    run.advanceTo(run.nextTime());
  run.takeAll();
}

std::vector<std::string> filesIn(const std::string& directory)
{
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

void expectSameRun(const CollectingSink& read, const CollectingSink& whole)
{
  EXPECT_TRUE(sameBits(read.scenes, whole.scenes));
  EXPECT_TRUE(sameBits(read.particles, whole.particles));
  EXPECT_TRUE(sameBits(read.bins, whole.bins));
  EXPECT_TRUE(sameBits(read.bases, whole.bases));
  ASSERT_EQ(read.statistics.size(), whole.statistics.size());
  for (std::size_t k = 0; k < read.statistics.size(); ++k)
    EXPECT_TRUE(sameButForSpeed(read.statistics[k], whole.statistics[k]));
}

RecordingParameters splitBy(double size, double duration)
{
  RecordingParameters parameters;
  parameters.split_size = size;
  parameters.split_duration = duration;
  return parameters;
}

/// One file, several files by time, several files by size: the same run.
TEST(Recorder, splitsARunIntoFilesThatTogetherAreOne)
{
  const ScratchDirectory scratch;
  CollectingSink shown;
  Recorder one(scratch / "one.bag", "/sieve");
  one.open();
  recordRun(one, shown, 10.0, 12.0);
  one.close();
  const CollectingSink whole = readAll({scratch / "one.bag"});

  for (const RecordingParameters& parameters : {splitBy(0.0, 0.15), splitBy(0.02, 0.0), splitBy(0.02, 0.1)})
  {
    const ScratchDirectory directory;
    Recorder recorder(directory / "run.bag", "/sieve", parameters);
    recorder.open();
    EXPECT_EQ(recorder.path(), directory / "run_0.bag");
    recordRun(recorder, shown, 10.0, 12.0);
    recorder.close();
    std::vector<std::string> paths = filesIn(directory / "");
    ASSERT_GT(paths.size(), 3u);
    EXPECT_EQ(recorder.failure(), "");

    expectSameRun(readAll(paths), whole);
    std::shuffle(paths.begin(), paths.end(), std::mt19937(1));
    expectSameRun(readAll(paths), whole);

    RunAnalysis of_parts, of_whole;
    readBags(paths, of_parts);
    readBags({scratch / "one.bag"}, of_whole);
    EXPECT_EQ(reportJson(of_parts.result()), reportJson(of_whole.result()));
  }
}

TEST(Recorder, isReadWithoutAHoleAndNotMixedWithAnother)
{
  const ScratchDirectory scratch;
  CollectingSink shown;
  Recorder recorder(scratch / "run.bag", "/sieve", splitBy(0.0, 0.5));
  recorder.open();
  recordRun(recorder, shown);
  recorder.openNext();
  recordRun(recorder, shown, 0.0, 0.25);
  recorder.close();
  const auto path = [&](const std::string& name) { return scratch / name; };
  EXPECT_EQ(readingError({path("run_1.bag"), path("run_2.bag"), path("run_3.bag")}), "done");
  // Each file begins with the scene, where the one before ends.
  const CollectingSink part = readAll({path("run_2.bag")});
  EXPECT_EQ(part.scenes.at(0).time, 1.0);
  EXPECT_GT(part.bins.front().time, 1.0);
  EXPECT_EQ(part.bins.back().time, 1.5);
  EXPECT_EQ(part.particles.back().time, 1.5);
  EXPECT_EQ(readingError({path("run_3.bag"), path("run_1.bag")}),
            path("run_3.bag") + ": begins at 1.500000 s, and does not continue " + path("run_1.bag") +
                ", which ends at 1.000000 s");
  EXPECT_NE(readingError({path("run_0.bag"), path("run_0.bag")}).find("does not continue"),
            std::string::npos);
  EXPECT_NE(readingError({path("run_0.bag"), path("run_run2_0.bag")}).find("does not continue"),
            std::string::npos);

  SceneFrame other = shown.scenes.front();
  other.seed = 99;
  other.time = 0.5;
  BagWriter bag(path("other.bag"));
  bag.take(other);
  bag.close();
  EXPECT_EQ(readingError({path("run_0.bag"), path("other.bag")}),
            path("other.bag") + ": is of another run than " + path("run_0.bag"));
}

TEST(Recorder, goesOnWithoutADiskAndSaysSo)
{
  const ScratchDirectory scratch;
  const FileSizeLimit full(60'000);
  RecordingParameters parameters;
  parameters.rates.particles = 60.0;
  Recorder recorder(scratch / "run.bag", "/sieve", parameters);
  recorder.open();
  CollectingSink shown;
  recordRun(recorder, shown, 0.0, 6.0);
  EXPECT_EQ(shown.particles.size(), 361u);
  EXPECT_EQ(recorder.path(), "");
  EXPECT_FALSE(recorder.wants(FrameKind::BINS));
  const std::string begin = scratch / "run.bag: cannot be written: File too large; the bag ends at ";
  EXPECT_EQ(recorder.failure().rfind(begin, 0), 0u) << recorder.failure();

  const CollectingSink read = readAll({scratch / "run.bag"});
  ASSERT_GT(read.particles.size(), 30u);
  ASSERT_LT(read.particles.size(), 360u);
  for (std::size_t k = 0; k < read.particles.size(); ++k)
    EXPECT_TRUE(sameBits(read.particles[k], shown.particles[k]));
  EXPECT_EQ(recorder.failure(), begin + std::to_string(read.bins.back().time) + " s");

  // The next run has enough space again.
  recorder.openNext();
  EXPECT_EQ(recorder.failure(), "");
  recordRun(recorder, shown, 0.0, 0.1);
  recorder.close();
  EXPECT_EQ(recorder.failure(), "");
  EXPECT_EQ(readAll({scratch / "run_run2.bag"}).bins.back().time, 0.1);
  // The loss in the first run is still reported.
  EXPECT_EQ(recorder.firstFailure().rfind(begin, 0), 0u) << recorder.firstFailure();
}

TEST(Recorder, goesOnWhereTheNextFileCannotBeOpened)
{
  const ScratchDirectory scratch;
  std::filesystem::create_directory(scratch / "run_1.bag.active");
  Recorder recorder(scratch / "run.bag", "/sieve", splitBy(0.0, 0.5));
  recorder.open();
  CollectingSink shown;
  recordRun(recorder, shown);
  EXPECT_EQ(recorder.failure(), scratch / "run_1.bag: cannot be written: Is a directory");
  EXPECT_EQ(readAll({scratch / "run_0.bag"}).bins.back().time, 0.5);

  std::filesystem::create_directory(scratch / "run_run2_0.bag.active");
  recorder.openNext();
  EXPECT_EQ(recorder.failure(), scratch / "run_run2_0.bag: cannot be written: Is a directory");
  recorder.openNext();
  EXPECT_EQ(recorder.failure(), "");
  EXPECT_EQ(recorder.path(), scratch / "run_run3_0.bag");
}

TEST(Recorder, saysWhereARelativePathIs)
{
  const ScratchDirectory scratch;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(scratch / "");
  const std::filesystem::path here = std::filesystem::current_path();
  Recorder recorder("run.bag", "/sieve");
  std::filesystem::current_path(before);
  recorder.open();
  EXPECT_EQ(recorder.path(), here / "run.bag");
  CollectingSink shown;
  recordRun(recorder, shown, 0.0, 0.1);
  recorder.close();
  EXPECT_TRUE(std::filesystem::exists(here / "run.bag"));
}
}  // namespace
}  // namespace ratchet_sieve
