#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>

#include <sys/wait.h>

#include "quoted_word.h"
#include "ratchet_sieve/sweep/engine.h"

namespace ratchet_sieve
{
namespace
{

/// Interval between queries to Slurm, which serves others as well.
constexpr auto BETWEEN_QUESTIONS = std::chrono::seconds(1);

struct Answer
{
  int status = -1;
  std::string text;  ///< standard output and error
};

Answer ask(const std::vector<std::string>& words)
{
  std::string command;
  for (const std::string& word : words)
    command += quotedWord(word) + ' ';
  FILE* pipe = popen((command + "2>&1").c_str(), "r");
  if (pipe == nullptr)
    throw EngineError(words.front() + ": cannot be run");
  Answer answer;
  std::array<char, 4096> part{};
  for (std::size_t size = 0; (size = fread(part.data(), 1, part.size(), pipe)) > 0;)
    answer.text.append(part.data(), size);
  const int status = pclose(pipe);
  answer.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return answer;
}

}  // namespace

SlurmEngine::SlurmEngine(std::string program, std::vector<std::string> options)
    : program_(std::move(program)), options_(std::move(options))
{
}

void SlurmEngine::start(const std::string& directory, const std::vector<std::string>& files)
{
  std::vector<std::string> words = {"sbatch", "--parsable", "--requeue", "--open-mode=append",
                                    "--job-name=sieve_sweep"};
  words.insert(words.end(), options_.begin(), options_.end());
  words.insert(words.end(),
               {"--array=0-" + std::to_string(files.size() - 1), "--chdir=" + directory,
                "--output=" + replaced(directory, '%', "%%") + "/log",
                "--wrap=exec " + quotedWord(program_) + " case $(printf %04d.case $SLURM_ARRAY_TASK_ID)"});
  const Answer answer = ask(words);
  job_ = answer.text.substr(0, answer.text.find_first_not_of("0123456789"));
  if (answer.status != 0 || job_.empty())
    throw EngineError("sbatch: " + answer.text.substr(0, answer.text.find('\n')));
}

bool SlurmEngine::isRunning()
{
  const auto now = std::chrono::steady_clock::now();
  if (job_.empty() || now < next_)
    return !job_.empty();
  next_ = now + BETWEEN_QUESTIONS;
  const Answer answer = ask({"squeue", "--noheader", "--jobs=" + job_, "--format=%i %t %r"});
  // If the controller does not answer for a while, the job is assumed to exist.
  if (answer.status != 0 && answer.text.find("Invalid job id") == std::string::npos)
    return true;
  if (answer.status != 0 || answer.text.empty())
    job_.clear();
  else
    startRequeued(answer.text);
  return !job_.empty();
}

/// Starts tasks at once whose node was lost: Slurm holds them for two minutes, although other nodes may be
/// idle.
void SlurmEngine::startRequeued(const std::string& tasks)
{
  std::istringstream lines(tasks);
  std::string task;
  std::string state;
  std::string reason;
  while (lines >> task >> state && std::getline(lines, reason))
    if (reason == " BeginTime")
      ask({"scontrol", "update", "jobid=" + task, "StartTime=now"});
}

void SlurmEngine::stop()
{
  if (!job_.empty())
    ask({"scancel", job_});
}

}  // namespace ratchet_sieve
