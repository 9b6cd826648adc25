#include "frame_rules.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "ratchet_sieve/analysis/run_analysis.h"
#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

/// Further than any disk moves in the longest run (10^9 s) at the highest speed of a scene (10^4 m/s), and
/// small enough that products of two displacements do not overflow [m].
constexpr double FARTHEST = 1e15;

/// Disks have ids of 32 bits.
constexpr std::uint64_t MOST_IDS = std::numeric_limits<std::uint32_t>::max();

template <typename Frame>
std::string describeFrame()
{
  return std::string("a frame of ") + describe(kindOf<Frame>()).name;
}

template <typename Frame>
void requireSpecies(std::size_t count, const SceneDefinition& scene)
{
  if (count != scene.species.size())
    throw AnalysisError(fmt::format("{} with {} species does not fit the scene, which has {}",
                                    describeFrame<Frame>(), count, scene.species.size()));
}

/// The name of a field with a number that is not finite; null if there is none.
template <typename T>
const char* notFinite(const char* name, const T& value)
{
  if constexpr (std::is_floating_point_v<T>)
    return std::isfinite(value) ? nullptr : name;
  else if constexpr (IS_OPTIONAL<T>)
    return value ? notFinite(name, *value) : nullptr;
  else if constexpr (IS_VECTOR<T>)
  {
    const char* found = nullptr;
    for (auto element = value.begin(); found == nullptr && element != value.end(); ++element)
      found = notFinite(name, *element);
    return found;
  }
  else if constexpr (IS_DESCRIBED<T>)
  {
    const char* found = nullptr;
    Fields<T>::each(
        [&found](const FieldInfo& field, const auto& of)
        {
          if (found == nullptr)
            found = notFinite(field.name, of);
        },
        value);
    return found;
  }
  else
    return nullptr;
}

void requireFit(const BaseFrame&, const SceneDefinition&) {}

void requireFit(const ParticleFrame& frame, const SceneDefinition& scene)
{
  for (const DiskState& disk : frame.disks)
  {
    if (disk.species >= scene.species.size())
      throw AnalysisError(fmt::format("disk {} at {} s has species {}, and the scene {} of them", disk.id,
                                      frame.time, disk.species, scene.species.size()));
    if (!(std::abs(disk.displacement) <= FARTHEST))
      throw AnalysisError(
          fmt::format("disk {} at {} s has a displacement of {} m", disk.id, frame.time, disk.displacement));
  }
}

void requireFit(const BinFrame& frame, const SceneDefinition& scene)
{
  requireSpecies<BinFrame>(frame.bins.size(), scene);
  for (const SpeciesBins& bins : frame.bins)
    if (bins.left > MOST_IDS || bins.right > MOST_IDS || bins.on_base > MOST_IDS)
      throw AnalysisError(fmt::format("{} at {} s counts more disks than there can be",
                                      describeFrame<BinFrame>(), frame.time));
}

void requireFit(const StatisticsFrame& frame, const SceneDefinition& scene)
{
  requireSpecies<StatisticsFrame>(frame.species.size(), scene);
  const std::size_t faces = scene.base.isSawtooth() ? 0 : scene.base.outline().size() - 1;
  if (frame.faces.face_contacts.size() != faces || frame.faces.corner_contacts.size() != faces)
    throw AnalysisError(fmt::format(
        "{} at {} s counts contacts with {} faces and {} corners, not {}", describeFrame<StatisticsFrame>(),
        frame.time, frame.faces.face_contacts.size(), frame.faces.corner_contacts.size(), faces));
}

/// Names become names of files.
void requireFit(const ObservedFrame& frame, const SceneDefinition& scene)
{
  const auto refuse = [&](const std::string& what)
  {
    throw AnalysisError(fmt::format("{} at {} s does not fit the scene: {}", describeFrame<ObservedFrame>(),
                                    frame.time, what));
  };
  const auto known = [](const auto& names, const std::string& name)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  std::vector<std::string> names = scene.observe;
  names.emplace_back(SIZE_CLASSES);
  for (const Observed& observed : frame.observed)
  {
    if (!known(names, observed.name))
      refuse("it does not observe " + shownText(observed.name));
    for (const ObservedRow& row : observed.rows)
    {
      if (!known(speciesNames(scene), row.species))
        refuse("it has no species " + shownText(row.species));
      if (!known(std::vector<std::string>{"", "left", "right"}, row.place))
        refuse("it has no place " + shownText(row.place));
      for (const ObservedColumn& column : row.table)
        if (column.values.size() != row.table.front().values.size() ||
            row.table.size() != observed.rows.front().table.size())
          refuse("columns of " + observed.name + " differ in length");
    }
  }
}

}  // namespace

template <typename Frame>
void requireSound(const Frame& frame, const SceneDefinition& scene)
{
  requireFit(frame, scene);
  if (const char* field = notFinite("", frame))
    throw AnalysisError(fmt::format("{} at {} s holds a number that is not finite: {}",
                                    describeFrame<Frame>(), frame.time, field));
}

template void requireSound(const BaseFrame&, const SceneDefinition&);
template void requireSound(const ParticleFrame&, const SceneDefinition&);
template void requireSound(const BinFrame&, const SceneDefinition&);
template void requireSound(const StatisticsFrame&, const SceneDefinition&);
template void requireSound(const ObservedFrame&, const SceneDefinition&);

}  // namespace ratchet_sieve
