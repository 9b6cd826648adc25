// Sweeps in this process: what is run, what is not, and what becomes of it.
#include "ratchet_sieve/sweep/sweep_run.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <set>
#include <sstream>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/checkpoint.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_ledger.h"
#include "ratchet_sieve/sweep/sweep_report.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{

/// A single disk on a base at rest, without minimum rebound speed or contact duration: it ends in a collapse.
constexpr const char* STALLING_CASE =
    "{contact.min_rebound_speed: 0, base.amplitude: 0, base.tooth_height: 0, species.0.count: 1, "
    "species.1.count: 0, "
    "duration: 100}";

constexpr std::uint64_t NONE = 999;  ///< in place of a position

class SweepRunTest : public testing::Test
{
protected:
  Sweep load(const std::string& text, const std::string& name = "s.yaml") const
  {
    return loadSweep(written(directory_, name, SMALL_SCENE + text));
  }
  std::string text(const std::string& query) const { return textOf(results_, query); }
  std::string status(const Sweep& sweep) const { return statusText(sweep, results_); }

  /// What a process says that may not write the file, nor its directory but with those permissions.
  std::string readElsewhere(const std::function<std::string()>& read, int directory = 0555) const
  {
    namespace fs = std::filesystem;
    const fs::path place = fs::path(results_).parent_path();
    fs::permissions(results_, fs::perms(0444));
    fs::permissions(place, fs::perms(directory));
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0)
    {
      std::string text;
      try
      {
        text = getuid() != 0 || setuid(65534) == 0 ? read() : "setuid";
      }
      catch (const std::exception& error)
      {
        text = error.what();
      }
      _exit(::write(ends[1], text.data(), text.size()) < 0 ? 1 : 0);
    }
    close(ends[1]);
    std::string text;
    char part[4096];
    for (ssize_t size = 0; (size = ::read(ends[0], part, sizeof part)) > 0;)
      text.append(part, static_cast<std::size_t>(size));
    close(ends[0]);
    waitpid(child, nullptr, 0);
    fs::permissions(place, fs::perms(0755));
    fs::permissions(results_, fs::perms(0644));
    return text;
  }

  ScratchDirectory directory_;
  std::string results_ = directory_ / "r.db";
};

/// Numbers and seeds, outlines of a tooth, one corner of an outline, spreads of a species' sizes.
TEST_F(SweepRunTest, KeepsWhatSieveRunWouldSay)
{
  const std::string outline = "[[0, 0], [0.005, 0.004], [0.01, 0.004], [0.03, 0]]";
  const std::map<std::string, std::size_t> rows_of = {
      {"grid: {base.inclination: [0, 0.1]}\nseed: {first: 1, count: 2}\n", 4},
      {"grid:\n  base.profile: [[[0, 0], [0.002, 0.006], [0.02, 0]], " + outline + "]\n  gravity: [8, 9]\n",
       4},
      {"set: {base.profile: " + outline + "}\ngrid: {base.profile.1.1: [0.004, 0.006]}\n", 2},
      {"set: {species.0.size: {distribution: lognormal, spread: 0.1}}\ngrid: {species.0.size.spread: [0, "
       "0.2]}\n",
       2}};
  for (const auto& [text, rows] : rows_of)
  {
    const Sweep sweep = load(text);
    std::filesystem::remove(results_);
    const SweepOutcome outcome = runSweep(sweep, results_, {});
    EXPECT_FALSE(outcome.stopped);
    EXPECT_EQ(outcome.counts.done, rows);
    EXPECT_EQ(outcome.counts.open(), 0u);
    const auto table = tableOf(results_);
    ASSERT_EQ(table.size(), rows);
    std::set<std::string> events;
    CaseBuilder builder(sweep);
    for (std::size_t k = 0; k < rows; ++k)
    {
      const SweepCase& own = builder.at(k);
      const auto row = table.at(runHash(own.scene) + ' ' + std::to_string(PHYSICS_VERSION));
      nlohmann::ordered_json summary = runCase(own, {})->summary;
      summary.erase("wall_time");
      EXPECT_EQ(row.at("summary"), summary.dump());
      EXPECT_EQ(row.at("scene_hash"), sceneHash(own.scene));
      EXPECT_EQ(row.at("seed"), std::to_string(own.scene.seed));
      for (const auto& [key, value] : own.values)
        EXPECT_EQ(row.at(key), value.value()) << text;
      EXPECT_TRUE(events.insert(row.at("events")).second) << text;
    }
    EXPECT_FALSE(std::filesystem::exists(results_ + ".d"));
  }
}

TEST_F(SweepRunTest, RunsOfAGrownSweepOnlyWhatIsNew)
{
  // The wall time of each row would differ, had the case been run again.
  const auto wall_times = [this]
  {
    const Database database(results_, Database::Access::READ);
    Statement select(database, "SELECT run_hash, printf('%.17g', wall_time) FROM cases");
    std::map<std::string, std::string> rows;
    while (select.step())
      rows[select.text(0)] = select.text(1);
    return rows;
  };
  runSweep(load("grid: {base.inclination: [-0.1, 0, 0.05]}\nseed: {first: 1, count: 2}\n"), results_, {});
  const auto before = wall_times();
  EXPECT_EQ(before.size(), 6u);
  const Sweep grown =
      load("grid: {base.inclination: [-0.2, -0.1, 0, 0.05, 0.1]}\nseed: {first: 1, count: 4}\n");
  for (int again = 0; again < 2; ++again)
  {
    runSweep(grown, results_, {});
    const auto after = wall_times();
    EXPECT_EQ(after.size(), 20u);
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
  }
  runSweep(grown, directory_ / "at_once.db", {});
  EXPECT_EQ(tableOf(results_), tableOf(directory_ / "at_once.db"));
}

TEST_F(SweepRunTest, SharesCasesWithAnotherSweepThatHasOtherKeys)
{
  runSweep(load("grid: {base.inclination: [0, 0.1]}\n"), results_, {});
  const Sweep other =
      load("grid: {base.frequency: [23, 20], base.phase: [0, 1]}\nset: {base.inclination: 0.1}\n", "t.yaml");
  EXPECT_EQ(runSweep(other, results_, {}).counts.done, 4u);
  EXPECT_EQ(text("SELECT COUNT(*) FROM cases"), "5");
  EXPECT_EQ(text("SELECT \"base.frequency\" FROM cases WHERE \"base.inclination\" = 0.1"), "23");
  std::ostringstream csv;
  exportCsv(other, results_, csv);
  const std::string table = csv.str();
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
  EXPECT_EQ(csv.str().rfind("base.frequency,base.phase,seed,status,error,", 0), 0u) << csv.str();
}

TEST_F(SweepRunTest, CountsACaseThatIsListedTwiceOnce)
{
  const SweepOutcome outcome =
      runSweep(load("cases: [{gravity: 9}, {gravity: 9.0}, {base.phase: -0.0, gravity: 9}]\n"), results_, {});
  EXPECT_EQ(outcome.counts.cases, 1u);
  EXPECT_EQ(outcome.counts.done, 1u);
}

TEST_F(SweepRunTest, RunsEachCaseWithASeedOfItsOwn)
{
  const auto rows = [this](const std::string& cases)
  {
    runSweep(load(cases), results_, {});
    return text(
        "SELECT group_concat(seed || ' ' || run_hash, ', ') FROM (SELECT * FROM cases ORDER BY seed)");
  };
  const std::string listed = rows("cases: [{seed: 3}, {seed: 5}]\n");
  EXPECT_EQ(listed.rfind("3 ", 0), 0u) << listed;
  EXPECT_EQ(rows("seed: [3, 5]\n"), listed);
}

TEST_F(SweepRunTest, MakesAFailureARowAndGoesOn)
{
  const Sweep sweep = load(std::string("cases: [{gravity: 9}, ") + STALLING_CASE + ", {gravity: 8}]\n");
  const SweepOutcome outcome = runSweep(sweep, results_, {});
  EXPECT_EQ(outcome.counts.done, 2u);
  EXPECT_EQ(outcome.counts.failed, 1u);
  EXPECT_NE(text("SELECT error FROM cases WHERE status = 'failed'").find("collapse"), std::string::npos)
      << text("SELECT error FROM cases WHERE status = 'failed'");
  EXPECT_NE(status(sweep).find("3 cases: 2 done, 1 failed, 0 under way, 0 to go\n"), std::string::npos)
      << status(sweep);
  const std::string row = text("SELECT rowid FROM cases WHERE status = 'failed'");
  runSweep(sweep, results_, {});
  EXPECT_EQ(text("SELECT rowid FROM cases WHERE status = 'failed'"), row);
  SweepRunOptions again;
  again.retry_failed = true;
  again.stop_wanted = [] { return true; };
  EXPECT_EQ(runSweep(sweep, results_, again).counts.open(), 1u);
}

TEST_F(SweepRunTest, DoesNotMixResultsOfAnotherPhysics)
{
  const Sweep sweep = load("grid: {gravity: [8, 9]}\n");
  runSweep(sweep, results_, {});
  const auto before = tableOf(results_);
  Database(results_, Database::Access::WRITE).execute("UPDATE cases SET physics = 0, separation = 99");
  EXPECT_EQ(status(sweep),
            "2 cases: 0 done, 0 failed, 0 under way, 2 to go\n2 results of these cases are of "
            "another physics version than " +
                std::to_string(PHYSICS_VERSION) + " and are not counted\n");
  runSweep(sweep, results_, {});
  EXPECT_EQ(text("SELECT COUNT(*) FROM cases"), "4");
  auto after = tableOf(results_);
  for (auto row = after.begin(); row != after.end();)
    row = row->second["physics"] == "0" ? after.erase(row) : std::next(row);
  EXPECT_EQ(after, before);
  std::ostringstream csv;
  exportCsv(sweep, results_, csv);
  EXPECT_EQ(csv.str().find(",99,"), std::string::npos);
}

TEST_F(SweepRunTest, StopsAtACheckpointAndGoesOnFromIt)
{
  const Sweep sweep = load("set: {duration: 1}\nseed: {first: 1, count: 3}\n");
  SweepRunOptions stopping;
  stopping.threads = 1;
  std::atomic<int> looks{0};
  stopping.stop_wanted = [&looks] { return ++looks > 6; };
  EXPECT_TRUE(runSweep(sweep, results_, stopping).stopped);
  CaseBuilder builder(sweep);
  const SweepCase& first = builder.at(0);
  const std::string path =
      results_ + ".d/" + runHash(first.scene) + ".physics" + std::to_string(PHYSICS_VERSION) + ".checkpoint";
  {
    const Checkpoint checkpoint = readCheckpoint(path, first.scene);
    EXPECT_GT(checkpoint.simulation.time(), 0.0);
    EXPECT_LT(checkpoint.simulation.time(), 1.0);
  }
  EXPECT_FALSE(runSweep(sweep, results_, {}).stopped);
  runSweep(sweep, directory_ / "at_once.db", {});
  EXPECT_EQ(tableOf(results_), tableOf(directory_ / "at_once.db"));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(SweepRunTest, BeginsACaseAnewWhoseCheckpointIsDamaged)
{
  const Sweep sweep = load("");
  std::filesystem::create_directory(results_ + ".d");
  std::ofstream(results_ + ".d/" + runHash(CaseBuilder(sweep).at(0).scene) + ".physics" +
                std::to_string(PHYSICS_VERSION) + ".checkpoint")
      << "no checkpoint";
  std::string warning;
  SweepRunOptions options;
  options.warn = [&warning](const std::string& text) { warning = text; };
  EXPECT_EQ(runSweep(sweep, results_, options).counts.done, 1u);
  EXPECT_NE(warning.find("it is no checkpoint; the case restarts"), std::string::npos) << warning;
}

TEST_F(SweepRunTest, FindsTheCaseAtWhichProcessesDie)
{
  const Sweep sweep = load("grid: {gravity: [8, 9, 10]}\n");
  SweepRunOptions none;
  none.stop_wanted = [] { return true; };
  runSweep(sweep, results_, none);
  SweepResults results(sweep, results_, Database::Access::WRITE);
  std::filesystem::create_directory(workDirectory(results_));
  const auto begun = [](SweepLedger& ledger) { return ledger.exchange({}).value_or(NONE); };
  SweepLedger first(sweep, results);
  EXPECT_EQ(begun(first), 0u);
  EXPECT_EQ(begun(first), 1u);
  EXPECT_EQ(status(sweep).rfind("3 cases: 0 done, 0 failed, 2 under way, 3 to go\n", 0), 0u);
  SweepLedger second(sweep, results);
  EXPECT_EQ(second.deaths(), "");
  EXPECT_EQ(begun(second), 2u);
  EXPECT_EQ(begun(second), 0u);
  EXPECT_EQ(begun(second), NONE);  // one suspect at a time
  EXPECT_TRUE(second.waits());
  std::ofstream(checkpointPath(results_, runHash(CaseBuilder(sweep).at(0).scene))) << "progress";
  EXPECT_EQ(begun(second), 1u);
  SweepLedger third(sweep, results);
  EXPECT_EQ(third.deaths().rfind("case 2 (gravity=9) failed: the process that ran it died twice", 0), 0u);
  EXPECT_EQ(begun(third), 0u);
  third.forgetUnfinished();
  EXPECT_EQ(status(sweep).rfind("3 cases: 0 done, 1 failed, 0 under way, 2 to go\n", 0), 0u);
}

/// All cases are suspect: none is begun again once its checkpoint has cleared it.
TEST_F(SweepRunTest, BeginsASuspectOnce)
{
  const Sweep sweep = load("");
  SweepResults results(sweep, results_, Database::Access::WRITE);
  std::filesystem::create_directory(workDirectory(results_));
  results.list(*legalCases(sweep));
  SweepLedger(sweep, results).exchange({});
  SweepLedger ledger(sweep, results);
  EXPECT_EQ(ledger.exchange({}), 0u);
  std::ofstream(checkpointPath(results_, runHash(CaseBuilder(sweep).at(0).scene))) << "progress";
  for (int again = 0; again < 2; ++again)
    EXPECT_EQ(ledger.exchange({}), std::nullopt);
  EXPECT_FALSE(ledger.waits());
}

TEST_F(SweepRunTest, HasPartsThatAreDisjointAndCompleteForAnyNumberOfThem)
{
  Sweep sweep = load("grid: {gravity: [8, 9, 10]}\nset: {duration: 0.01}\nseed: {first: 1, count: 4}\n");
  runSweep(sweep, results_, {});
  for (const std::uint64_t count : {1u, 3u, 13u})
  {
    std::map<std::string, std::map<std::string, std::string>> all;
    std::uint64_t cases = 0;
    for (std::uint64_t k = 1; k <= count; ++k)
    {
      sweep.part = {k, count};
      const std::string part = directory_ / (std::to_string(k) + "-of-" + std::to_string(count) + ".db");
      EXPECT_EQ(runSweep(sweep, part, {}).counts.done, sweep.sizeOfPart());
      cases += sweep.sizeOfPart();
      all.merge(tableOf(part));
    }
    EXPECT_EQ(cases, 12u) << count;
    EXPECT_EQ(all, tableOf(results_)) << count;
  }
}

TEST_F(SweepRunTest, ExportsWhatRfc4180Allows)
{
  const Sweep sweep = load("grid: {base.inclination: [0.1]}\n");
  runSweep(sweep, results_, {});
  Database(results_, Database::Access::WRITE).execute("UPDATE cases SET error = 'one, \"two\"'");
  std::ostringstream csv;
  exportCsv(sweep, results_, csv);
  const std::string said = csv.str();
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 2);
  EXPECT_EQ(said.substr(said.size() - 2), "\r\n");
  EXPECT_NE(said.find("\r\n0.1,1,done,\"one, \"\"two\"\"\",0.2,"), std::string::npos) << said;
}

/// Also where version 1.0 has rounded them. Such a case has its result.
TEST_F(SweepRunTest, KeepsEverySeedExactly)
{
  const std::vector<std::string> seeds = {"7", "9007199254740993", "9223372036854775808",
                                          "18446744073709551615"};
  const Sweep sweep = load("seed: [7, 9007199254740993, 9223372036854775808, 18446744073709551615]\n");
  runSweep(sweep, results_, {});
  const std::string in_table =
      "SELECT group_concat(seed) FROM (SELECT seed FROM cases ORDER BY length(seed))";
  std::string all;
  for (const std::string& seed : seeds)
    all += (all.empty() ? "" : ",") + seed;
  EXPECT_EQ(text(in_table), all);
  const auto exported = [&]
  {
    std::ostringstream csv;
    exportCsv(sweep, results_, csv);
    return csv.str();
  };
  const std::string csv = exported();
  for (const std::string& seed : seeds)
    EXPECT_NE(csv.find("\r\n" + seed + ",done,"), std::string::npos) << csv;
  Database(results_, Database::Access::WRITE)
      .execute("UPDATE cases SET seed = CAST(seed AS REAL) WHERE typeof(seed) = 'text'");
  EXPECT_NE(text(in_table), all);
  const std::string wall_times = text("SELECT group_concat(wall_time) FROM cases");
  runSweep(sweep, results_, {});
  EXPECT_EQ(text("SELECT group_concat(wall_time) FROM cases"), wall_times);
  EXPECT_EQ(exported(), csv);
}

TEST_F(SweepRunTest, IsReadWhereNothingCanBeWritten)
{
  const Sweep sweep = load("grid: {gravity: [8, 9]}\n");
  runSweep(sweep, results_, {});
  const std::string said = status(sweep);
  std::ostringstream csv;
  exportCsv(sweep, results_, csv);
  EXPECT_EQ(readElsewhere([&] { return status(sweep); }), said);
  EXPECT_EQ(readElsewhere(
                [&]
                {
                  std::ostringstream again;
                  exportCsv(sweep, results_, again);
                  return again.str();
                }),
            csv.str());
  // A part of the results is not in the file yet.
  std::ofstream(results_ + "-wal") << "a log";
  EXPECT_EQ(readElsewhere([&] { return status(sweep); }),
            results_ + ": part of its data is in " + results_ +
                "-wal, which needs a writable directory: copy both files to one");
}

/// A reader's files of the log would keep the owner from writing. Those of a writer that was killed are read.
TEST_F(SweepRunTest, IsReadWithoutATraceByWhomItDoesNotBelongTo)
{
  runSweep(load(""), results_, {});
  const auto read = [&] { return readElsewhere([&] { return text("SELECT status FROM cases"); }, 0777); };
  EXPECT_EQ(read(), "done");
  for (const char* part : {"-wal", "-shm"})
    EXPECT_FALSE(std::filesystem::exists(results_ + part)) << part;
  const pid_t writer = fork();
  if (writer == 0)
  {
    Database database(results_, Database::Access::WRITE);
    database.execute("UPDATE cases SET status = 'failed'");
    _exit(0);
  }
  waitpid(writer, nullptr, 0);
  EXPECT_EQ(read(), "failed");
}

TEST_F(SweepRunTest, IsAnErrorWhereTheResultsFileIsRemovedMeanwhile)
{
  const Sweep sweep = load("seed: {first: 1, count: 20}\n");
  SweepRunOptions removing;
  removing.threads = 1;
  removing.stop_wanted = [this, looks = 0]() mutable
  {
    if (++looks == 10)
      std::filesystem::remove(results_);
    return false;
  };
  EXPECT_THROW(runSweep(sweep, results_, removing), DatabaseError);
  EXPECT_EQ(runSweep(sweep, results_, {}).counts.done, 20u);
}

/// Otherwise the next run would take them for those of a process that died.
TEST_F(SweepRunTest, LeavesNoCaseUnderWayWhereAnErrorEndsIt)
{
  const Sweep sweep = load("set: {duration: 1e6}\nseed: {first: 1, count: 2}\n");
  SweepRunOptions failing;
  failing.progress = [](const SweepProgress& progress)
  {
    if (progress.running > 0)
      throw std::runtime_error("of the caller");
  };
  EXPECT_THROW(runSweep(sweep, results_, failing), std::runtime_error);
  EXPECT_EQ(Database(results_, Database::Access::READ).value("SELECT COUNT(*) FROM under_way"), 0);
}

TEST_F(SweepRunTest, EndsWhereTheFileListsOtherCasesThanTheSweepHas)
{
  const Sweep sweep = load("grid: {gravity: [8, 9]}\n");
  SweepRunOptions none;
  none.stop_wanted = [] { return true; };
  runSweep(sweep, results_, none);
  Database(results_, Database::Access::WRITE).execute("UPDATE plan SET run_hash = 'x' WHERE position = 1");
  EXPECT_THROW(runSweep(sweep, results_, {}), DatabaseError);
}

TEST_F(SweepRunTest, ListsCasesAndWhatIsDone)
{
  runSweep(load("grid: {gravity: [8]}\n"), results_, {});
  std::ostringstream list;
  const Sweep grown = load("grid: {gravity: [8, 9]}\n");
  listCases(grown, *legalCases(grown), results_, list);
  EXPECT_EQ(list.str(), "1: gravity=8  (done)\n2: gravity=9\n");
}

}  // namespace
}  // namespace ratchet_sieve
