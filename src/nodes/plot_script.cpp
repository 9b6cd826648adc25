#include "plot_script.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

#include "command_line.h"

namespace ratchet_sieve
{
namespace
{

/// Runs a program to its end. @return its wait status
int runScript(const std::string& program, std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments)
    argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0)
  {
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) < 0)
    throw std::runtime_error(program + ": cannot be run: " + std::strerror(errno));
  return status;
}

}  // namespace

int plotTables(const std::string& name, const std::vector<std::string>& arguments)
{
  const std::filesystem::path script = std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
  if (!std::filesystem::exists(script))
    throw std::runtime_error(script.string() + ": not there, so that nothing can be plotted");
  const int status = runScript(script.string(), arguments);
  if (!WIFEXITED(status) || (WEXITSTATUS(status) != 0 && WEXITSTATUS(status) != REFUSED))
    throw std::runtime_error(script.string() + ": failed on " + arguments.front());
  return WEXITSTATUS(status);
}

}  // namespace ratchet_sieve
