#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include <sys/wait.h>

#include <gtest/gtest.h>

#include "small_scenes.h"

namespace ratchet_sieve
{

struct Result
{
  int status = -1;
  std::string output;
  std::string errors;
};

/// sieve_run as a program.
class SieveRun : public testing::Test
{
protected:
  Result run(const std::string& arguments) const
  {
    const std::string output = streams_ / "output";
    const std::string errors = streams_ / "errors";
    const std::string command =
        std::string(std::getenv("SIEVE_RUN")) + " " + arguments + " >" + output + " 2>" + errors;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(output), contents(errors)};
  }

  static std::string config(const std::string& name)
  {
    return std::string(std::getenv("CONFIG_DIRECTORY")) + "/" + name;
  }

  std::string scene(const std::string& text) const
  {
    std::ofstream(streams_ / "scene.yaml") << text;
    return streams_ / "scene.yaml";
  }

  /// Refused with this one line; nothing is written.
  void expectRefusal(const std::string& arguments, const std::string& line) const
  {
    const Result result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_EQ(result.errors, "sieve_run: " + line + "\n");
    EXPECT_EQ(result.output, "");
    EXPECT_TRUE(written_.empty());
  }

  ScratchDirectory streams_;
  ScratchDirectory written_;
};

}  // namespace ratchet_sieve
