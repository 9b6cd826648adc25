#include "ratchet_sieve/recording/resimulation.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{
/// The first field in which a frame, or a part of one, differs from the recorded one, with both values.
/// @param name of the part; empty for the whole @pre !sameBits(recorded, now)
template <typename T>
std::string firstDifference(const std::string& name, const T& recorded, const T& now)
{
  if constexpr (IS_DESCRIBED<T>)
  {
    std::string text;
    const auto compare = [&](const FieldInfo& field, const auto& was, const auto& is)
    {
      if (text.empty() && !sameBits(was, is))
        text =
            firstDifference(name.empty() ? field.name : fmt::format("{} of {}", field.name, name), was, is);
    };
    Fields<T>::each(compare, recorded, now);
    return text;
  }
  else if constexpr (IS_VECTOR<T>)
  {
    if (recorded.size() != now.size())
      return fmt::format("{} {} were recorded, {} were computed", recorded.size(), name, now.size());
    std::size_t k = 0;
    while (sameBits(recorded[k], now[k]))
      ++k;
    return firstDifference(fmt::format("{}[{}]", name, k), recorded[k], now[k]);
  }
  else if constexpr (IS_OPTIONAL<T>)
  {
    if (recorded && now)
      return firstDifference(name, *recorded, *now);
    return fmt::format("{} was {}defined, is {}", name, recorded ? "" : "un", now ? "defined" : "undefined");
  }
  else if constexpr (std::is_enum_v<T>)
    return fmt::format("{} was {}, is {}", name, static_cast<int>(recorded), static_cast<int>(now));
  else
    return fmt::format("{} was {}, is {}", name, recorded, now);
}

/// The recorded frame without what is not compared.
template <typename Frame>
Frame comparable(Frame frame)
{
  if constexpr (std::is_same_v<Frame, StatisticsFrame>)
    frame.real_time_factor = frame.max_overlap = 0.0;  // of the wall clock, of audits
  return frame;
}

/// Before the first period has ended both are the time of the first frame.
bool hasNoWindow(const StatisticsFrame& frame)
{
  return frame.window_start == frame.window_end;
}

/// A frame may average over a time since an earlier frame that the recording lacks: in a later file of a
/// split recording, or after frames were taken out.
StatisticsFrame withoutWindow(StatisticsFrame frame)
{
  frame.window_start = frame.window_end = 0.0;
  frame.collision_rates = {};
  for (SpeciesRow& species : frame.species)
    species.granular_temperature.reset();
  return frame;
}
}  // namespace

Resimulation::Resimulation(std::function<void(const Simulation&)> progress) : progress_(std::move(progress))
{
}

double Resimulation::time() const
{
  return simulation_ ? simulation_->time() : 0.0;
}

void Resimulation::take(const AnyFrame& any)
{
  any.visit(
      [this](const auto& frame)
      {
        using Frame = std::decay_t<decltype(frame)>;
        if constexpr (std::is_same_v<Frame, SceneFrame>)
          return begin(frame);
        else
        {
          comeTo(frame.time);
          if (difference_)
            return;
          if constexpr (std::is_same_v<Frame, CommandFrame>)
            commands_then_.push_back(frame);
          else
            recorded_.emplace_back(comparable(frame));
        }
      });
}

void Resimulation::begin(const SceneFrame& frame)
{
  if (scene_)
  {
    if (frame.yaml == scene_->yaml && sameBits(frame.start_time, scene_->start_time))
      return;
    throw std::invalid_argument("holds several runs: another one begins at " + std::to_string(frame.time) +
                                " s");
  }
  if (!(frame.start_time >= 0.0 && frame.start_time <= frame.time))
    throw std::invalid_argument("a run that began at " + std::to_string(frame.start_time) +
                                " s is not recorded from " + std::to_string(frame.time) + " s on");
  scene_ = frame;
  simulation_ = std::make_unique<Simulation>(sceneFromText(frame.yaml, "the recorded scene").definition,
                                             frame.start_time);
  simulation_->keepExits(std::numeric_limits<double>::infinity());
  run_.emplace(*simulation_, std::numeric_limits<double>::infinity());
}

/// As in the recorded run: from the beginning of the recording.
void Resimulation::observePeriods()
{
  if (std::exchange(periods_observed_, true))
    return;
  run_->advanceTo(scene_->time);
  simulation_->observePeriods([this](const PeriodRecord& period) { periods_.push_back(period); });
}

void Resimulation::comeTo(double time)
{
  if (!simulation_)
    throw std::invalid_argument("does not begin with a scene");
  if (!first_)
    first_ = time;
  else
    widest_ = std::max(widest_, time - instant_);
  if (time == instant_)
    return;
  compareInstant();
  instant_ = time;
}

void Resimulation::finish()
{
  compareInstant();
  if (!difference_ && frames_ == 0)
    throw std::invalid_argument("contains no state of the run: there is nothing to compare");
  // It began farther behind the run than its frames are apart.
  if (difference_ && differs_at_ == *first_ && *first_ - scene_->start_time > widest_)
  {
    lacks_commands_ = true;
    difference_ = fmt::format("recording begins at {:g} s; earlier commands are missing", *first_);
  }
}

void Resimulation::compareInstant()
{
  if (difference_ || (recorded_.empty() && commands_then_.empty()))
    return;
  observePeriods();
  // If it stalls, the recorded run stalled as well, or the times differ.
  run_->advanceTo(instant_);
  compareAsThingsAre();
  for (const CommandFrame& command : std::exchange(commands_then_, {}))
  {
    requireLegal(command);
    run_->applyCommand(command);
    ++commands_;
    compareAsThingsAre();
  }
  if (!recorded_.empty())
  {
    difference_ = describeDifference();
    differs_at_ = instant_;
  }
  if (progress_)
    progress_(*simulation_);
}

/// The frame of a kind now, as it would be recorded.
template <typename Frame>
Frame Resimulation::now(const Frame& recorded)
{
  if constexpr (std::is_same_v<Frame, BinFrame>)
  {
    BinFrame frame = makeBinFrame(*simulation_, recorded.window_start);
    if (recorded.window_left.empty())  // an earlier bag has no window
    {
      frame.window_start = 0.0;
      frame.window_left.clear();
      frame.window_right.clear();
      frame.window_separation.reset();
    }
    return frame;
  }
  else if constexpr (std::is_same_v<Frame, StatisticsFrame>)
  {
    // Earlier periods are those of frames that were taken out of the recording.
    for (const PeriodRecord& period : std::exchange(periods_, {}))
      if (period.start >= recorded.window_start)
        window_.take(period);
    window_.moveTo(*simulation_);
    const StatisticsFrame frame = comparable(makeStatisticsFrame(*simulation_, window_));
    const bool begins_unseen = recorded.window_start < scene_->time || !simulation_->swings() ||
                               (hasNoWindow(recorded) && hasNoWindow(frame));
    return begins_unseen && sameBits(withoutWindow(recorded), withoutWindow(frame)) ? recorded : frame;
  }
  else
    return makeFrame<Frame>(*simulation_, window_);
}

void Resimulation::compareAsThingsAre()
{
  const auto is_same = [this](const auto& frame) { return sameBits(frame, now(frame)); };
  const auto end = std::remove_if(recorded_.begin(), recorded_.end(),
                                  [&](const Recorded& frame) { return std::visit(is_same, frame); });
  frames_ += static_cast<std::uint64_t>(recorded_.end() - end);
  recorded_.erase(end, recorded_.end());
}

/// Whether a recorded base has other setpoints than the one that is computed: only commands change them.
bool Resimulation::setpointsDiffer()
{
  const DriveState& now = makeFrame<BaseFrame>(*simulation_, window_).base;
  const auto differs = [&now](const Recorded& any)
  {
    const auto* frame = std::get_if<BaseFrame>(&any);
    return frame != nullptr &&
           std::any_of(std::begin(COMMANDED_QUANTITIES), std::end(COMMANDED_QUANTITIES),
                       [&](const CommandedQuantity& quantity)
                       { return frame->base.*quantity.commanded != now.*quantity.commanded; });
  };
  return std::any_of(recorded_.begin(), recorded_.end(), differs);
}

std::string Resimulation::describeDifference()
{
  if (simulation_->stalled() && simulation_->time() < instant_)
    return fmt::format("at {:.17g} s the run stopped: {}", simulation_->time(), simulation_->collapseText());
  lacks_commands_ = setpointsDiffer();
  if (lacks_commands_)
    return fmt::format("commands until {:g} s are missing", instant_);
  return std::visit(
      [this](const auto& frame)
      {
        return fmt::format("at {:.17g} s the frames of {} differ: {}", instant_,
                           describe(AnyFrame(frame).kind()).name, firstDifference("", frame, now(frame)));
      },
      recorded_.front());
}

}  // namespace ratchet_sieve
