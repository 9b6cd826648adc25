#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "bounded_stream.h"
#include "findings.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/analysis/run_analysis.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

/// As in the bag reader, from a message's bytes.
void show(FrameKind kind, Bytes bytes, FrameSink& sink)
{
  try
  {
    forEachFrameType(
        [&](auto type)
        {
          using Frame = typename decltype(type)::Frame;
          if (kindOf<Frame>() != kind)
            return;
          MessageOf<Frame> message;
          BoundedStream(bytes).next(message);
          sink.take(toFrame(message));
        });
  }
  catch (const std::invalid_argument& error)
  {
    requireOneLine(error.what());
  }
  catch (const ros::serialization::StreamOverrunException& error)
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

void report(const RunAnalysis& analysis)
{
  try
  {
    const RunResult result = analysis.result();
    reportText(result);
    reportJson(result).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
  catch (const AnalysisError& error)
  {
    requireOneLine(error.what());
  }
}

}  // namespace
}  // namespace ratchet_sieve

/// Messages of a run one after the other: kind, length of 16 bits, and as many bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace ratchet_sieve;
  RunAnalysis analysis;
  std::size_t at = 0;
  while (at + 3 <= size)
  {
    const auto kind = static_cast<FrameKind>(bytes[at] % FRAME_KINDS);
    const std::size_t length = bytes[at + 1] + 256u * bytes[at + 2];
    at += 3;
    const std::size_t end = std::min(size, at + length);
    show(kind, Bytes(bytes + at, bytes + end), analysis);
    at = end;
  }
  report(analysis);
  return 0;
}
