#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "process_start.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/shown_text.h"

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

/// What `make` returns. Its errors of this type refuse the arguments. @param where begins their lines
template <typename Error, typename Make>
auto orRefuse(const Make& make, const std::string& where = "")
{
  try
  {
    return make();
  }
  catch (const Error& error)
  {
    throw Refusal(where + error.what());
  }
}

/// The check of a number. That of CLI11 names a limit with all its digits.
inline auto within(double least, double most, const char* unit)
{
  return [=](const std::string& text)
  {
    const double number = std::strtod(text.c_str(), nullptr);
    return number >= least && number <= most
               ? std::string()
               : fmt::format("{}: must be a number from {:g} to {:g} {}", text, least, most, unit);
  };
}

/// Prints text, which is a program's result. @throws OutputError if it could not be printed in full, as on a
/// full disk
inline void print(const std::string& text)
{
  const bool printed = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  const char* reason = std::strerror(errno);
  std::clearerr(stdout);
  if (!printed)
    failToWrite("standard output", reason);
}

/// The status, once all that was printed through std::cout is out. @throws OutputError if it is not
inline int whenPrinted(int status)
{
  if (std::cout.flush())
    return status;
  print("\n");  // once more, for the reason
  failToWrite("standard output", "it was not written completely");
}

/// Prints one error line. @return the status
inline int complain(const CLI::App& app, const std::string& what, int status)
{
  std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), what.c_str());
  return status;
}

/// Writes the outputs of a program one after the other. One that fails is reported on standard error, and the
/// others are written all the same.
class OutputAttempts
{
public:
  /// @param program its name in error lines
  explicit OutputAttempts(const char* program) : program_(program) {}

  template <typename Write>
  void attempt(const Write& write)
  {
    try
    {
      write();
    }
    catch (const std::exception& error)
    {
      std::fprintf(stderr, "%s: %s\n", program_, errorText(error).c_str());
      complete_ = false;
    }
  }

  /// Whether none has failed.
  bool complete() const { return complete_; }

private:
  const char* program_;
  bool complete_ = true;
};

/// Help within helpWidth(): an option's name and argument on the left, its description, ended by the default,
/// on the right.
class HelpFormat : public CLI::Formatter
{
public:
  HelpFormat() { column_width(NAMES_WIDTH); }

  std::string make_option(const CLI::Option* option, bool is_positional) const override
  {
    // Behind a colon CLI11 describes the check of the value.
    const std::string type = option->get_type_name().substr(0, option->get_type_name().find(':'));
    std::string names = "  " + make_option_name(option, is_positional);
    if (option->get_type_size() != 0 && !is_positional)
      names += " " + type;
    std::string text = option->get_description();
    if (!option->get_default_str().empty())
      text += " (default: " + option->get_default_str() + ")";
    return row(names, text);
  }

  std::string make_subcommand(const CLI::App* command) const override
  {
    return row("  " + command->get_name(), command->get_description());
  }

  std::string make_description(const CLI::App* app) const override
  {
    return wrappedText(app->get_description(), 0, helpWidth());
  }

  std::string make_footer(const CLI::App* app) const override
  {
    return wrappedText(app->get_footer(), 0, helpWidth());
  }

private:
  static constexpr std::size_t NAMES_WIDTH = 26;

  static std::string row(const std::string& names, const std::string& text)
  {
    std::string lines = wrappedText(text, NAMES_WIDTH, helpWidth());
    return names.size() + 2 > NAMES_WIDTH ? names + "\n" + lines : lines.replace(0, names.size(), names);
  }
};

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
    try
    {
      app.parse(argc, argv);
      return whenPrinted(program());
    }
    catch (const CLI::Success& request)
    {
      return whenPrinted(app.exit(request));
    }
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
    return complain(app, errorText(error), FAILED);
  }
}

}  // namespace ratchet_sieve
