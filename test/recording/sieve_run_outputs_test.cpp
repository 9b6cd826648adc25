// What sieve_run writes where something is in the way: closed streams, one file named twice, full disks,
// signals.
#include <algorithm>
#include <cstdlib>
#include <map>

#include <sys/stat.h>
#include <sys/wait.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sieve_run_program.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::json;

class SieveRunOutputs : public SieveRun
{
protected:
  /// A run that takes a fraction of a second.
  const std::string RUN = config("demo.yaml") + " --duration 0.5";

  /// Runs bash. @return its exit status
  static int shell(const std::string& script)
  {
    const int status = std::system(("bash -c '" + script + "'").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Starts a run of many collisions, and runs `script` once it has written some: its process is $run.
  int whileItRuns(const std::string& arguments, const std::string& script,
                  const std::string& before = "env --default-signal=HUP ") const
  {
    return shell(before + std::string(std::getenv("SIEVE_RUN")) + " " + arguments + " --summary " +
                 (written_ / "s.json") + " --collisions " + (written_ / "c.csv") +
                 " 2>/dev/null & run=$!; while kill -0 $run && [ -z \"$(find " + (written_ / "") +
                 " -name c.csv.sieve_part -size +1)\" ]; do :; done; " + script + "; wait $run");
  }
};

TEST_F(SieveRunOutputs, HaveNoLogLinesWhereStandardStreamsAreClosed)
{
  ASSERT_EQ(run(RUN + " --collisions " + (streams_ / "c.csv")).status, 0);
  const std::string program = std::string(std::getenv("SIEVE_RUN")) + " " + RUN;
  EXPECT_EQ(shell(program + " --summary " + (written_ / "s.json") + " --collisions " + (written_ / "c.csv") +
                  " <&- >&- 2>&-"),
            0);
  EXPECT_EQ(contents(written_ / "c.csv"), contents(streams_ / "c.csv"));
  EXPECT_EQ(Json::parse(contents(written_ / "s.json"))["simulated_time"], 0.5);
  EXPECT_EQ(shell(program + " >&- 2>" + (streams_ / "errors")), 1);
  EXPECT_NE(contents(streams_ / "errors")
                .find("\nsieve_run: standard output: cannot be written: Bad file descriptor\n"),
            std::string::npos);
}

TEST_F(SieveRunOutputs, AreNeitherInputsNorEachOther)
{
  const std::string own = scene(contents(config("demo.yaml")));
  const std::string link = streams_ / "link";
  std::filesystem::create_hard_link(own, link);
  const auto expect_same =
      [this](const std::string& arguments, const std::string& output, const std::string& of)
  { expectRefusal(arguments, output + ": is the file of " + of + "; must be another one"); };
  expect_same(own + " --summary " + own, "--summary " + own, "SCENE");
  expect_same(own + " --checkpoint " + link, "--checkpoint " + link, "SCENE");
  expectRefusal(own + " --exits ''", "--exits: the name of a file must not be empty; see --help");
  const std::string file = written_ / "x";
  expect_same(own + " --summary " + file + " --collisions " + (written_ / "./x"),
              "--collisions " + (written_ / "./x"), "--summary");
  const std::string base = written_ / "x_base.xyz";
  expect_same(own + " --html " + base + " --trajectory " + (written_ / "x.xyz"), "--trajectory " + base,
              "--html");
  const std::string to_be = streams_ / "to_be";
  std::filesystem::create_symlink(file, to_be);
  expect_same(own + " --summary " + file + " --html " + to_be, "--html " + to_be, "--summary");
  const std::string checkpoint = streams_ / "run.checkpoint";
  ASSERT_EQ(run(own + " --duration 0.1 --checkpoint " + checkpoint).status, 0);
  expect_same(own + " --resume " + checkpoint + " --summary " + checkpoint, "--summary " + checkpoint,
              "--resume");
#ifdef SIEVE_RUN_HAS_ROS
  std::filesystem::create_symlink(written_ / "run.bag", streams_ / "link.bag");
  const std::string active = written_ / "run.bag.active";
  expect_same(own + " --summary " + active + " --bag " + (streams_ / "link.bag"), "--bag " + active,
              "--summary");
#endif
  expectRefusal(own + " --html " + (streams_ / "output"),
                "--html " + (streams_ / "output") + ": is the file of standard output; must be another one");
  EXPECT_EQ(run(own + " --duration 0.2 --resume " + checkpoint + " --checkpoint " + checkpoint +
                " --summary /dev/null --collisions /dev/null")
                .status,
            0);
  EXPECT_EQ(contents(own), contents(config("demo.yaml")));
}

TEST_F(SieveRunOutputs, AreFinishedWhereOneFails)
{
  const Result result = run(RUN + " --collisions /dev/full --html " + (written_ / "p.html") + " --summary " +
                            (written_ / "s.json"));
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.errors.find("memory\nsieve_run: /dev/full: cannot be written: No space left on device\n"),
            std::string::npos)
      << result.errors;
  EXPECT_EQ(Json::parse(contents(written_ / "s.json"))["simulated_time"], 0.5);
  EXPECT_NE(contents(written_ / "p.html").find("</html>"), std::string::npos);
}

/// A limit on the size of files, in units of 1024 bytes, ends a program that does not ignore SIGXFSZ.
TEST_F(SieveRunOutputs, AreFinishedWhereOneIsTooLarge)
{
#ifdef SIEVE_RUN_HAS_ROS
  const std::string large = written_ / "run.bag";
  const std::string option = " --bag ";
#else
  const std::string large = written_ / "run.xyz";
  const std::string option = " --trajectory ";
#endif
  EXPECT_EQ(shell("ulimit -f 64; " + std::string(std::getenv("SIEVE_RUN")) + " " + RUN + option + large +
                  " --summary " + (written_ / "s.json") + " 2>" + (streams_ / "errors")),
            1);
  const std::string errors = contents(streams_ / "errors");
  EXPECT_NE(errors.find("memory\nsieve_run: " + large + ": cannot be written: "), std::string::npos)
      << errors;
  EXPECT_NE(errors.find("File too large"), std::string::npos) << errors;
  EXPECT_EQ(Json::parse(contents(written_ / "s.json"))["simulated_time"], 0.5);
}

/// By Ctrl-C, and by the end of the terminal.
TEST_F(SieveRunOutputs, AreWholeWhenInterrupted)
{
  const std::string checkpoint = written_ / "k";
  for (const char* signal : {"INT", "HUP"})
  {
    EXPECT_EQ(whileItRuns(config("paper_fig3.yaml") + " --duration 100000000 --checkpoint " + checkpoint,
                          std::string("kill -") + signal + " $run"),
              1);
    const Json warnings = Json::parse(contents(written_ / "s.json"))["warnings"];
    // The first warning: the duration is implausibly long.
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[1].get<std::string>().rfind("stopped at ", 0), 0u);
    EXPECT_EQ(contents(written_ / "c.csv").back(), '\n');
    const Result resumed = run(config("paper_fig3.yaml") + " --duration 0 --resume " + checkpoint);
    EXPECT_NE(resumed.errors.find("beyond this run's duration"), std::string::npos) << resumed.errors;
    for (const char* name : {"k", "s.json", "c.csv"})
      std::filesystem::remove(written_ / name);
  }
}

TEST_F(SieveRunOutputs, AreThoseOfTheWholeRunUnderNohup)
{
  EXPECT_EQ(whileItRuns(config("demo.yaml") + " --duration 10", "kill -HUP $run", "trap \"\" HUP; "), 0);
  EXPECT_EQ(Json::parse(contents(written_ / "s.json"))["simulated_time"], 10.0);
}

/// Neither a refused run nor one that is stopped in its pour replaces an output.
TEST_F(SieveRunOutputs, StayAsTheyWereWhereTheRunDoesNotBegin)
{
  const std::string program = std::getenv("SIEVE_RUN");
  std::string outputs = " --summary " + (written_ / "s.json") + " --collisions " + (written_ / "c.csv") +
                        " --exits " + (written_ / "e.csv") + " --trajectory " + (written_ / "t.xyz") +
                        " --html " + (written_ / "p.html") + " --checkpoint " + (written_ / "k");
#ifdef SIEVE_RUN_HAS_ROS
  outputs += " --bag " + (written_ / "run.bag");
#endif
  ASSERT_EQ(run(RUN + outputs).status, 0);
  const auto files = [this]
  {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(written_ / ""))
      files[entry.path().filename()] = contents(entry.path());
    return files;
  };
  const auto before = files();
  for (const char* more : {" --trajectory x.foo", " --html no/p.html", " --checkpoint no/k",
                           " --checkpoint /dev/full", " --resume no/k"})
  {
    const std::string option = std::string(more).substr(0, std::string(more).find(' ', 1));
    const std::size_t at = outputs.find(option + " ");
    const std::string others =
        at == std::string::npos
            ? outputs
            : outputs.substr(0, at - 1) + outputs.substr(std::min(outputs.size(), outputs.find(" --", at)));
    EXPECT_EQ(run(RUN + others + more).status, 2) << more;
    EXPECT_TRUE(files() == before) << more;
  }
  const std::string large = " --set density=10000";
  EXPECT_EQ(
      shell(program + " " + RUN + outputs + large + " 2>/dev/null & run=$!; while kill -0 $run && [ ! -e " +
            (written_ / "p.html.sieve_part") + " ]; do :; done; kill -INT $run; wait $run"),
      1);
  EXPECT_TRUE(files() == before);
#ifndef __SANITIZE_ADDRESS__  // the sanitizer alone takes more
  EXPECT_EQ(
      shell("ulimit -v 400000; " + program + " " + RUN + outputs + large + " 2>" + (streams_ / "errors")), 1);
  EXPECT_NE(contents(streams_ / "errors").find("demo.yaml: not enough memory: "), std::string::npos)
      << contents(streams_ / "errors");
  EXPECT_TRUE(files() == before);
#endif
}

TEST_F(SieveRunOutputs, GoIntoPipesAsWholeFiles)
{
  const std::string pipe = streams_ / "pipe";
  const std::string read = streams_ / "read";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string program = std::string(std::getenv("SIEVE_RUN")) + " " + RUN + " --summary ";
  for (const char* option : {"", " --exits ", " --collisions ", " --html "})
  {
    const std::string summary = *option == '\0' ? "" : "/dev/null";
    EXPECT_EQ(shell("cat " + pipe + " >" + read + " & " + program + summary + option + pipe +
                    " 2>/dev/null && wait $!"),
              0)
        << option;
    EXPECT_GT(contents(read).size(), 50u) << option;
    EXPECT_EQ(contents(read).back(), '\n') << option;
  }
  expectRefusal(RUN + " --checkpoint " + pipe,
                pipe + ": cannot be written: it is a pipe; must be a file, which each checkpoint replaces");
}

TEST_F(SieveRunOutputs, WaitForTheReaderOfAPipeUntilASignal)
{
  const std::string pipe = streams_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string summary = written_ / "s.json";
  EXPECT_EQ(
      shell(std::string(std::getenv("SIEVE_RUN")) + " " + RUN + " --summary " + summary + " --html " + pipe +
            " 2>" + (streams_ / "errors") + " & run=$!; while kill -0 $run && [ ! -e " + summary +
            ".sieve_part ]; do :; done; while kill -INT $run 2>/dev/null; do :; done; wait $run"),
      2);
  EXPECT_EQ(contents(streams_ / "errors"),
            "sieve_run: " + pipe + ": cannot be written: stopped while nobody read it\n");
  EXPECT_TRUE(written_.empty());
}

TEST_F(SieveRunOutputs, ResumesFromNoDeviceOrPipe)
{
  const std::string pipe = streams_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {std::string("/dev/zero"), pipe})
    expectRefusal(RUN + " --resume " + path, path + ": cannot be resumed from: it is no regular file");
}

}  // namespace
}  // namespace ratchet_sieve
