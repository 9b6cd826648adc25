#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "ratchet_sieve/recording/frames.h"

/// The list of all kinds of frames, which sampling, topics, bags and rates use; and who takes frames.
namespace ratchet_sieve
{

/// In the order in which frames of the same time are handed on.
enum class FrameKind
{
  SCENE,
  COMMANDS,
  BASE,
  PARTICLES,
  BINS,
  STATISTICS,
  OBSERVED
};

/// A pointer to a frame of any kind, in the order of FrameKind.
using FramePointer =
    std::variant<const SceneFrame*, const CommandFrame*, const BaseFrame*, const ParticleFrame*,
                 const BinFrame*, const StatisticsFrame*, const ObservedFrame*>;

constexpr std::size_t FRAME_KINDS = std::variant_size_v<FramePointer>;

/// Sampling rate of each kind of frame [1/s of simulated time]; 0: only the first and the last frame.
struct FrameRates
{
  double particles = 60.0;
  double bins = 60.0;
  double base = 60.0;
  double statistics = 10.0;
  double observed = 1.0;
};

/// Largest rate that a user may set [1/s].
constexpr double MAX_FRAME_RATE = 1e5;

/// All that is particular to one kind, except its fields (see Fields).
struct FrameKindInfo
{
  FrameKind kind;
  const char* name;          ///< of its topic and of its rate parameter
  double FrameRates::*rate;  ///< null for kinds without a rate: scene, command
};

/// In the order of FrameKind.
constexpr std::array<FrameKindInfo, FRAME_KINDS> FRAME_LIST = {{
    {FrameKind::SCENE, "scene", nullptr},
    {FrameKind::COMMANDS, "commands", nullptr},
    {FrameKind::BASE, "base", &FrameRates::base},
    {FrameKind::PARTICLES, "particles", &FrameRates::particles},
    {FrameKind::BINS, "bins", &FrameRates::bins},
    {FrameKind::STATISTICS, "statistics", &FrameRates::statistics},
    {FrameKind::OBSERVED, "observed", &FrameRates::observed},
}};

constexpr const FrameKindInfo& describe(FrameKind kind)
{
  return FRAME_LIST[static_cast<std::size_t>(kind)];
}

template <typename Frame>
constexpr bool IS_FRAME = std::is_constructible_v<FramePointer, const Frame*>;

/// A reference to a frame of any kind, valid during FrameSink::take().
class AnyFrame
{
public:
  template <typename Frame, typename = std::enable_if_t<IS_FRAME<Frame>>>
  AnyFrame(const Frame& frame) : frame_(&frame)
  {
  }

  FrameKind kind() const { return static_cast<FrameKind>(frame_.index()); }

  /// The frame if it is of this kind, otherwise null.
  template <typename Frame>
  const Frame* as() const
  {
    const auto* frame = std::get_if<const Frame*>(&frame_);
    return frame != nullptr ? *frame : nullptr;
  }

  /// Calls action(const Frame&) with the frame's own type.
  template <typename Action>
  decltype(auto) visit(Action&& action) const
  {
    return std::visit([&](const auto* frame) -> decltype(auto) { return action(*frame); }, frame_);
  }

  double time() const
  {
    return visit([](const auto& frame) { return frame.time; });
  }

private:
  FramePointer frame_;
};

template <typename Frame>
constexpr FrameKind kindOf()
{
  return static_cast<FrameKind>(FramePointer(static_cast<const Frame*>(nullptr)).index());
}

template <typename Frame>
constexpr bool IS_TAKEN_AT_A_RATE = describe(kindOf<Frame>()).rate != nullptr;

/// A tag that passes the type of a frame to a function without a frame.
template <typename FrameOfThatType>
struct FrameType
{
  using Frame = FrameOfThatType;
};

/// Calls visit(FrameType<Frame>()) for each kind.
template <std::size_t Index = 0, typename Visit>
void forEachFrameType(Visit&& visit)
{
  if constexpr (Index < FRAME_KINDS)
  {
    using Pointer = std::variant_alternative_t<Index, FramePointer>;
    visit(FrameType<std::remove_const_t<std::remove_pointer_t<Pointer>>>());
    forEachFrameType<Index + 1>(visit);
  }
}

/// Calls visit(FrameType<Frame>()) for each kind that has a rate.
template <typename Visit>
void forEachSampledType(Visit&& visit)
{
  forEachFrameType(
      [&](auto type)
      {
        if constexpr (IS_TAKEN_AT_A_RATE<typename decltype(type)::Frame>)
          visit(type);
      });
}

/// Whether a run of this scene has frames of this kind.
template <typename Frame>
bool hasFrames(const SceneDefinition& scene)
{
  if constexpr (std::is_same_v<Frame, ObservedFrame>)
    return isObserved(scene);
  else
    return true;
}

/// Makes a frame of a kind that has a rate. @param window see makeStatisticsFrame()
template <typename Frame>
Frame makeFrame(const Simulation& simulation, const StatisticsWindow& window)
{
  if constexpr (std::is_same_v<Frame, BaseFrame>)
    return makeBaseFrame(simulation);
  else if constexpr (std::is_same_v<Frame, ParticleFrame>)
    return makeParticleFrame(simulation);
  else if constexpr (std::is_same_v<Frame, BinFrame>)
    return makeBinFrame(simulation);
  else if constexpr (std::is_same_v<Frame, ObservedFrame>)
    return makeObservedFrame(simulation);
  else
    return makeStatisticsFrame(simulation, window);
}

/// Takes a run's frames in the order of time. Implemented by the bag writer, the topics and the analysis.
class FrameSink
{
public:
  virtual ~FrameSink() = default;

  /// Whether frames of a kind are needed at present. A run skips frames of a kind with a rate that is
  /// not wanted.
  virtual bool wants(FrameKind) const { return true; }

  virtual void take(const AnyFrame& frame) = 0;
};

}  // namespace ratchet_sieve
