#include "python_plots.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command_line.h"

namespace ratchet_sieve
{
namespace
{

/// The system's Python, which has pandas.
constexpr const char* PYTHON = "/usr/bin/python3";

/// Says in one line what is missing, as matplotlib, which is recommended only. Imports nothing of the working
/// directory: a random.py there is the user's.
constexpr const char* RUN =
    "import sys; sys.path[:] = filter(None, sys.path); "
    "from ratchet_sieve.recommended import run; run(sys.argv.pop(1))";

/// Where Python finds the package, from this program's directory: in the devel and the install space; in a
/// build tree without ROS.
constexpr const char* PYTHON_DIRECTORIES[] = {RATCHET_SIEVE_PYTHON_FROM_PROGRAMS, "../../python"};

std::filesystem::path pythonDirectory()
{
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const char* directory : PYTHON_DIRECTORIES)
    if (std::filesystem::exists(here / directory / "ratchet_sieve/__init__.py"))
      return (here / directory).lexically_normal();
  throw std::runtime_error((here / PYTHON_DIRECTORIES[0]).lexically_normal().string() +
                           ": has no Python package ratchet_sieve; nothing is plotted");
}

/// Runs a module to its end. @return its wait status
int runModule(const std::string& module, std::vector<std::string> arguments)
{
  const char* others = std::getenv("PYTHONPATH");
  const std::string path =
      pythonDirectory().string() + (others != nullptr && *others != '\0' ? ":" + std::string(others) : "");
  arguments.insert(arguments.begin(), {PYTHON, "-c", RUN, module});
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments)
    argv.push_back(argument.data());
  argv.push_back(nullptr);
  setenv("PYTHONPATH", path.c_str(), 1);
  setenv("PYTHONIOENCODING", ":surrogateescape", 1);  // paths are printed byte by byte
  const pid_t child = fork();
  if (child == 0)
  {
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // it ends with this program, whatever ends that
    execv(PYTHON, argv.data());
    std::perror(PYTHON);
    _exit(FAILED);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) < 0)
    throw std::runtime_error(module + ": cannot be run: " + std::strerror(errno));
  return status;
}

}  // namespace

int plotTables(const std::string& module, const std::vector<std::string>& arguments)
{
  const int status = runModule(module, arguments);
  if (!WIFEXITED(status) || WEXITSTATUS(status) > REFUSED)
    throw std::runtime_error(module + ": failed on " + arguments.front());
  return WEXITSTATUS(status);  // the module has printed the error
}

}  // namespace ratchet_sieve
