#pragma once

#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/types.h>

namespace ratchet_sieve
{

/// An engine that cannot be started or returns no results.
struct EngineError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Runs `sieve_sweep case FILE` on other machines, through an external job launcher.
class SweepEngine
{
public:
  virtual ~SweepEngine() = default;

  /// @param directory of the case files; the results are returned to it
  /// @throws EngineError
  virtual void start(const std::string& directory, const std::vector<std::string>& files) = 0;

  /// Whether more results may arrive.
  virtual bool isRunning() = 0;

  /// Stops the engine and its jobs soon.
  virtual void stop() = 0;
};

/// A program that runs in the background with its output in a file. It is terminated with this object.
class ChildProgram
{
public:
  ~ChildProgram();
  /// @throws EngineError
  void start(const std::vector<std::string>& words, const std::string& directory, const std::string& output);
  bool isRunning();
  void signal(int signal) const;

private:
  pid_t child_ = -1;
};

/// GNU parallel over ssh: files are copied to the hosts and back by rsync. A failed job is retried on another
/// host.
class ParallelEngine : public SweepEngine
{
public:
  /// @param hosts file of parallel's --sshloginfile @param program on the hosts
  ParallelEngine(const std::string& hosts, std::string program);
  void start(const std::string& directory, const std::vector<std::string>& files) override;
  bool isRunning() override { return child_.isRunning(); }
  void stop() override;

private:
  std::string hosts_;
  std::string program_;
  ChildProgram child_;
};

/// A Slurm job array: nodes and coordinator share the directory and the program.
class SlurmEngine : public SweepEngine
{
public:
  /// @param program on the nodes @param options of sbatch, such as --partition=short
  SlurmEngine(std::string program, std::vector<std::string> options);
  void start(const std::string& directory, const std::vector<std::string>& files) override;
  bool isRunning() override;
  void stop() override;

private:
  void startRequeued(const std::string& tasks);

  std::string program_;
  std::vector<std::string> options_;
  std::string job_;  ///< id of the job; empty if none is under way
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ratchet_sieve
