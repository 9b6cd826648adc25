#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "quoted_word.h"
#include "ratchet_sieve/scene/input_file.h"
#include "ratchet_sieve/sweep/engine.h"

namespace ratchet_sieve
{
namespace
{

/// Replaces ssh for this machine: runs the command in the run's directory, because the home may be read-only.
/// Sets SHELL, as sshd does, because parallel's wrapper of a job starts that shell; without one the job ends
/// in silence.
constexpr const char* LOCAL_SHELL = R"(# sh local_shell HOST [--] COMMAND...
shift
[ "$1" = -- ] && shift
export SHELL=/bin/sh
exec sh -c "$*"
)";

void write(const std::string& path, const std::string& text)
{
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file)
    throw EngineError(path + ": cannot be written");
}

/// The host as given, except `:`, this machine, to which parallel transfers no files: it becomes a host with
/// its own remote shell.
std::string hostText(std::string host)
{
  host.erase(host.find_last_not_of(" \t\r") + 1);
  const std::size_t colon = host.size() - 1;
  const bool is_here = host == ":" || (host.size() > 1 && host.compare(colon - 1, 2, "/:") == 0);
  return is_here ? host.substr(0, colon) + "sh ./local_shell localhost" : host;
}

std::string hostsText(const std::string& path)
{
  std::ifstream file(path);
  std::string text;
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream hosts(line);
    const char* between = "";
    for (std::string host; std::getline(hosts, host, ','); between = ",")
      text += between + hostText(host);
    text += '\n';
  }
  return text;
}

/// Quoted for the host's shell, and without parallel's replacement strings, such as {}.
std::string programWord(const std::string& program)
{
  return replaced(quotedWord(program), '{', "{''");
}

}  // namespace

void ChildProgram::start(const std::vector<std::string>& words, const std::string& directory,
                         const std::string& output)
{
  std::vector<std::string> copies = words;
  std::vector<char*> argv;
  argv.reserve(copies.size() + 1);
  for (std::string& word : copies)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  child_ = fork();
  if (child_ < 0)
    throw EngineError(words.front() + ": cannot be run: " + std::strerror(errno));
  if (child_ > 0)
    return;
  setpgid(0, 0);
  const int log = open(output.c_str(), O_CREAT | O_APPEND | O_WRONLY, 0644);
  const int nothing = open("/dev/null", O_RDONLY);
  if (log < 0 || nothing < 0 || dup2(nothing, 0) < 0 || dup2(log, 1) < 0 || dup2(log, 2) < 0 ||
      chdir(directory.c_str()) != 0)
    _exit(126);
  execvp(argv[0], argv.data());
  _exit(127);
}

bool ChildProgram::isRunning()
{
  int status = 0;
  if (child_ < 0 || waitpid(child_, &status, WNOHANG) == 0)
    return child_ > 0;
  child_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    throw EngineError("the engine's program is not installed");
  return false;
}

void ChildProgram::signal(int signal) const
{
  if (child_ > 0)
    kill(-child_, signal);
}

ChildProgram::~ChildProgram()
{
  signal(SIGKILL);
  if (child_ > 0)
    waitpid(child_, nullptr, 0);
}

ParallelEngine::ParallelEngine(const std::string& hosts, std::string program)
    : hosts_(std::filesystem::absolute(hosts).string()), program_(std::move(program))
{
  if (const auto why = whyUnreadable(hosts_))
    throw EngineError(hosts + ": " + *why);
}

void ParallelEngine::start(const std::string& directory, const std::vector<std::string>& files)
{
  std::string list;
  for (const std::string& file : files)
    list += file + '\n';
  write(directory + "/list", list);
  write(directory + "/local_shell", LOCAL_SHELL);
  write(directory + "/hosts", hostsText(hosts_));
  // Three attempts, each on another host if possible. The caller handles cases that are still missing.
  child_.start({"parallel", "--will-cite", "--sshloginfile", "hosts", "--retries", "3", "--joblog", "joblog",
                "--workdir", "...", "--transferfile", "{}", "--return", "{.}.results", "--cleanup",
                programWord(program_) + " case {}", "::::", "list"},
               directory, directory + "/log");
}

void ParallelEngine::stop()
{
  child_.signal(SIGTERM);
}

}  // namespace ratchet_sieve
