#pragma once

#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "help_format.h"
#include "process_start.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/version.h"

namespace ratchet_sieve
{

// Exit status.
constexpr int DONE = 0;
constexpr int FAILED = 1;
constexpr int REFUSED = 2;

/// Bad arguments or a bad scene; nothing was written.
struct Refusal : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Prints one error line. @return the status
inline int complain(const CLI::App& app, const std::string& what, int status)
{
  std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), what.c_str());
  return status;
}

/// Gives the program and its subcommands --help, --version, the format of their help and the footer.
inline void describeHelp(CLI::App& app)
{
  app.set_version_flag("--version", app.get_name() + " " + version(), "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.formatter(std::make_shared<HelpFormat>());
  for (CLI::App* command : app.get_subcommands(nullptr))
  {
    command->set_help_flag("-h,--help", "Print this help and exit");
    command->formatter(app.get_formatter());
    command->footer(app.get_footer());
  }
}

/// Parses the arguments that `app` describes, --help and --version, and runs the program. Every exception
/// becomes an error line. @return the exit status
inline int runProgram(CLI::App& app, int argc, char** argv, const std::function<int()>& program)
{
  startProcess();
  describeHelp(app);
  try
  {
    app.parse(argc, argv);
    return program();
  }
  catch (const CLI::Success& request)
  {
    return app.exit(request);
  }
  catch (const CLI::Error& error)
  {
    return complain(app, std::string(error.what()) + "; see --help", REFUSED);
  }
  catch (const Refusal& error)
  {
    return complain(app, error.what(), REFUSED);
  }
  catch (const SameFileError& error)
  {
    return complain(app, error.what(), REFUSED);
  }
  catch (const std::exception& error)
  {
    return complain(app, error.what(), FAILED);
  }
}

}  // namespace ratchet_sieve
