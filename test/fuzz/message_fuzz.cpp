#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "display.h"
#include "findings.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/live/setpoint.h"
#include "ratchet_sieve/page/run_page.h"
#include "ratchet_sieve/recording/resimulation.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "scene_markers.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* SCENE = R"(
base: {teeth: 2, inclination: 0.1}
boundary: open
species:
  - {name: A, count: 2, radius: 0.001, mass: 0.010}
  - {name: B, count: 1, radius: 0.002, mass: 0.001, size: {distribution: uniform, spread: 0.2}}
observe: [residence_times]
duration: 1.0
)";

constexpr double MOMENT = 0.02;           // of a run [s]; a few contacts
constexpr std::uint32_t FEW = 20;         // disks
constexpr std::size_t MOST_DRAWN = 5000;  // corners

/// roscpp makes room for as many elements as a message announces: here for no more than bytes follow.
struct Stream : ros::serialization::IStream
{
  using IStream::IStream;

  template <typename Value>
  void next(Value& value)
  {
    ros::serialization::deserialize(*this, value);
  }

  template <typename Value>
  void next(std::vector<Value>& values)
  {
    std::uint32_t length = 0;
    if (getLength() >= sizeof length)
      std::memcpy(&length, getData(), sizeof length);
    if (length > getLength())
      ros::serialization::throwStreamOverrun();
    ros::serialization::deserialize(*this, values);
  }
};

/// @return whether there was no error
template <typename Act>
bool succeeds(const Act& act)
{
  try
  {
    act();
    return true;
  }
  catch (const std::runtime_error& error)  // SceneError, AnalysisError, a message that ends too early
  {
    requireOneLine(error.what());
  }
  catch (const std::invalid_argument& error)
  {
    requireOneLine(error.what());
  }
  return false;
}

/// Whether a node would take this command, for few disks.
bool isUsual(const CommandFrame& command)
{
  const auto quantity = setpointQuantity(command.kind);
  if (!quantity || command.values.empty())
    return command.count <= FEW;
  const auto refusal = usualSetpoints()[indexOf(*quantity)].refusal(command.values[0]);
  requireOneLine(refusal.value_or("taken"));
  return !refusal;
}

void draw(const RunMirror& mirror)
{
  const Picture picture = mirror.picture();
  const BaseDefinition& base = picture.scene.base;
  if (static_cast<std::size_t>(base.teeth) * base.outline().size() > MOST_DRAWN)
    return;
  pictureMarkers(picture);
  if (picture.particles)
    particleCloud(*picture.particles, picture.scene.species, WORLD_FRAME_ID);
}

/// All that reads the frames of a run: a display, sieve_analyze, sieve_resimulate. The last two end with the
/// first error. The run that is repeated is always that of SCENE, for a moment.
class Readers
{
public:
  Readers()
  {
    const SceneFrame scene = makeSceneFrame(Simulation(sceneFromText(SCENE, "scene").definition));
    take(scene);
    repeat_->take(scene);
  }

  template <typename Frame>
  void take(const Frame& frame)
  {
    mirror_.take(frame);
    requireOneLine(mirror_.sceneError().value_or("read"));
    if (mirror_.time())
      draw(mirror_);
    attempt(page_, [&] { page_->take(frame); });
    bool repeated = frame.time <= MOMENT && !std::is_same_v<Frame, SceneFrame>;
    if constexpr (std::is_same_v<Frame, CommandFrame>)
      repeated = repeated && isUsual(frame);
    if (repeated)
      attempt(repeat_, [&] { repeat_->take(frame); });
  }

  /// @param with_page takes the longest
  void finish(bool with_page)
  {
    static const std::string directory = std::filesystem::temp_directory_path() / "message_fuzz";
    attempt(repeat_, [&] { repeat_->finish(); });
    attempt(page_,
            [&]
            {
              const RunResult result = page_->analysis().result();
              reportText(result);
              reportJson(result);
              writeTables(result, directory);
              if (with_page)
                page_->write(directory + "/page.html", "fuzz", nlohmann::ordered_json::object());
            });
  }

private:
  template <typename Reader, typename Act>
  void attempt(std::optional<Reader>& reader, const Act& act)
  {
    if (reader && !succeeds(act))
      reader.reset();
  }

  RunMirror mirror_;
  std::optional<RunPage> page_{std::in_place, SMALLEST_PAGE};
  std::optional<Resimulation> repeat_{std::in_place};
};

/// Takes a message of a kind as the reader of bags and the display do.
void take(std::size_t kind, Stream& stream, Readers& readers)
{
  const auto take_if_meant = [&](auto type)
  {
    using Frame = typename decltype(type)::Frame;
    if (kindOf<Frame>() != static_cast<FrameKind>(kind))
      return;
    MessageOf<Frame> message;
    stream.next(message);
    const Frame frame = toFrame(message);
    if (!isStamp(frame.time))
      return;
    if (!sameBits(toFrame(toMessage(frame)), frame))
      finding("a frame comes back as another one", describe(kindOf<Frame>()).name);
    readers.take(frame);
  };
  forEachFrameType(take_if_meant);
}

}  // namespace
}  // namespace ratchet_sieve

/// Messages, each after its FrameKind (a byte) and its length (two bytes).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace ratchet_sieve;
  constexpr std::size_t HEAD = 3;
  std::vector<std::uint8_t> input(bytes, bytes + size);
  Readers readers;
  for (std::size_t place = 0; place + HEAD <= size;)
  {
    const std::uint8_t* head = &input[place];
    place += HEAD;
    const std::size_t length = std::min<std::size_t>(head[1] + 256U * head[2], size - place);
    Stream stream(input.data() + place, static_cast<std::uint32_t>(length));
    succeeds([&] { take(head[0] % FRAME_KINDS, stream, readers); });
    place += length;
  }
  readers.finish(size % 8 == 0);
  return 0;
}
