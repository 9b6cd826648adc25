#pragma once

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

namespace ratchet_sieve
{

/// A program of this package that runs during the test, with its standard error captured. Terminated with the
/// test.
class ChildNode
{
public:
  explicit ChildNode(const std::string& program, const std::vector<std::string>& arguments = {})
  {
    // All programs of a package are in one folder.
    const std::string path = std::filesystem::read_symlink("/proc/self/exe").parent_path() / program;
    if (pipe(errors_.data()) != 0)
      throw std::runtime_error("no pipe");
    // Nobody reads before the program ends, so its output must not block it.
    fcntl(errors_[1], F_SETPIPE_SZ, 1 << 20);
    process_ = fork();
    if (process_ == 0)
      become(path, arguments);
    close(errors_[1]);
  }

  ~ChildNode()
  {
    if (process_ > 0)
    {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    close(errors_[0]);
  }
  ChildNode(const ChildNode&) = delete;
  ChildNode& operator=(const ChildNode&) = delete;

  void interrupt(int signal = SIGINT) { kill(process_, signal); }

  /// Like a crash, or like the kernel when memory is exhausted.
  void killAtOnce() { kill(process_, SIGKILL); }

  bool running() const
  {
    siginfo_t ended{};
    return waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == 0;
  }

  pid_t process() const { return process_; }

  /// Waits until it ends. @return its exit status; -1 after a signal
  int wait()
  {
    std::array<char, 4096> chunk{};
    while (const auto got = std::max<ssize_t>(read(errors_[0], chunk.data(), chunk.size()), 0))
      errors_text_.append(chunk.data(), static_cast<std::size_t>(got));
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Its standard error, after wait().
  const std::string& errors() const { return errors_text_; }

private:
  [[noreturn]] void become(const std::string& path, const std::vector<std::string>& arguments)
  {
    dup2(errors_[1], STDERR_FILENO);
    close(errors_[0]);
    close(errors_[1]);
    std::signal(SIGXFSZ, SIG_DFL);  // ignored by a FileSizeLimit of the test
    std::vector<char*> argv = {const_cast<char*>(path.c_str())};
    for (const std::string& argument : arguments)
      argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    signal(SIGHUP, SIG_DFL);  // also where the tests themselves run under nohup
    execv(path.c_str(), argv.data());
    _exit(127);
  }

  pid_t process_ = -1;
  std::array<int, 2> errors_{};
  std::string errors_text_;
};

}  // namespace ratchet_sieve
