#pragma once

#include <cstddef>
#include <string>

#include <CLI/CLI.hpp>

#include "ratchet_sieve/page/run_page.h"

namespace ratchet_sieve
{

/// The arguments of a program that writes a run's page.
struct PageArguments
{
  std::string path;
  double megabytes = USUAL_PAGE / BYTES_PER_MB;

  bool isWanted() const { return !path.empty(); }

  std::size_t bytes() const;
};

/// Describes --html and --html-size, which are parsed into `arguments`. @return --html
CLI::Option* describe(CLI::App& app, PageArguments& arguments);

/// Describes --html-size alone. @param html its --html
void describeSize(CLI::App& app, PageArguments& arguments, CLI::Option* html);

}  // namespace ratchet_sieve
