#include <cstddef>
#include <cstdint>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "findings.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/analysis/run_analysis.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

/// A file in memory, rewritten with every input.
class MemoryFile
{
public:
  const std::string& filledWith(const std::uint8_t* bytes, std::size_t size)
  {
    if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, bytes, size, 0) != static_cast<ssize_t>(size))
      finding("no memory for the file", path_);
    return path_;
  }

private:
  int descriptor_ = memfd_create("run.bag", 0);
  std::string path_ = "/proc/self/fd/" + std::to_string(descriptor_);
};

void analyze(const std::string& path)
{
  try
  {
    RunAnalysis analysis;
    readBag(path, analysis);
    const RunResult result = analysis.result();
    reportText(result);
    reportJson(result).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
  catch (const BagError& error)
  {
    requireOneLine(error.what());
  }
  catch (const SceneError& error)
  {
    requireOneLine(error.what());
  }
  catch (const AnalysisError& error)
  {
    requireOneLine(error.what());
  }
}

}  // namespace
}  // namespace ratchet_sieve

/// The bytes of a bag.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static ratchet_sieve::MemoryFile file;
  ratchet_sieve::analyze(file.filledWith(bytes, size));
  return 0;
}
