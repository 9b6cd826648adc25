#pragma once

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "ratchet_sieve/recording/version.h"

namespace ratchet_sieve
{

/// To be called first in every program. Without descriptors 0 to 2, the next files that it opens would get
/// these numbers, and its output and log lines with them. They are filled such that writing to them is an
/// error. A file beyond the size limit is an error, as on a full disk, and does not end the program.
inline void startProcess()
{
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0)
      open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// Whether a signal has asked the run to end. Its handler sets it, which may not wait for a lock.
inline std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

inline void requestStop(int)
{
  stop_requested = true;
}

/// Attends the signals that ask a run to end: also when its terminal is closed, except under nohup. A pipe
/// that nobody reads any more is an error of the output, and does not end the run.
inline void attendSignals()
{
  std::signal(SIGINT, requestStop);
  std::signal(SIGTERM, requestStop);
  if (std::signal(SIGHUP, SIG_IGN) != SIG_IGN)
    std::signal(SIGHUP, requestStop);
  std::signal(SIGPIPE, SIG_IGN);
}

/// Longest line of tables, and of help at most [characters].
constexpr std::size_t TEXT_WIDTH = 110;

/// Longest line of help: $COLUMNS, or the terminal's, or 80 [characters].
inline std::size_t helpWidth()
{
  winsize terminal = {};
  std::size_t width = 80;
  if (const char* columns = std::getenv("COLUMNS"))
    width = std::strtoul(columns, nullptr, 10);
  else if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &terminal) == 0 && terminal.ws_col > 0)
    width = terminal.ws_col;
  return std::clamp(width, std::size_t{60}, TEXT_WIDTH);
}

/// Lines of at most `width` characters, each indented. No word is broken.
inline std::string wrappedText(const std::string& text, std::size_t indent, std::size_t width = TEXT_WIDTH)
{
  std::string lines;
  std::size_t begin = 0;
  while (begin < text.size())
  {
    std::size_t end = text.size();
    if (end - begin > width - indent)
      end = text.rfind(' ', begin + width - indent);
    if (end == std::string::npos || end <= begin)
      end = std::min(text.find(' ', begin), text.size());
    lines += std::string(indent, ' ') + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return lines;
}

/// A help text whose lines have names, two spaces or more and a description, within helpWidth().
inline std::string fittedHelp(const std::string& help)
{
  std::string fitted;
  std::size_t begin = 0;
  for (std::size_t end; (end = help.find('\n', begin)) != std::string::npos; begin = end + 1)
  {
    const std::string line = help.substr(begin, end - begin);
    const std::size_t gap = line.rfind("  ");
    const std::size_t indent = gap == std::string::npos ? 0 : gap + 2;
    std::string lines = wrappedText(line.substr(indent), indent, helpWidth());
    fitted += lines.empty() ? "\n" : lines.replace(0, indent, line, 0, indent);
  }
  return fitted;
}

/// Flushes standard output after each log line, also into a pipe or a file. To be called before any output.
inline void writeLogByLines()
{
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
}

/// Starts the process (startProcess()) and answers --help and --version. To be called before the node looks
/// for a master, which may be missing. @return whether one of them was given
inline bool answerOptions(int argc, char** argv, const char* program, const char* help)
{
  startProcess();
  for (int k = 1; k < argc; ++k)
  {
    if (std::strcmp(argv[k], "--help") == 0 || std::strcmp(argv[k], "-h") == 0)
    {
      std::fputs(fittedHelp(help).c_str(), stdout);
      return true;
    }
    if (std::strcmp(argv[k], "--version") == 0)
    {
      std::printf("%s %s\n", program, version());
      return true;
    }
  }
  return false;
}

}  // namespace ratchet_sieve
