#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ratchet_sieve/scene/input_file.h"
#include "ratchet_sieve/sweep/engine.h"

namespace ratchet_sieve
{

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
  std::ofstream list(directory + "/list");
  for (const std::string& file : files)
    list << file << '\n';
  list.close();
  if (!list)
    throw EngineError(directory + "/list: cannot be written");
  // Three attempts, each on another host as long as there is one. The rest is the caller's, who sees what is
  // missing.
  child_.start({"parallel", "--will-cite", "--sshloginfile", hosts_, "--retries", "3", "--joblog", "joblog",
                "--workdir", "...", "--transferfile", "{}", "--return", "{.}.results", "--cleanup",
                program_ + " case {}", "::::", "list"},
               directory, directory + "/log");
}

void ParallelEngine::stop()
{
  child_.signal(SIGTERM);
}

}  // namespace ratchet_sieve
