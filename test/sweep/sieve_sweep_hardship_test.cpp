// sieve_sweep where something is in the way: cases that end their process, limits, one file named twice.
#include <csignal>

#include "sieve_sweep_program.h"

namespace ratchet_sieve
{
namespace
{

using SieveSweepHardship = SieveSweep;

/// One of the cases would not end, and its process is killed as by the kernel where memory is short.
TEST_F(SieveSweepHardship, ACaseWhoseProcessDiesTwiceFailsAndTheOthersAreRun)
{
  const std::string file = sweep(SMALL_SCENE + std::string("set: {boundary: periodic}\n"
                                                           "grid: {duration: [1.0e+8, 0.2, 0.3]}\n"));
  const std::string results = directory_ / "s.db";
  /// Whether the first case is under way in a process that knows of so many deaths.
  const auto is_under_way = [&results](int deaths)
  {
    return std::filesystem::exists(results) &&
           textOf(results, "SELECT 1 FROM sqlite_master WHERE name = 'under_way'") == "1" &&
           textOf(results,
                  "SELECT COUNT(d.run_hash) FROM under_way JOIN plan USING (run_hash) "
                  "LEFT JOIN deaths d USING (run_hash) WHERE position = 0 GROUP BY position") ==
               std::to_string(deaths);
  };
  for (int death = 0; death < 2; ++death)
  {
    const pid_t child = start({"run", file, "--threads", "1"});
    while (!is_under_way(death) && waitpid(child, nullptr, WNOHANG) == 0)
      usleep(1000);
    kill(child, SIGKILL);
    ASSERT_EQ(end(child), -SIGKILL) << errors();
  }
  EXPECT_EQ(run({"run", file, "--threads", "1"}), 1);
  const std::string reason =
      "the process that ran it died twice: it crashed or was killed, as where memory is short";
  EXPECT_NE(errors().find("sieve_sweep: warning: case 1 (duration=1.0e+8) failed: " + reason + "\n"),
            std::string::npos)
      << errors();
  EXPECT_NE(errors().find("3 cases: 2 done, 1 failed, 0 under way, 0 to go"), std::string::npos) << errors();
  EXPECT_EQ(textOf(results, "SELECT error FROM cases WHERE duration > 1"), reason);
}

TEST_F(SieveSweepHardship, OutputsAreNeitherTheSweepNorItsResults)
{
  const std::string scene = written(directory_, "scene.yaml",
                                    "species: [{name: A, count: 1, radius: 0.002, mass: 1}]\n"
                                    "duration: 0.1\n");
  const std::string file = sweep("scene: scene.yaml\n");
  const std::string results = directory_ / "s.db";
  const auto expect_same = [this](const std::vector<std::string>& arguments, const std::string& line)
  {
    EXPECT_EQ(run(arguments), 2);
    EXPECT_EQ(errors(), "sieve_sweep: " + line + "; must be another one\n");
  };
  expect_same({"run", file, "--db", file}, "--db " + file + ": is the file of SWEEP");
  expect_same({"run", file, "--db", scene}, "--db " + scene + ": is the file of the sweep's scene");
  ASSERT_EQ(run({"run", file}), 0) << errors();
  const auto before = tableOf(results);
  const std::string text = contents(file);
  expect_same({"export", file, "--out", results}, "--out " + results + ": is the file of --db");
  expect_same({"export", file, "--out", file}, "--out " + file + ": is the file of SWEEP");
  std::filesystem::create_directory(directory_ / "report");
  const std::string inside = written(directory_, "report/scene.yaml", SMALL_SCENE);
  ASSERT_EQ(run({"run", inside}), 0) << errors();
  expect_same({"report", inside, "--out", directory_ / "report"},
              "--out " + inside + ": is the file of SWEEP");
  EXPECT_EQ(tableOf(results), before);
  EXPECT_EQ(contents(file), text);
}

/// Whether the scene, `set` or an axis names it.
TEST_F(SieveSweepHardship, OutputsAreNotTheFeedOfACase)
{
  const std::string table = "time,species,radius,mass\n0.01,A,0.002,1\n";
  std::vector<std::string> feeds;
  for (const char* name : {"report/cases.csv", "set.csv", "grid.csv", "cases.csv"})
  {
    std::filesystem::create_directory(directory_ / "report");
    feeds.push_back(written(directory_, name, table));
  }
  written(directory_, "scene.yaml",
          "species: [{name: A, radius: 0.002, mass: 1}]\nduration: 0.02\nboundary: open\n"
          "feed: {file: report/cases.csv}\n");
  const auto expect_same = [&](const std::string& more, const std::string& feed)
  {
    const std::string file = sweep("scene: scene.yaml\n" + more);
    ASSERT_EQ(run({"run", file}), 0) << errors();
    EXPECT_EQ(run({"export", file, "--out", feed}), 2);
    EXPECT_EQ(errors(), "sieve_sweep: --out " + feed + ": is the file of feed.file; must be another one\n");
    EXPECT_EQ(contents(feed), table);
  };
  expect_same("", feeds[0]);
  expect_same("set: {feed.file: set.csv}\n", feeds[1]);
  expect_same("grid: {feed.file: [set.csv, grid.csv]}\n", feeds[2]);
  expect_same("cases: [{feed: {file: cases.csv}}, {gravity: 9}]\n", feeds[3]);
  EXPECT_EQ(run({"report", sweep("scene: scene.yaml\n"), "--out", directory_ / "report"}), 2);
  EXPECT_EQ(contents(feeds[0]), table);
}

/// The directory of results is not made, or the file may not be written.
TEST_F(SieveSweepHardship, NamesTheReasonWhereResultsCannotBeWritten)
{
  const std::string file = sweep(SMALL_SCENE);
  const std::string results = "/proc/none/s.db";
  EXPECT_EQ(run({"run", file, "--db", results}), 1);
  EXPECT_EQ(errors(), "sieve_sweep: " + results + ": cannot be written: No such file or directory\n");
}

TEST_F(SieveSweepHardship, ResultsAreInAFile)
{
  const std::string file = sweep(SMALL_SCENE);
  EXPECT_EQ(run({"run", file, "--db", ":memory:"}), 2);
  EXPECT_EQ(errors(), "sieve_sweep: --db :memory:: must be a file\n");
  EXPECT_FALSE(std::filesystem::exists(":memory:"));
}

/// A limit on the size of files, in units of 512 or 1024 bytes, ends a program that does not ignore SIGXFSZ.
TEST_F(SieveSweepHardship, StoredResultsStayWhereTheFileMayNotGrow)
{
  const std::string file = sweep(SMALL_SCENE + std::string("seed: {first: 1, count: 1000}\n"));
  const std::string errors = directory_ / "errors";
  const int status = std::system(("ulimit -f 400; '" + std::string(std::getenv("SIEVE_SWEEP")) + "' run '" +
                                  file + "' 2>'" + errors + "'")
                                     .c_str());
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const std::string results = directory_ / "s.db";
  const std::string said = contents(errors);
  EXPECT_NE(said.find(results + ": "), std::string::npos) << said;
  EXPECT_NE(said.find("; stored results are safe, "), std::string::npos) << said;
  EXPECT_NE(said.find("could not be stored: free some space and start again\n"), std::string::npos) << said;
  EXPECT_EQ(textOf(results, "PRAGMA integrity_check"), "ok");
  const auto kept = tableOf(results);
  EXPECT_GT(kept.size(), 0u);
  EXPECT_LT(kept.size(), 1000u);
  EXPECT_EQ(run({"run", file}), 0);
  const auto all = tableOf(results);
  EXPECT_EQ(all.size(), 1000u);
  for (const auto& [run_hash, row] : kept)
    EXPECT_EQ(all.at(run_hash), row);
}

}  // namespace
}  // namespace ratchet_sieve
