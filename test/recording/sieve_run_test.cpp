// sieve_run as a program: arguments, exit status, standard output and error, and files.
#include <algorithm>
#include <cstdlib>

#include <sys/wait.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ratchet_sieve/recording/version.h"
#include "sieve_run_program.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::json;

TEST_F(SieveRun, SumsUpOnStandardOutput)
{
  const Result result = run(config("demo.yaml") + " --duration 0.5 --seed 7 --set base.inclination=0.1");
  EXPECT_EQ(result.status, 0) << result.errors;
  const Json json = Json::parse(result.output);
  const auto binsOf = [&json](int k)
  { return json["species"][k]["left"].dump() + " left, " + json["species"][k]["right"].dump() + " right"; };
  const std::string size = "sieve_run: 266 disks, at rest a layer of about 0.0166 m, about 1 MB of memory\n";
  const std::string closing = "; A: " + binsOf(0) + "; B: " + binsOf(1) + "\n";
  EXPECT_EQ(result.errors.rfind(size + "sieve_run: Q 0.", 0), 0u) << result.errors;
  EXPECT_EQ(result.errors.substr(result.errors.find(';')), closing);
  EXPECT_EQ(
      run(config("demo.yaml") + " --duration 0 -v").errors,
      "sieve_run: plan: pairs, spin, drive, no contact times (contact_duration is 0), "
      "no base search above the base's reach, "
      "no SIMD (only for independent disks without contact times on a periodic sawtooth with a vertical "
      "sine drive)\n" +
          size + "sieve_run: Q undefined, P undefined; A: 0 left, 0 right; B: 0 left, 0 right\n");
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["simulated_time"], 0.5);
  EXPECT_EQ(json["through_base"], 0);
}

TEST_F(SieveRun, WarnsOfASceneThatCannotBeMeant)
{
  const Result result = run(config("demo.yaml") + " --duration 0 --set base.amplitude=2");
  EXPECT_EQ(result.status, 0) << result.errors;
  const Json warnings = Json::parse(result.output)["warnings"];
  ASSERT_EQ(warnings.size(), 1u);
  const std::string warning = warnings[0];
  EXPECT_EQ(warning.rfind("base.amplitude = 2 m: 100 times a tooth's width", 0), 0u) << warning;
  EXPECT_NE(result.errors.find("MB of memory\nsieve_run: warning: " + warning + "\n"), std::string::npos)
      << result.errors;
}

TEST_F(SieveRun, ChecksTheReboundFloorByRunsAtLowerOnes)
{
  const std::string scene = config("demo.yaml") + " --duration 3 --set base.inclination=0.2";
  const Result checked = run(scene + " --check-floor --set contact.min_rebound_speed=0.08");
  EXPECT_EQ(checked.status, 0) << checked.errors;
  const Json runs = Json::parse(checked.output)["floor_check"];
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[2]["min_rebound_speed"], 0.02);
  EXPECT_NE(checked.errors.find("\nsieve_run: quality changes by "), std::string::npos) << checked.errors;
  expectRefusal(scene + " --check-floor --set contact.min_rebound_speed=0",
                "--check-floor: contact.min_rebound_speed of " + config("demo.yaml") +
                    " is 0: there is no floor to check");
}

TEST_F(SieveRun, SaysHowLargeAPourIsAndGivesItUpWhenInterrupted)
{
  // Some millions of disks, whose pour takes half a minute.
  const std::string errors = streams_ / "errors";
  const std::string script = std::string(std::getenv("SIEVE_RUN")) + " " + config("demo.yaml") +
                             " --set density=20000 --summary " + (written_ / "s.json") + " --checkpoint " +
                             (written_ / "run.checkpoint") + " 2>" + errors +
                             " & run=$!; while kill -0 $run && ! grep -q memory " + errors +
                             "; do :; done; kill -INT $run; wait $run";
  const int status = std::system(("bash -c '" + script + "'").c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const std::string said = contents(errors);
  EXPECT_NE(said.find("sieve_run: 2666666 disks, at rest a layer of about "), std::string::npos) << said;
  EXPECT_NE(said.find(" of 2666666 disks were poured; nothing was written\n"), std::string::npos) << said;
  EXPECT_TRUE(written_.empty());
}

/// The numbers of disks of the second machine, in it and in its bins, are those of the first one's right bin.
TEST_F(SieveRun, FeedsASecondStageWithWhatLeftTheFirst)
{
  const std::string fed = config("demo.yaml") + " --set density=null --set base.inclination=0.19 ";
  const std::string exits = streams_ / "exits.csv";
  const Result one = run(fed + "--duration 4 --set feed.rate=200 --exits " + exits);
  ASSERT_EQ(one.status, 0) << one.errors;
  const std::string next = fed + "--seed 2 --set feed.file=" + exits + " --set feed.side=right ";
  EXPECT_EQ(run(next + "--exits " + exits).status, 2);
  const Result two = run(next + "--duration 4 --exits " + (streams_ / "second"));
  ASSERT_EQ(two.status, 0) << two.errors;
  const Json first = Json::parse(one.output)["species"];
  const Json second = Json::parse(two.output)["species"];
  for (std::size_t s = 0; s < 2; ++s)
  {
    EXPECT_GT(first[s]["right"].get<int>(), 20);
    EXPECT_EQ(second[s]["count"], first[s]["right"]);
  }

  const std::string checkpoint = streams_ / "half.checkpoint";
  const std::string half = next + "--duration 2 --checkpoint " + checkpoint;
  ASSERT_EQ(run(half + " --exits " + (streams_ / "half")).status, 0);
  const std::string resumed = next + "--duration 4 --resume " + checkpoint;
  ASSERT_EQ(run(resumed + " --exits " + (streams_ / "rest")).status, 0);
  const std::string rest = contents(streams_ / "rest");
  EXPECT_EQ(contents(streams_ / "half") + rest.substr(rest.find('\n') + 1), contents(streams_ / "second"));
}

TEST_F(SieveRun, ShowsItsHelpAndVersion)
{
  const Result help = run("--help");
  EXPECT_EQ(help.status, 0);
  for (const char* option :
       {"--set", "--seed", "--duration", "--until", "--bag", "--bag-rate", "--trajectory",
        "--trajectory-rate", "--html", "--html-size", "--html-rate", "--collisions", "--exits", "--summary",
        "--checkpoint", "--checkpoint-every", "--resume", "--version"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;
  const Result version_result = run("--version");
  EXPECT_EQ(version_result.status, 0);
  EXPECT_EQ(version_result.output, std::string("sieve_run ") + version() + "\n");
}

TEST_F(SieveRun, ListsTheKeysOfAScene)
{
  const Result all = run("--keys");
  EXPECT_EQ(all.status, 0);
  EXPECT_EQ(all.errors, "");
  for (const char* row :
       {"\nboundary                                choice   -       periodic, open or "
        "walled   periodic\n    What",
        "\nspecies.N.radius                        number   m       1e-09 to 1000           "
        "   required\n    Radius"})
    EXPECT_NE(all.output.find(row), std::string::npos) << row;
  const Result some = run("--keys friction");
  EXPECT_NE(some.output.find("\npairs.N.friction "), std::string::npos);
  EXPECT_EQ(some.output.find("restitution "), std::string::npos) << some.output;
  expectRefusal("--keys colour", "--keys colour: no key of a scene contains this");
}

TEST_F(SieveRun, RefusesBadArguments)
{
  expectRefusal("", "SCENE is required; see --help");
  const Result unknown = run(config("demo.yaml") + " --colour red");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find("--colour"), std::string::npos) << unknown.errors;
  EXPECT_EQ(std::count(unknown.errors.begin(), unknown.errors.end(), '\n'), 1);
  expectRefusal(config("demo.yaml") + " --set seed",
                "override seed: must be KEY=VALUE, such as base.inclination=0.105");
  for (const char* rate : {"-1", "nan", "1e6"})
    expectRefusal(config("demo.yaml") + " --bag " + (written_ / "run.bag") + " --bag-rate=" + rate,
                  std::string("--bag-rate: ") + rate + ": must be a number from 0 to 100000 Hz; see --help");
  expectRefusal(config("demo.yaml") + " --bag-rate 10", "--bag-rate requires --bag; see --help");
  for (const char* size : {"0.4", "101", "nan", "big"})
    expectRefusal(config("demo.yaml") + " --html " + (written_ / "run.html") + " --html-size " + size,
                  std::string("--html-size: ") + size + ": must be a number from 0.5 to 100 MB; see --help");
  const std::string trajectory = written_ / "run.dump";
  expectRefusal(config("paper_fig3.yaml") + " --duration 100000000 --trajectory " + trajectory,
                trajectory +
                    ": unknown format of a trajectory; the file's ending must be one of .xyz, "
                    ".extxyz");
  expectRefusal(config("demo.yaml") + " --checkpoint-every -1",
                "--checkpoint-every: -1: must be a number from 0 to 1e+09 s; see --help");
  // The second is a key of accuracy, but none that decides when a run ends.
  for (const char* key : {"speed", "step"})
    expectRefusal(config("demo.yaml") + " --until " + key + "=0.001",
                  std::string("--until: ") + key +
                      ": unknown key; must be one of confidence, mean_vx, quality; see --help");
}

TEST_F(SieveRun, RefusesABadScene)
{
  const std::string bad = scene("species: [{name: A, count: 1, radius: -1, mass: 0.001}]\n");
  expectRefusal(bad + " --summary " + (written_ / "s.json"),
                bad + ":1: species.0.radius = -1: must be a number from 1e-09 to 1000 m");
  expectRefusal("none.yaml", "none.yaml: no such file");
  expectRefusal(config("demo.yaml") + " --seed=-1",
                config("demo.yaml") + ": seed = -1: must be an integer from 0 to 18446744073709551615");
  const std::string overlapping = scene(
      "species: [{name: A, radius: 0.002, mass: 0.001}]\n"
      "initial:\n"
      "  - {species: A, x: 0.1, y: 0.05}\n"
      "  - {species: A, x: 0.2, y: 0.05}\n"
      "  - {species: A, x: 0.203, y: 0.05}\n");
  expectRefusal(overlapping + " --summary " + (written_ / "s.json"),
                overlapping + ": initial.1 and initial.2 overlap by 0.001 m");
}

TEST_F(SieveRun, RefusesAPathThatCannotBeWrittenBeforeItRuns)
{
  const std::string path = written_ / "none/s.json";
  expectRefusal(config("paper_fig3.yaml") + " --duration 100000000 --collisions " + (written_ / "c.csv") +
                    " --summary " + path,
                path + ": cannot be written: No such file or directory");
}

#ifndef SIEVE_RUN_HAS_ROS
TEST_F(SieveRun, RefusesABagWithoutRos)
{
  const std::string bag = written_ / "run.bag";
  expectRefusal(config("demo.yaml") + " --bag " + bag,
                "--bag " + bag + ": bags need ROS, and this build has none");
}
#endif

TEST_F(SieveRun, ReportsAStall)
{
  const std::string stalls = scene(
      "base: {tooth_height: 0, amplitude: 0}\n"
      "contact: {min_rebound_speed: 0}\n"
      "species: [{name: A, count: 1, radius: 0.002, mass: 0.001}]\n");
  const Result result = run(stalls);
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.errors.find("\nsieve_run: warning: "), std::string::npos) << result.errors;
  EXPECT_EQ(Json::parse(result.output)["warnings"].size(), 1u);
}

/// Of a machine that fills and is observed: all that a run sums up goes on.
TEST_F(SieveRun, GoesOnFromACheckpointToTheSameSummary)
{
  const std::string fed = scene(
      "base: {teeth: 4, asymmetry: 0.1, inclination: 0.1}\nboundary: open\nfeed: {rate: 40}\n"
      "species: [{name: A, count: 6, radius: 0.001, mass: 0.01}, {name: B, count: 6, radius: 0.003, mass: "
      "0.001}]\n"
      "observe: [residence_times, height_profile, mass_flow]\n");
  const std::string checkpoint = streams_ / "run.checkpoint";
  const auto summary = [&](const std::string& options, const std::string& collisions)
  {
    const Result result = run(fed + options + " --collisions " + (streams_ / collisions));
    EXPECT_EQ(result.status, 0) << result.errors;
    Json json = Json::parse(result.output);
    json.erase("wall_time");
    return json;
  };
  const Json through = summary(" --duration 20", "through");
  EXPECT_TRUE(through["steady"].is_object());
  summary(" --duration 7.3 --checkpoint " + checkpoint, "first");
  EXPECT_EQ(summary(" --duration 20 --resume " + checkpoint, "second"), through);
  const std::string second = contents(streams_ / "second"), all = contents(streams_ / "through");
  EXPECT_EQ(contents(streams_ / "first") + second.substr(second.find('\n') + 1), all);
  std::ptrdiff_t collisions = 0;
  for (const Json& count : through["collisions"])
    collisions += count.get<std::ptrdiff_t>();
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), collisions + 1);
}

TEST_F(SieveRun, EndsWhenItIsAsSureAsAsked)
{
  const std::string single = config("paper_fig3.yaml") + " --set species.0.count=200 --duration 200 ";
  const Result sure = run(single + "--until mean_vx=0.004 --until confidence=0.9");
  EXPECT_EQ(sure.status, 0) << sure.errors;
  const Json json = Json::parse(sure.output);
  EXPECT_EQ(json["accuracy"]["reached"], true);
  EXPECT_EQ(json["accuracy"]["confidence"], 0.9);
  EXPECT_LE(json["accuracy"]["mean_vx"][0]["half_width"], 0.004);
  EXPECT_LT(json["simulated_time"], 200.0);
  EXPECT_EQ(json["warnings"].size(), 0u);
}

TEST_F(SieveRun, LeavesAWholeCheckpointWhereverItIsKilled)
{
  const std::string checkpoint = streams_ / "run.checkpoint";
  // Enough disks that writing takes a considerable part of the time.
  const std::string run_of_many = config("demo.yaml") + " --set density=40 --duration 100000000";
  const std::string program = std::string(std::getenv("SIEVE_RUN")) + " " + run_of_many +
                              " --checkpoint-every 0 --checkpoint " + checkpoint;
  for (int kills = 0; kills < 2; ++kills)
  {
    // Checkpoints are saved continuously; the program is killed as soon as a temporary file appears beside a
    // checkpoint.
    const std::string script = program + (kills > 0 ? " --resume " + checkpoint : "") +
                               " & run=$!; for ((look = 0; look < 1000000; ++look)); do [ -e " + checkpoint +
                               " ] && [ -e " + checkpoint +
                               ".part$run ] && break; done; kill -9 $run; wait $run";
    EXPECT_EQ(WEXITSTATUS(std::system(("bash -c '" + script + "' >/dev/null 2>&1").c_str())), 128 + 9);
    // Resumed: only the path of the next checkpoint is refused.
    const std::string nowhere = written_ / "none/x";
    expectRefusal(run_of_many + " --resume " + checkpoint + " --checkpoint " + nowhere,
                  nowhere + ": cannot be written: No such file or directory");
  }
}

}  // namespace
}  // namespace ratchet_sieve
