#include "plot_script.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace ratchet_sieve
{
namespace
{

/// Runs a program to its end. @return its wait status
int runProgram(const std::string& program, const std::string& argument)
{
  const pid_t child = fork();
  if (child == 0)
  {
    execl(program.c_str(), program.c_str(), argument.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) < 0)
    throw std::runtime_error(program + ": cannot be run: " + std::strerror(errno));
  return status;
}

}  // namespace

void plotTables(const std::string& directory)
{
  const std::filesystem::path script =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "plot_analysis.py";
  if (!std::filesystem::exists(script))
    throw std::runtime_error(script.string() + ": not there, so that nothing can be plotted");
  const int status = runProgram(script.string(), directory);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(script.string() + ": failed on " + directory);
}

}  // namespace ratchet_sieve
