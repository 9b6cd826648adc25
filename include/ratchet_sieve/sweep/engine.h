#pragma once

#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/types.h>

namespace ratchet_sieve
{

/// An engine that cannot be started, or that comes back without results.
struct EngineError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Starts `sieve_sweep case FILE` on other machines, by a program that is there for it.
class Engine
{
public:
  virtual ~Engine() = default;

  /// @param directory that holds the files, of which the results come back into it
  /// @throws EngineError
  virtual void start(const std::string& directory, const std::vector<std::string>& files) = 0;

  /// Whether results may yet come.
  virtual bool isRunning() = 0;

  /// Ends it, and what it has started, soon.
  virtual void stop() = 0;
};

/// A program that runs in the background, its output in a file. Ends with this object.
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

/// GNU parallel over ssh: files go to the hosts and come back by rsync; a job that fails is tried on another
/// host.
class ParallelEngine : public Engine
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

/// An array of Slurm's: nodes and coordinator see the same directory and the same program.
class SlurmEngine : public Engine
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
  std::string job_;  ///< empty where none is under way
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ratchet_sieve
