#pragma once

#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "ratchet_sieve/recording/version.h"

namespace ratchet_sieve
{

// Exit status.
constexpr int DONE = 0;
constexpr int FAILED = 1;
constexpr int REFUSED = 2;

/// Bad arguments or a bad scene: nothing was written.
struct Refusal : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Says what is wrong in one line.
inline int complain(const CLI::App& app, const std::string& what, int status)
{
  std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), what.c_str());
  return status;
}

/// Parses the arguments into what `app` describes and --version, runs the program, and lets no exception out.
/// @return the exit status
inline int runProgram(CLI::App& app, int argc, char** argv, const std::function<int()>& program)
{
  app.set_version_flag("--version", app.get_name() + " " + version());
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
  catch (const std::exception& error)
  {
    return complain(app, error.what(), FAILED);
  }
}

}  // namespace ratchet_sieve
