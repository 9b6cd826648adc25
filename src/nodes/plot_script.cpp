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

/// The system's Python, which has matplotlib, as in the first lines of the scripts. The copies in the build
/// tree are not executable.
constexpr const char* PYTHON = "/usr/bin/python3";

/// Runs a script to its end. @return its wait status
int runScript(const std::string& script, std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), {PYTHON, script});
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments)
    argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0)
  {
    execv(PYTHON, argv.data());
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) < 0)
    throw std::runtime_error(script + ": cannot be run: " + std::strerror(errno));
  return status;
}

}  // namespace

int plotTables(const std::string& name, const std::vector<std::string>& arguments)
{
  const std::filesystem::path script = std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
  if (!std::filesystem::exists(script))
    throw std::runtime_error(script.string() + ": no such file; nothing is plotted");
  const int status = runScript(script.string(), arguments);
  if (!WIFEXITED(status) || WEXITSTATUS(status) > REFUSED)
    throw std::runtime_error(script.string() + ": failed on " + arguments.front());
  return WEXITSTATUS(status);  // the script has printed the error
}

}  // namespace ratchet_sieve
