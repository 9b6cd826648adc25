#pragma once

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ros/master.h>

namespace ratchet_sieve
{

/// A port that is free at present.
inline int freePort()
{
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  if (bind(listener, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size) != 0)
    throw std::runtime_error("no free port");
  close(listener);
  return ntohs(address.sin_port);
}

/// A ROS master started by the test, which can kill it. From construction on, this process and its children
/// use it, whether it runs or not.
class OwnMaster
{
public:
  OwnMaster() : port_(std::to_string(freePort()))
  {
    setenv("ROS_MASTER_URI", ("http://localhost:" + port_).c_str(), 1);
    setenv("ROS_HOSTNAME", "localhost", 1);
    unsetenv("ROS_IP");
  }
  ~OwnMaster() { kill(); }
  OwnMaster(const OwnMaster&) = delete;
  OwnMaster& operator=(const OwnMaster&) = delete;

  void start()
  {
    process_ = fork();
    if (process_ != 0)
      return;
    execlp("rosmaster", "rosmaster", "--core", "-p", port_.c_str(), nullptr);
    _exit(127);
  }

  /// As in a crash.
  void kill()
  {
    if (process_ > 0)
    {
      ::kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    process_ = -1;
  }

private:
  std::string port_;
  pid_t process_ = -1;
};

}  // namespace ratchet_sieve
