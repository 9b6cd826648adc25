// sieve_sweep as a program: killed, interrupted, run in parts, and refused.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <regex>
#include <set>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/checkpoint.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_ledger.h"
#include "sieve_sweep_program.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::json;

/// Cases long enough for several checkpoints each.
const std::string LONG_SWEEP = std::string(SMALL_SCENE) + R"(
set: {duration: 500, boundary: periodic}
grid: {base.inclination: {from: -0.1, to: 0.1, count: 3}}
seed: {first: 1, count: 4}
)";

TEST_F(SieveSweep, KilledAgainAndAgainComesToTheSameTable)
{
  const std::string file = sweep(LONG_SWEEP);
  ASSERT_EQ(run({"run", file, "--db", directory_ / "whole.db"}), 0) << errors();
  std::mt19937 random(1);
  int kills = 0;
  bool had_checkpoint = false;
  double longest = 0.1;  ///< [s]
  // A case that has twice been killed before its first checkpoint has failed, and is tried again.
  for (int status = -SIGKILL; status != 0; longest *= 1.25)
  {
    const pid_t child = start({"run", file, "--checkpoint-every", "0.02", "--retry-failed"});
    usleep(static_cast<useconds_t>(1e6 * std::uniform_real_distribution<>(0.0, longest)(random)));
    kill(child, SIGKILL);
    status = end(child);
    kills += status == -SIGKILL ? 1 : 0;
    if (std::filesystem::exists(directory_ / "s.db.d"))
      for (const auto& entry : std::filesystem::directory_iterator(directory_ / "s.db.d"))
        had_checkpoint = had_checkpoint || entry.path().extension() == ".checkpoint";
    ASSERT_TRUE(status == -SIGKILL || status == 0 || status == 1) << status << errors();
  }
  EXPECT_GT(kills, 2);
  EXPECT_TRUE(had_checkpoint);
  EXPECT_EQ(tableOf(directory_ / "s.db").size(), 12u);
  EXPECT_EQ(tableOf(directory_ / "s.db"), tableOf(directory_ / "whole.db"));
}

/// The checkpoint is marked by an impossible initial energy, which a restarted case would not have.
TEST_F(SieveSweep, KilledHalfWayThroughACaseGoesOnFromItsCheckpoint)
{
  const std::string file = sweep(SMALL_SCENE + std::string("set: {duration: 500, boundary: periodic}\n"));
  ASSERT_EQ(run({"run", file, "--db", directory_ / "whole.db"}), 0) << errors();
  const SceneDefinition scene = CaseBuilder(loadSweep(file)).at(0).scene;
  const std::string path = directory_ / ("s.db.d/" + runHash(scene) + ".physics" +
                                         std::to_string(PHYSICS_VERSION) + ".checkpoint");
  const pid_t child = start({"run", file, "--checkpoint-every", "0.02"});
  while (!std::filesystem::exists(path) && waitpid(child, nullptr, WNOHANG) == 0)
    usleep(1000);
  kill(child, SIGKILL);
  ASSERT_EQ(end(child), -SIGKILL) << errors();
  {
    const Checkpoint half_way = readCheckpoint(path, scene);
    EXPECT_GT(half_way.simulation.time(), 0.0);
    EXPECT_LT(half_way.simulation.time(), 500.0);
    writeCheckpoint(path, half_way.simulation, {1234.5, half_way.progress.through_base});
  }
  ASSERT_EQ(run({"run", file}), 0) << errors();
  const auto value = [this](const char* results, const char* column)
  { return textOf(directory_ / results, std::string("SELECT ") + column + " FROM cases"); };
  EXPECT_EQ(value("s.db", "energy_start"), "1234.5");
  for (const char* column : {"energy_end", "events", "\"mean_vx.A\"", "\"base_impulse.y\""})
    EXPECT_EQ(value("s.db", column), value("whole.db", column)) << column;
  EXPECT_FALSE(std::filesystem::exists(directory_ / "s.db.d"));
}

TEST_F(SieveSweep, IsRefusedWhileAnotherProcessWritesTheResults)
{
  const std::string file = sweep(SMALL_SCENE + std::string("set: {duration: 1.0e+8, boundary: periodic}\n"));
  const std::string results = directory_ / "s.db";
  const pid_t child = start({"run", file}, "first");
  while (!LockedFile::isLocked(results) && waitpid(child, nullptr, WNOHANG) == 0)
    usleep(1000);
  EXPECT_EQ(run({"run", file}), 1);
  EXPECT_EQ(errors(), "sieve_sweep: " + results + ": another process runs a sweep into this file\n");
  const std::string link = directory_ / "link.db";
  std::filesystem::create_hard_link(results, link);
  EXPECT_EQ(run({"run", file, "--db", link}), 1);
  EXPECT_EQ(errors(), "sieve_sweep: " + link + ": another process runs a sweep into this file\n");
  EXPECT_EQ(run({"export", file, "--db", directory_ / "other.db", "--out", link}), 1);
  EXPECT_EQ(errors(), "sieve_sweep: " + link + ": cannot be written: another program is writing it\n");
  kill(child, SIGKILL);
  end(child);
  EXPECT_FALSE(LockedFile::isLocked(results));
}

TEST_F(SieveSweep, MergesItsPartsIntoTheTableOfOneRun)
{
  const std::string file = sweep(SMALL_SCENE + std::string("grid: {base.inclination: [-0.1, 0, 0.1]}\n"
                                                           "seed: {first: 1, count: 5}\n"));
  const std::string results = directory_ / "s.db";
  const auto part = [this](int k) { return directory_ / ("s." + std::to_string(k) + "-of-3.db"); };
  const auto exported = [this](const std::vector<std::string>& arguments)
  {
    EXPECT_EQ(run(arguments), 0) << errors();
    return std::regex_replace(output(), std::regex(",[^,]*,[^,]*\r\n"), "\n");  // without wall_time and host
  };
  ASSERT_EQ(run({"run", file, "--db", directory_ / "whole.db"}), 0) << errors();
  for (int k = 1; k <= 3; ++k)
  {
    ASSERT_EQ(run({"run", file, "--part", std::to_string(k) + "/3"}), 0) << errors();
    EXPECT_EQ(errors().rfind("5 cases: 5 done, 0 failed, 0 under way, 0 to go\n", 0), 0u) << errors();
  }
  EXPECT_EQ(run({"status", file, "--part", "2/3"}), 0);
  EXPECT_EQ(output().rfind("5 cases: 5 done, 0 failed, 0 under way, 0 to go\n", 0), 0u) << output();
  const std::string before = contents(part(1));
  ASSERT_EQ(run({"merge", file, part(3), part(1)}), 0) << errors();
  EXPECT_EQ(errors().rfind("15 cases: 10 done, 0 failed, 0 under way, 5 to go\n", 0), 0u) << errors();
  ASSERT_EQ(run({"merge", file, part(1), part(2), part(3), part(2)}), 0) << errors();
  EXPECT_EQ(contents(part(1)), before);
  EXPECT_EQ(exported({"export", file}), exported({"export", file, "--db", directory_ / "whole.db"}));
  EXPECT_EQ(tableOf(results).size(), 15u);
  EXPECT_FALSE(std::filesystem::exists(results + ".d"));
}

TEST_F(SieveSweep, MergesNothingIfAFileHasOtherResults)
{
  const std::string other = written(directory_, "other.yaml", SMALL_SCENE + std::string("seed: [7]\n"));
  ASSERT_EQ(run({"run", other}), 0) << errors();
  const std::string file = sweep(SMALL_SCENE + std::string("seed: {first: 1, count: 2}\n"));
  ASSERT_EQ(run({"run", file, "--part", "1/2"}), 0) << errors();
  const std::string part = directory_ / "s.1-of-2.db";
  const auto expect_refusal = [&](const std::vector<std::string>& files, const std::string& text)
  {
    std::vector<std::string> arguments = {"merge", file};
    arguments.insert(arguments.end(), files.begin(), files.end());
    EXPECT_EQ(run(arguments), 2);
    EXPECT_EQ(errors().rfind("sieve_sweep: " + text, 0), 0u) << errors();
    EXPECT_EQ(errors().find('\n'), errors().size() - 1) << errors();
    EXPECT_FALSE(std::filesystem::exists(directory_ / "s.db"));
  };
  Database(directory_ / "other.db", Database::Access::WRITE)
      .execute("UPDATE cases SET run_hash = 'of two' || char(10) || 'lines'");
  expect_refusal(
      {part, directory_ / "other.db"},
      (directory_ / "other.db") + ": has a result of no case of " + file + ": run_hash of two lines\n");
  expect_refusal({part, file}, file + ": file is not a database\n");
  expect_refusal({part, directory_ / "none.db"},
                 (directory_ / "none.db") + ": no such file; sieve_sweep run makes it\n");
  Database(part, Database::Access::WRITE).execute("UPDATE cases SET physics = 0");
  expect_refusal({part}, part + ": has a result of another physics version than ");
  for (const char* wrong : {"0/3", "4/3", "3", "1/", "a/b", "1/2/3"})
  {
    EXPECT_EQ(run({"run", file, "--part", wrong}), 2) << wrong;
    EXPECT_EQ(errors(), std::string("sieve_sweep: --part ") + wrong +
                            ": must be K/N, a part from 1 to the number of parts; see --help\n");
  }
}

TEST_F(SieveSweep, MergesACaseThatFailedOnceAndIsDoneNow)
{
  const std::string file = sweep(SMALL_SCENE + std::string("seed: {first: 1, count: 2}\n"));
  const std::string part = directory_ / "s.1-of-2.db";
  ASSERT_EQ(run({"run", file, "--part", "1/2"}), 0) << errors();
  Database(part, Database::Access::WRITE).execute("UPDATE cases SET status = 'failed', error = 'no memory'");
  ASSERT_EQ(run({"merge", file, part}), 0) << errors();
  EXPECT_EQ(errors().rfind("2 cases: 0 done, 1 failed, ", 0), 0u) << errors();
  ASSERT_EQ(run({"run", file, "--part", "1/2", "--retry-failed"}), 0) << errors();
  ASSERT_EQ(run({"merge", file, part}), 0) << errors();
  EXPECT_EQ(errors().rfind("2 cases: 1 done, 0 failed, ", 0), 0u) << errors();
}

/// By Ctrl-C, and by the end of its terminal.
TEST_F(SieveSweep, InterruptedSaysHowToGoOn)
{
  const std::string file = sweep(LONG_SWEEP);
  for (const int signal : {SIGINT, SIGHUP})
  {
    const pid_t child = start({"run", file});
    // It handles signals once it has begun to write.
    while (!LockedFile::isLocked(directory_ / "s.db") && waitpid(child, nullptr, WNOHANG) == 0)
      usleep(1000);
    kill(child, signal);
    EXPECT_EQ(end(child), 1);
    EXPECT_NE(errors().find("of 12 cases to go; run the same command to continue\n"), std::string::npos)
        << errors();
  }
  EXPECT_EQ(run({"run", file}), 0) << errors();
  EXPECT_EQ(tableOf(directory_ / "s.db").size(), 12u);
}

TEST_F(SieveSweep, InterruptedAsItListsItsCasesSaysSo)
{
  const std::string file = sweep(SMALL_SCENE + std::string("seed: {first: 1, count: 1000000}\n"));
  std::ofstream(directory_ / "s.db");  // what is there is locked first
  const pid_t child = start({"run", file});
  while (!LockedFile::isLocked(directory_ / "s.db") && waitpid(child, nullptr, WNOHANG) == 0)
    usleep(1000);
  kill(child, SIGINT);
  EXPECT_EQ(end(child), 1);
  EXPECT_EQ(errors(),
            "sieve_sweep: stopped while the cases were listed: none was run; run the same command to "
            "continue\n");
}

TEST_F(SieveSweep, RefusesBeforeAnythingIsRun)
{
  const auto expect_refusal = [this](const std::vector<std::string>& arguments, const std::string& part)
  {
    EXPECT_EQ(run(arguments), 2) << errors();
    EXPECT_NE(errors().find(part), std::string::npos) << errors();
    EXPECT_EQ(errors().find('\n'), errors().size() - 1) << errors();
    EXPECT_FALSE(std::filesystem::exists(directory_ / "s.db"));
  };
  expect_refusal({"run", sweep("gird: {}\n")}, "sieve_sweep: " + (directory_ / "s.yaml") +
                                                   ":1: gird: unknown key; did you "
                                                   "mean grid?");
  expect_refusal({"run", sweep(SMALL_SCENE + std::string("grid: {base.inclination: [9]}\n"))},
                 "case 1 (base.inclination=9): ");
  const std::string huge = sweep(SMALL_SCENE + std::string("seed: {first: 1, count: 1000000000}\n"));
  expect_refusal({"run", huge}, "s.yaml: 1000000000 cases: about ");
  EXPECT_NE(errors().find(" of processor time, by the corners of the grid; use --yes to run them"),
            std::string::npos)
      << errors();
  expect_refusal({"run", directory_ / "none.yaml"}, "none.yaml: no such file");
  expect_refusal({"run"}, "SWEEP is required");
  expect_refusal({}, "subcommand is required");
}

TEST_F(SieveSweep, ListsShowsAndExports)
{
  const std::string file = sweep(SMALL_SCENE + std::string("grid: {gravity: [8, 9]}\n"));
  EXPECT_EQ(run({"run", file, "--dry-run"}), 0);
  EXPECT_EQ(output(), "1: gravity=8\n2: gravity=9\n");
  const std::string program = std::getenv("SIEVE_SWEEP");
  for (const std::string& printing :
       {"run " + file + " --dry-run", std::string("--help"), std::string("--version")})
  {
    const int status =
        std::system((program + " " + printing + " >/dev/full 2>" + (directory_ / "full")).c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1) << printing;
    EXPECT_NE(contents(directory_ / "full")
                  .find("sieve_sweep: standard output: cannot be written: No space left on device\n"),
              std::string::npos)
        << contents(directory_ / "full");
  }
  EXPECT_EQ(errors().rfind("sieve_sweep: 2 cases: about ", 0), 0u) << errors();
  EXPECT_NE(errors().find("\nsieve_sweep: gravity=9: about "), std::string::npos) << errors();
  EXPECT_FALSE(std::filesystem::exists(directory_ / "s.db"));
  EXPECT_EQ(run({"status", file}), 0);
  EXPECT_EQ(output(), "2 cases, not begun\n");
  EXPECT_EQ(run({"export", file}), 1);
  EXPECT_EQ(run({"run", file}), 0);
  EXPECT_EQ(run({"status", file}), 0);
  EXPECT_EQ(output().rfind("2 cases: 2 done, 0 failed, 0 under way, 0 to go\n", 0), 0u) << output();
  EXPECT_EQ(run({"export", file, "--out", directory_ / "s.csv"}), 0);
  const std::string csv = contents(directory_ / "s.csv");
  EXPECT_EQ(csv.rfind("gravity,seed,status,error,", 0), 0u) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_FALSE(std::filesystem::exists(directory_ / "s.db-wal"));
}

TEST_F(SieveSweep, ReportsMeansOverTheSeedsAndTheirErrors)
{
  const std::string file = sweep(
      SMALL_SCENE +
      std::string("grid: {base.inclination: [-0.2, 0, 0.2], base.frequency: [20, 25]}\nset: {duration: 1}\n"
                  "seed: {first: 1, count: 3}\n"));
  ASSERT_EQ(run({"run", file}), 0) << errors();
  ASSERT_EQ(
      run({"report", file, "--out", directory_ / "report", "--field", "mean_vx.A", "--field", "events"}), 0)
      << errors();
  const auto in_report = [this](const std::string& name)
  { return contents(directory_ / ("report/" + name)); };
  for (const char* name : {"mean_vx.A_curves", "mean_vx.A_map", "events_curves", "events_map"})
  {
    EXPECT_EQ(in_report(std::string(name) + ".png").rfind("\x89PNG", 0), 0u) << name;
    EXPECT_NE(in_report(std::string(name) + ".svg").find("<svg"), std::string::npos) << name;
  }
  std::istringstream means(in_report("means.csv"));
  std::string line;
  std::getline(means, line);
  EXPECT_EQ(line,
            "base.inclination [rad],base.frequency [Hz],seeds,mean_vx.A [m/s],mean_vx.A_stderr [m/s],events,"
            "events_stderr\r");
  const Json report = reportJson("report");
  EXPECT_EQ(pageJson("report"), report);
  int lines = 0;
  for (; std::getline(means, line); ++lines)
  {
    double x = 0.0, y = 0.0, mean = 0.0, error = 0.0;
    int seeds = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%d,%lf,%lf", &x, &y, &seeds, &mean, &error), 5) << line;
    EXPECT_EQ(seeds, 3);
    const std::string cell = " FROM cases WHERE \"base.inclination\" = " + std::to_string(x) +
                             " AND \"base.frequency\" = " + std::to_string(y);
    const std::string column = "\"mean_vx.A\"";
    const double expected = std::stod(textOf(directory_ / "s.db", "SELECT AVG(" + column + ")" + cell));
    const double squares =
        std::stod(textOf(directory_ / "s.db", "SELECT AVG(" + column + "*" + column + ")" + cell));
    EXPECT_NEAR(mean, expected, 1e-12);
    EXPECT_NEAR(error, std::sqrt((squares - expected * expected) / 2), 1e-9);
    const Json& place = report["places"][static_cast<std::size_t>(lines)];
    EXPECT_EQ(report["x"]["values"][place["x"].get<std::size_t>()], x);
    EXPECT_EQ(report["y"]["values"][place["y"].get<std::size_t>()], y);
    EXPECT_EQ(place["runs"], seeds);
    EXPECT_EQ(place["means"][0], Json({{"value", mean}, {"error", error}, {"count", 3}}));
  }
  EXPECT_EQ(lines, 6);
}

TEST_F(SieveSweep, ImportsNothingOfTheWorkingDirectory)
{
  written(directory_, "random.py", "raise SystemExit('the file of the user')");
  sweep(SMALL_SCENE + std::string("grid: {gravity: [8, 9]}\n"));
  const std::string program = "PYTHONPATH= '" + std::string(std::getenv("SIEVE_SWEEP")) + "' ";
  shell(directory_ / "", program + "run s.yaml 2> /dev/null");
  shell(directory_ / "", program + "report s.yaml --field events");
}

/// The scene is in another directory than the sweep, and both are named relative to a third.
TEST_F(SieveSweep, ReportsACommandLineThatRunsEachCaseAlone)
{
  std::filesystem::create_directories(directory_ / "the scenes");
  std::filesystem::create_directories(directory_ / "sweeps");
  std::ofstream(directory_ / "the scenes/small.yaml")
      << Json::parse(R"({"base": {"teeth": 4}, "boundary": "open", "duration": 0.2, "species": [
             {"name": "A", "count": 6, "radius": 0.001, "mass": 0.01},
             {"name": "B", "count": 6, "radius": 0.003, "mass": 0.001}]})");
  written(directory_, "sweeps/s.yaml",
          "scene: ../the scenes/small.yaml\nset: {base.frequency: 21}\n"
          "grid: {gravity: [8, 9], base.profile: [[[0, 0], [0.01, 0.004], [0.02, 0]], [[0, 0], [0.02, 0]]]}\n"
          "seed: {first: 18446744073709551613, count: 3}\n");
  const std::string program = std::getenv("SIEVE_SWEEP");
  shell(directory_ / "", program + " run sweeps/s.yaml 2> /dev/null");
  shell(directory_ / "", program + " report sweeps/s.yaml --field events 2> /dev/null");
  const Json report = reportJson("sweeps/s_report");
  EXPECT_EQ(report["command"], "sieve_run 'the scenes/small.yaml' --set base.frequency=21");
  ASSERT_EQ(report["places"].size(), 4u);
  std::set<std::string> seen;
  for (const Json& place : report["places"])
  {
    ASSERT_EQ(place["cases"].size(), 1u);
    const Json& cases = place["cases"][0];
    ASSERT_EQ(cases["seeds"].size(), 3u);
    const std::string words = report["command"].get<std::string>().substr(std::string("sieve_run").size()) +
                              ' ' + cases["arguments"].get<std::string>() + " --seed " +
                              cases["seeds"][2].get<std::string>();
    const Json summary =
        Json::parse(shell(directory_ / "", std::getenv("SIEVE_RUN") + words + " 2> /dev/null"));
    const std::string row =
        " FROM cases WHERE scene_hash = '" + summary["scene_hash"].get<std::string>() + "'";
    const std::string results = directory_ / "sweeps/s.db";
    const char* const gravity_axis = report["x"]["key"] == "gravity" ? "x" : "y";
    EXPECT_EQ(textOf(results, "SELECT gravity" + row), std::to_string(8 + place[gravity_axis].get<int>()));
    EXPECT_EQ(textOf(results, "SELECT COUNT(*)" + row + " AND events = " + summary["events"].dump()), "1");
    seen.insert(summary["scene_hash"].get<std::string>());
  }
  EXPECT_EQ(seen.size(), 4u);
}

TEST_F(SieveSweep, KeepsPagesOfItsCasesAndLinksToThem)
{
  const std::string file =
      sweep(SMALL_SCENE + std::string("grid: {gravity: [8, 9]}\nseed: {first: 1, count: 2}\n"));
  ASSERT_EQ(run({"run", file, "--db", directory_ / "whole.db"}), 0) << errors();
  ASSERT_EQ(run({"run", file, "--html", directory_ / "s_runs"}), 0) << errors();
  EXPECT_EQ(tableOf(directory_ / "s.db"), tableOf(directory_ / "whole.db"));
  ASSERT_EQ(run({"report", file, "--field", "events"}), 0) << errors();
  const Json report = reportJson();
  EXPECT_EQ(report["command"], "sieve_run " + (directory_ / "s_report/scene.yaml"));
  EXPECT_EQ(contents(directory_ / "s_report/scene.yaml").rfind("{base: ", 0), 0u);
  std::set<std::string> pages;
  for (const Json& place : report["places"])
    for (const Json& page : place["cases"][0]["pages"])
    {
      ASSERT_TRUE(page.is_string());
      pages.insert(page);
      const std::string text = contents(directory_ / ("s_report/" + page.get<std::string>()));
      EXPECT_NE(text.find("<title>s: gravity="), std::string::npos) << page;
    }
  EXPECT_EQ(pages.size(), 4u);
  std::ofstream(directory_ / "file") << "no directory";
  EXPECT_EQ(run({"run", file, "--html", directory_ / "file/pages"}), 1);
  EXPECT_EQ(errors().rfind("sieve_sweep: " + (directory_ / "file/pages") + ": cannot be made: ", 0), 0u)
      << errors();
}

/// It looks like markup, and is no UTF-8.
TEST_F(SieveSweep, ReportsASweepOfAnyName)
{
  const std::string name = "<script>alert(1)<\xff";
  const std::string file = written(
      directory_, name + ".yaml", SMALL_SCENE + std::string("grid: {gravity: [8, 9]}\nset: {duration: 0}\n"));
  ASSERT_EQ(run({"run", file}), 0) << errors();
  ASSERT_EQ(run({"report", file, "--field", "events"}), 0) << errors();
  EXPECT_NE(output().find(directory_ / name + "_report/report.html"), std::string::npos) << output();
  EXPECT_EQ(pageJson(name + "_report")["title"].get<std::string>().rfind("<script>alert(1)<", 0), 0u);
  EXPECT_EQ(contents(directory_ / (name + "_report/report.html")).find("<script>alert"), std::string::npos);
}

TEST_F(SieveSweep, HatchesWhatHasTooFewDisksForItsQ)
{
  const std::string file =
      sweep(SMALL_SCENE + std::string("grid: {base.inclination: [-0.2, 0.1, 0.2], base.frequency: [20, 25]}\n"
                                      "set: {duration: 10}\nseed: {first: 1, count: 2}\n"));
  ASSERT_EQ(run({"run", file}), 0) << errors();
  const auto is_hatched = [this](const std::string& field)
  { return contents(directory_ / ("s_report/" + field + "_map.svg")).find("<pattern") != std::string::npos; };
  ASSERT_EQ(run({"report", file}), 0) << errors();
  EXPECT_EQ(errors().rfind("no best Q: ", 0), 0u) << errors();
  EXPECT_TRUE(is_hatched("quality"));
  EXPECT_FALSE(is_hatched("processed"));
  EXPECT_NE(contents(directory_ / "s_report/report.html").find("fewer than 50 disks counted"),
            std::string::npos);
  ASSERT_EQ(run({"report", file, "--least-counted", "6", "--least-processed", "0.1", "--field", "quality"}),
            0)
      << errors();
  EXPECT_FALSE(is_hatched("quality"));
  const std::string best = "not separated: the interval of 95 % contains 0 even at the largest mean Q, ";
  EXPECT_EQ(errors().rfind(best, 0), 0u) << errors();
  EXPECT_NE(contents(directory_ / "s_report/report.html").find(best), std::string::npos);
}

TEST_F(SieveSweep, ChecksTheFloorOfTheBestSetting)
{
  const std::string file =
      sweep(SMALL_SCENE + std::string("grid: {base.inclination: [0.1, 0.2]}\n"
                                      "set: {duration: 10}\nseed: {first: 1, count: 3}\n"));
  ASSERT_EQ(run({"run", file}), 0) << errors();
  EXPECT_EQ(run({"report", file, "--check-floor"}), 2);
  EXPECT_EQ(errors(), "ratchet_sieve.plots.sweep: --check-floor: there is no best setting to check\n");
  ASSERT_EQ(run({"report", file, "--check-floor", "--least-counted", "6"}), 0) << errors();
  EXPECT_NE(errors().find("\nbest setting at contact.min_rebound_speed = 0.0125 m/s: Q "), std::string::npos)
      << errors();
  const auto findings = nlohmann::json::parse(contents(directory_ / "s_report/findings.json"));
  ASSERT_EQ(findings["floor_check"].size(), 3u);
  EXPECT_EQ(findings["floor_check"][0]["quality"], findings["best"]["quality"]);
  EXPECT_EQ(tableOf(directory_ / "s.db").size(), 12u);
  EXPECT_EQ(run({"status", file}), 0);
  EXPECT_EQ(output().rfind("6 cases: 6 done, 0 failed, 0 under way, 0 to go\n", 0), 0u) << output();
}

/// Its Python runs the cases.
TEST_F(SieveSweep, KilledAsItChecksTheFloorItStopsTheCases)
{
  const std::string results = directory_ / "s.db";
  const std::string file = sweep(SMALL_SCENE + std::string("grid: {base.inclination: [0.1, 0.2]}\n"
                                                           "set: {duration: 2000, feed.rate: 20}\n"));
  ASSERT_EQ(run({"run", file}), 0) << errors();
  const pid_t child = start({"report", file, "--check-floor"});
  const auto under_way = [&] { return textOf(results, "SELECT COUNT(*) FROM under_way"); };
  while (under_way() == "0" && waitpid(child, nullptr, WNOHANG) == 0)
    usleep(1000);
  kill(child, SIGKILL);
  EXPECT_EQ(end(child), -SIGKILL) << errors();
  while (LockedFile::isLocked(results))
    usleep(1000);
  EXPECT_EQ(tableOf(results).size(), 2u);
  EXPECT_EQ(under_way(), "0");
}

TEST_F(SieveSweep, WarnsBeforeItRunsAndCountsWarningsAfterIt)
{
  const std::string file =
      sweep(SMALL_SCENE + std::string("set: {base.tooth_width: 20}\ngrid: {gravity: [8, 9]}\n"));
  const std::string warning = "in every case: base.tooth_width = 20 m: ";
  EXPECT_EQ(run({"run", file, "--dry-run"}), 0);
  EXPECT_EQ(errors().rfind("sieve_sweep: warning: " + warning, 0), 0u) << errors();
  EXPECT_EQ(run({"run", file}), 0);
  const std::string said = errors();
  EXPECT_LT(said.find("sieve_sweep: warning: " + warning), said.find("2 cases: ")) << said;
  EXPECT_NE(said.find("2 cases: 2 done, 0 failed, 0 under way, 0 to go, 2 with warnings\n"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("\nwarning " + warning), std::string::npos) << said;
  EXPECT_EQ(textOf(directory_ / "s.db",
                   "SELECT COUNT(*) FROM cases WHERE warnings > 0 AND warning_text LIKE "
                   "'%base.tooth_width = 20 m%'"),
            "2");
  EXPECT_EQ(run({"report", file, "--field", "events"}), 0) << errors();
  EXPECT_NE(contents(directory_ / "s_report/report.html").find("; 2 with warnings"), std::string::npos);
}

TEST_F(SieveSweep, SaysAndReportsWhatIsDoneOfASweepThatHasChanged)
{
  ASSERT_EQ(run({"run", sweep(SMALL_SCENE + std::string("grid: {gravity: [8, 9]}\n"))}), 0) << errors();
  const auto before = tableOf(directory_ / "s.db");
  const std::string file =
      sweep(SMALL_SCENE + std::string("grid: {gravity: [8, 8.5, 9], base.phase: [0, 1]}\n"));
  EXPECT_EQ(run({"status", file}), 0) << errors();
  EXPECT_EQ(
      output().rfind("6 cases: 2 done, 0 failed, 0 under way, 4 to go\nthe sweep file has changed since it "
                     "was run",
                     0),
      0u)
      << output();
  EXPECT_EQ(run({"export", file}), 0) << errors();
  EXPECT_EQ(output().rfind("gravity,base.phase,seed,status,", 0), 0u) << output();
  EXPECT_NE(output().find("\r\n8,0,1,done,"), std::string::npos) << output();
  EXPECT_NE(output().find("\r\n9,0,1,done,"), std::string::npos) << output();
  EXPECT_EQ(run({"report", file, "--field", "events"}), 0) << errors();
  EXPECT_EQ(tableOf(directory_ / "s.db"), before);
  EXPECT_EQ(textOf(directory_ / "s.db", "SELECT COUNT(*) FROM sweeps"), "1");
  EXPECT_EQ(run({"export", sweep(SMALL_SCENE + std::string("grid: {gravity: [7]}\n"))}), 1);
  EXPECT_EQ(errors(),
            "sieve_sweep: " + (directory_ / "s.db") + ": has no results of this sweep file: run it first\n");
}

}  // namespace
}  // namespace ratchet_sieve
