// Sweeps by an engine: which results are accepted, into which row, and how the others are handled.
#include "ratchet_sieve/sweep/engine_run.h"

#include <functional>
#include <sstream>
#include <utility>

#include <unistd.h>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/sweep/case_claims.h"
#include "ratchet_sieve/sweep/case_file.h"
#include "ratchet_sieve/sweep/engine.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Runs the cases at once, in this process.
class EngineHere : public SweepEngine
{
public:
  std::function<void(const std::string& directory)> afterwards;  ///< called once, may be empty
  int starts = 0;

  void start(const std::string& directory, const std::vector<std::string>& files) override
  {
    ++starts;
    for (const std::string& file : files)
      runCaseFile(directory + '/' + file, {});
    if (afterwards)
      std::exchange(afterwards, {})(directory);
  }
  bool isRunning() override { return false; }
  void stop() override {}
};

class EngineRunTest : public testing::Test
{
protected:
  Sweep load(const std::string& text) const
  {
    return loadSweep(
        written(directory_, "s.yaml", SMALL_SCENE + std::string("set: {duration: 0.02}\n") + text));
  }

  SweepOutcome run(const Sweep& sweep)
  {
    SweepRunOptions options;
    options.per_job = 2;
    options.warn = [this](const std::string& text) { warnings_ += text + '\n'; };
    return runSweepOn(engine_, sweep, results_, options);
  }

  /// A coordinator that ends before it has stored its jobs' results.
  void runAndLeaveResults(const Sweep& sweep)
  {
    engine_.afterwards = [](const std::string&) { throw EngineError("killed"); };
    EXPECT_THROW(run(sweep), EngineError);
    EXPECT_EQ(tableOf(results_).size(), 0u);
    engine_.starts = 0;
  }

  /// Checks that the table is the same as after a run on threads.
  void expectSameTable(const Sweep& sweep)
  {
    const std::string by_threads = directory_ / "threads.db";
    runSweep(sweep, by_threads, {});
    EXPECT_EQ(tableOf(results_), tableOf(by_threads));
    fs::remove(by_threads);
  }

  /// Files that were set aside.
  std::size_t countBad() const
  {
    std::size_t files = 0;
    if (fs::exists(results_ + ".d"))
      for (const auto& entry : fs::directory_iterator(results_ + ".d"))
        files += entry.path().extension() == ".bad" ? 1 : 0;
    return files;
  }

  ScratchDirectory directory_;
  std::string results_ = directory_ / "r.db";
  EngineHere engine_;
  std::string warnings_;
};

TEST_F(EngineRunTest, MakesTheTableThatThreadsMake)
{
  const Sweep sweep = load("grid: {base.inclination: [0, 0.1, 0.2]}\n");
  EXPECT_EQ(run(sweep).counts.done, 3u);
  expectSameTable(sweep);
  EXPECT_EQ(warnings_, "");
  EXPECT_FALSE(fs::exists(results_ + ".d"));
}

TEST_F(EngineRunTest, TakesResultsThatWereLeftAsThePresentSweepHasThem)
{
  runAndLeaveResults(load("grid: {base.inclination: [0, 0.1]}\nseed: {first: 1, count: 2}\n"));
  const Sweep grown =
      load("grid: {base.frequency: [23, 20], base.inclination: [0, 0.1]}\nseed: {first: 1, count: 2}\n");
  EXPECT_EQ(run(grown).counts.done, 8u);
  expectSameTable(grown);
  EXPECT_EQ(textOf(results_, "SELECT COUNT(*) FROM cases WHERE \"base.frequency\" = 23"), "4");
  EXPECT_FALSE(fs::exists(results_ + ".d"));
}

TEST_F(EngineRunTest, LeavesResultsOfAnotherSweepForThatOne)
{
  const Sweep first = load("grid: {base.inclination: [0, 0.1]}\n");
  runAndLeaveResults(first);
  const Sweep other = load("grid: {base.inclination: [0, 0.1], base.frequency: [20, 21]}\n");
  EXPECT_EQ(run(other).counts.done, 4u);
  expectSameTable(other);
  EXPECT_NE(warnings_.find(".cases: has results of other sweeps, which are kept\n"), std::string::npos)
      << warnings_;
  engine_.starts = 0;
  EXPECT_EQ(run(first).counts.done, 2u);
  EXPECT_EQ(engine_.starts, 0);
  EXPECT_FALSE(fs::exists(results_ + ".d"));
}

TEST_F(EngineRunTest, LeavesResultsToThreadsAsWell)
{
  const Sweep sweep = load("grid: {base.inclination: [0, 0.1]}\n");
  runAndLeaveResults(sweep);
  SweepRunOptions options;
  options.progress = [](const SweepProgress& progress) { EXPECT_EQ(progress.finished_here, 0u); };
  EXPECT_EQ(runSweep(sweep, results_, options).counts.done, 2u);
  EXPECT_FALSE(fs::exists(results_ + ".d"));
}

TEST_F(EngineRunTest, SetsAFileAsideThatIsNotWhatItShouldBe)
{
  const Sweep sweep = load("grid: {base.inclination: [0, 0.1, 0.2]}\n");
  const auto expect_aside =
      [&](const std::string& reason, const std::function<void(const std::string&)>& forge)
  {
    SCOPED_TRACE(reason);
    engine_.starts = 0;
    engine_.afterwards = [&forge](const std::string& folder) { forge(folder + "/0000.results"); };
    EXPECT_EQ(run(sweep).counts.done, 3u);
    EXPECT_EQ(engine_.starts, 2);
    EXPECT_NE(warnings_.find(reason), std::string::npos) << warnings_;
    EXPECT_NE(warnings_.find("; it is renamed to " + results_ + ".d/owner-"), std::string::npos) << warnings_;
    EXPECT_EQ(countBad(), 1u);
    expectSameTable(sweep);
    warnings_.clear();
    for (const char* suffix : {"", ".d", "-wal", "-shm"})
      fs::remove_all(results_ + suffix);
  };
  const auto lines_by = [&](const std::function<void(std::vector<Json>&)>& change)
  {
    return [change](const std::string& path)
    {
      std::istringstream text(contents(path));
      std::vector<Json> lines;
      for (std::string line; std::getline(text, line);)
        lines.push_back(Json::parse(line));
      change(lines);
      std::ofstream file(path);
      for (const Json& line : lines)
        file << line.dump() << '\n';
    };
  };
  const auto summary_by = [&](const std::function<void(Json&)>& change)
  { return lines_by([change](std::vector<Json>& lines) { change(lines[1]["summary"]); }); };
  expect_aside("has a result of an unknown case",
               lines_by([](auto& lines) { lines[1]["run_hash"] = "0123456789abcdef"; }));
  expect_aside("has a result that does not belong to its case",
               lines_by([](auto& lines) { std::swap(lines[1]["summary"], lines[2]["summary"]); }));
  expect_aside("is damaged: ", lines_by([](auto& lines) { lines[1]["wall_time"] = "long"; }));
  expect_aside("is damaged: ", lines_by([](auto& lines) { lines[1] = Json::array({1}); }));
  expect_aside("is damaged: a successful case has no summary",
               summary_by([](auto& summary) { summary = nullptr; }));
  expect_aside("is damaged: a successful case has no summary",
               summary_by([](auto& summary) { summary = 3; }));
  expect_aside("is damaged: ", summary_by([](auto& summary) { summary["species"] = {1, 2}; }));
  expect_aside("is damaged: ", summary_by([](auto& summary) { summary["species"][0]["name"] = 3; }));
  expect_aside("has a map with too many keys", summary_by(
                                                   [](auto& summary)
                                                   {
                                                     for (int k = 0; k < 5000; ++k)
                                                       summary["key" + std::to_string(k)] = k;
                                                   }));
  expect_aside("has an invalid key: a b",
               summary_by([](auto& summary) { summary[std::string("a\0b", 3)] = 1; }));
  expect_aside("is nested too deeply",
               [](const std::string& path)
               {
                 std::string text = contents(path);
                 const std::string key = "\"summary\":{";
                 std::string nested = "\"a\":";
                 for (int k = 0; k < 300'000; ++k)
                   nested += "{\"a\":";
                 nested += '1' + std::string(300'000, '}') + ',';
                 std::ofstream(path) << text.insert(text.find(key) + key.size(), nested);
               });
  expect_aside("cannot be read",
               [](const std::string& path)
               {
                 fs::rename(path, path + ".there");
                 fs::create_symlink(path + ".there", path);
               });
  expect_aside("is larger than 268435456 bytes",
               [](const std::string& path) { fs::resize_file(path, 1u << 29); });
}

TEST_F(EngineRunTest, CannotGoOnWithoutResults)
{
  const Sweep sweep = load("");
  engine_.afterwards = [](const std::string& folder) { fs::remove(folder + "/0000.results"); };
  try
  {
    run(sweep);
    FAIL();
  }
  catch (const EngineError& error)
  {
    EXPECT_NE(std::string(error.what()).find("no result came back; "), std::string::npos) << error.what();
  }
}

TEST_F(EngineRunTest, IsAnErrorWhereTheResultsFileIsRemovedMeanwhile)
{
  const Sweep sweep = load("grid: {base.inclination: [0, 0.1]}\n");
  engine_.afterwards = [this](const std::string&) { fs::remove(results_); };
  EXPECT_THROW(run(sweep), DatabaseError);
  EXPECT_EQ(run(sweep).counts.done, 2u);
  expectSameTable(sweep);
}

TEST_F(EngineRunTest, WaitsForCasesThatAnotherProcessHas)
{
  const Sweep sweep = load("grid: {base.inclination: [0, 0.1]}\n");
  SweepRunOptions options;
  options.stop_wanted = [] { return true; };
  runSweepOn(engine_, sweep, results_, options);
  ResultStore store(results_, Database::Access::WRITE);
  const SweepPlan plan = *SweepPlan::find(store.database(), sweep);
  fs::create_directory(results_ + ".d");
  std::optional<CaseClaims> others(std::in_place, store.database(), plan, results_ + ".d");
  Transaction transaction(store.database());
  EXPECT_EQ(others->take(1).size(), 1u);
  transaction.commit();
  // After it has reported that it waits, the other process is gone.
  options.stop_wanted = {};
  options.warn = [&](const std::string& text)
  {
    warnings_ += text + '\n';
    others.reset();
  };
  EXPECT_EQ(runSweepOn(engine_, sweep, results_, options).counts.done, 2u);
  EXPECT_EQ(warnings_,
            "process " + std::to_string(getpid()) + " also runs this sweep (cases: 1); waiting for it\n");
  EXPECT_EQ(engine_.starts, 2);
  expectSameTable(sweep);
}

TEST_F(EngineRunTest, RemovesNothingThatItsOwnFilesOnlyName)
{
  const Sweep sweep = load("");
  SweepRunOptions options;
  options.stop_wanted = [] { return true; };
  runSweepOn(engine_, sweep, results_, options);
  const std::string victim = written(directory_, "victim.txt", "precious");
  for (const char* owner : {"../victim.txt", "", "owner-", "owner-1-0123456789abcdef.lock/../../victim.txt"})
  {
    Database(results_, Database::Access::WRITE)
        .execute("INSERT INTO claims SELECT run_hash, " + std::to_string(PHYSICS_VERSION) + ", '" +
                 std::string(owner) + "' FROM plan");
    EXPECT_EQ(run(sweep).counts.done, 1u);
    EXPECT_EQ(contents(victim), "precious");
    Database(results_, Database::Access::WRITE).execute("DELETE FROM cases");
  }
  EXPECT_EQ(warnings_, "");
}

}  // namespace
}  // namespace ratchet_sieve
