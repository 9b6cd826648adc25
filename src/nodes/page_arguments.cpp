#include "page_arguments.h"

#include "command_line.h"

namespace ratchet_sieve
{

std::size_t PageArguments::bytes() const
{
  return static_cast<std::size_t>(BYTES_PER_MB * megabytes);
}

CLI::Option* describe(CLI::App& app, PageArguments& arguments)
{
  CLI::Option* html =
      app.add_option(
             "--html", arguments.path,
             "Write the run as one HTML file, which any browser shows: the machine in motion, curves, "
             "results, and where they come from")
          ->type_name("FILE");
  describeSize(app, arguments, html);
  return html;
}

void describeSize(CLI::App& app, PageArguments& arguments, CLI::Option* html)
{
  app.add_option(
         "--html-size", arguments.megabytes,
         "Size of such a file at most [MB]: the motion is thinned to it, or ends before the run. Until "
         "then it takes up to ten times as much memory")
      ->type_name("MB")
      ->needs(html)
      ->check(within(SMALLEST_PAGE / BYTES_PER_MB, LARGEST_PAGE / BYTES_PER_MB, "MB"))
      ->capture_default_str();
}

}  // namespace ratchet_sieve
