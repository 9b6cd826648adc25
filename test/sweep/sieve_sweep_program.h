#pragma once

#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sweep_files.h"

namespace ratchet_sieve
{

/// sieve_sweep as a program.
class SieveSweep : public testing::Test
{
protected:
  /// Starts the program, with its standard error in the file `errors`.
  pid_t start(const std::vector<std::string>& arguments, const std::string& errors = "errors") const
  {
    std::vector<std::string> words = {std::getenv("SIEVE_SWEEP")};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
      argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string output_path = directory_ / "output";
    const std::string errors_path = directory_ / errors;
    const pid_t child = fork();
    if (child != 0)
      return child;
    dup2(open(output_path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDOUT_FILENO);
    dup2(open(errors_path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDERR_FILENO);
    signal(SIGHUP, SIG_DFL);  // also where the tests themselves run under nohup
    execv(argv[0], argv.data());
    _exit(127);
  }

  /// Its exit status; negative after a signal.
  static int end(pid_t child)
  {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  int run(const std::vector<std::string>& arguments) const { return end(start(arguments)); }
  std::string errors(const std::string& name = "errors") const { return contents(directory_ / name); }
  std::string output() const { return contents(directory_ / "output"); }
  std::string sweep(const std::string& text) const { return written(directory_, "s.yaml", text); }

  /// Runs a command line in a directory. @return its output
  std::string shell(const std::string& directory, const std::string& command) const
  {
    const std::string output = directory_ / "shell_output";
    const int status = std::system(("cd '" + directory + "' && " + command + " > '" + output + "'").c_str());
    EXPECT_EQ(status, 0) << command;
    return contents(output);
  }

  nlohmann::json reportJson(const std::string& report = "s_report") const
  {
    return nlohmann::json::parse(contents(directory_ / (report + "/report.json")));
  }

  /// What the script of a report's page reads.
  nlohmann::json pageJson(const std::string& report = "s_report") const
  {
    const std::string page = contents(directory_ / (report + "/report.html"));
    const std::string start = R"(<script type="application/json" id="data">)";
    const std::size_t begin = page.find(start) + start.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  }

  ScratchDirectory directory_;
};

}  // namespace ratchet_sieve
