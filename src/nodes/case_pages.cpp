#include "case_pages.h"

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/canonical_scene.h"

namespace ratchet_sieve
{
namespace
{

std::string titleOf(const std::string& sweep, const SweepCase& sweep_case)
{
  std::string title = sweep + ':';
  for (const auto& [key, value] : sweep_case.values)
    if (value)
      title += ' ' + key + '=' + *value;
  return title + " seed=" + std::to_string(sweep_case.scene.seed);
}

}  // namespace

OpenRecord casePages(const PageArguments& arguments, const std::string& sweep)
{
  std::error_code error;
  std::filesystem::create_directories(arguments.path, error);
  if (error)
    throw OutputError(arguments.path + ": cannot be made: " + error.message());
  AtomicFile probe(arguments.path + "/probe");
  return [directory = arguments.path, bytes = arguments.bytes(), sweep](const SweepCase& sweep_case)
  {
    auto page = std::make_unique<RunPage>(bytes);
    const std::string path = directory + '/' + runHash(sweep_case.scene) + ".html";
    const auto keep = [&run = *page, path, title = titleOf(sweep, sweep_case)](
                          const std::vector<std::string>& warnings) { run.write(path, title, warnings); };
    return CaseRecord{std::move(page), pageRates(PAGE_RATE), keep};
  };
}

}  // namespace ratchet_sieve
