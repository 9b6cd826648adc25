#include "ratchet_sieve/core/fields.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{
namespace
{

/// The position of a member within its struct.
struct Extent
{
  std::size_t begin;
  std::size_t end;
  std::size_t alignment;
};

/// The bytes of a struct that are neither in a described field nor padding between them.
template <typename Struct>
std::size_t bytesLeftOut()
{
  const Struct object;
  std::vector<Extent> extents;
  const auto add = [&](const FieldInfo&, const auto& field)
  {
    const auto begin = static_cast<std::size_t>(reinterpret_cast<const char*>(&field) -
                                                reinterpret_cast<const char*>(&object));
    extents.push_back({begin, begin + sizeof field, alignof(std::decay_t<decltype(field)>)});
  };
  Fields<Struct>::each(add, object);
  std::sort(extents.begin(), extents.end(),
            [](const Extent& a, const Extent& b) { return a.begin < b.begin; });
  extents.push_back({sizeof(Struct), sizeof(Struct), alignof(Struct)});
  std::size_t left_out = 0;
  std::size_t end = 0;
  for (const Extent& extent : extents)
  {
    const std::size_t padded = (end + extent.alignment - 1) / extent.alignment * extent.alignment;
    EXPECT_GE(extent.begin, padded) << "a field that is described twice could hide one that is missing";
    left_out += extent.begin - padded;
    end = extent.end;
  }
  return left_out;
}

TEST(FrameFields, LeaveOutNoMember)
{
  EXPECT_EQ(bytesLeftOut<SceneFrame>(), 0u);
  EXPECT_EQ(bytesLeftOut<CommandFrame>(), 0u);
  EXPECT_EQ(bytesLeftOut<DriveState>(), 0u);
  EXPECT_EQ(bytesLeftOut<BaseFrame>(), 0u);
  EXPECT_EQ(bytesLeftOut<DiskState>(), sizeof DiskState().mass) << "which is not recorded";
  EXPECT_EQ(bytesLeftOut<ParticleFrame>(), 0u);
  EXPECT_EQ(bytesLeftOut<SpeciesBins>(), 0u);
  EXPECT_EQ(bytesLeftOut<BinFrame>(), 0u);
  EXPECT_EQ(bytesLeftOut<SpeciesMeans>(), 0u);
  EXPECT_EQ(bytesLeftOut<SpeciesRow>(), 0u);
  EXPECT_EQ(bytesLeftOut<CollisionCounts>(), 0u);
  EXPECT_EQ(bytesLeftOut<CollisionRates>(), 0u);
  EXPECT_EQ(bytesLeftOut<StatisticsFrame>(), 0u);
  EXPECT_EQ(bytesLeftOut<ObservedNumber>(), 0u);
  EXPECT_EQ(bytesLeftOut<ObservedColumn>(), 0u);
  EXPECT_EQ(bytesLeftOut<ObservedRow>(), 0u);
  EXPECT_EQ(bytesLeftOut<Observed>(), 0u);
  EXPECT_EQ(bytesLeftOut<ObservedFrame>(), 0u);
}

TEST(FrameKinds, StandInTheOrderOfTheirList)
{
  std::size_t place = 0;
  forEachFrameType(
      [&](auto type)
      {
        const FrameKind kind = kindOf<typename decltype(type)::Frame>();
        EXPECT_EQ(static_cast<std::size_t>(kind), place);
        EXPECT_EQ(FRAME_LIST[place++].kind, kind);
      });
  EXPECT_EQ(place, FRAME_KINDS);
}

}  // namespace
}  // namespace ratchet_sieve
