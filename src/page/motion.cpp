#include "motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "html_page.h"
#include "ratchet_sieve/core/disks_of_scene.h"

namespace ratchet_sieve
{
namespace
{

constexpr double UNITS_PER_RADIUS = 50.0;   ///< of positions, for the smallest disk
constexpr double UNITS_PER_SECOND = 240.0;  ///< of velocities: units of positions
constexpr double SPIN_UNIT = 6.0;           ///< [rad/s]
constexpr int ANGLE_STEPS = 256;            ///< of a turn
constexpr double RADIUS_UNITS = 1000.0;     ///< for the smallest disk
constexpr double TWO_PI = 6.283185307179586;

/// The largest number that is written: far beyond any machine.
constexpr double LARGEST = 1 << 28;

/// Fewest bytes that a state takes when it is encoded, or the time of a frame. About 5 are usual.
constexpr std::size_t LEAST_STATE = 4;

/// Frames that are always kept.
constexpr std::size_t FEWEST_FRAMES = 2;

/// By which what does not fit is thinned once more.
constexpr double MORE = 1.1;

/// Of a rate of frames.
constexpr double ROUNDING = 1e-6;

/// What is no number becomes the largest.
std::int32_t inUnits(double value, double unit)
{
  return static_cast<std::int32_t>(std::floor(std::fmax(-LARGEST, std::fmin(value / unit, LARGEST)) + 0.5));
}

/// Of two numbers whose difference may not be one of 32 bits.
std::int32_t difference(double a, double b)
{
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(a - b)));
}

std::uint32_t zigzag(std::int32_t number)
{
  return (static_cast<std::uint32_t>(number) << 1U) ^ (number < 0 ? 0xFFFFFFFFU : 0U);
}

/// Adds the columns of rows: of each the lowest bytes of all its numbers, then the next.
template <std::size_t Columns>
void addColumns(std::string& bytes, const std::vector<std::array<std::int32_t, Columns>>& rows)
{
  for (std::size_t column = 0; column < Columns; ++column)
    for (unsigned shift = 0; shift < 32; shift += 8)
      for (const std::array<std::int32_t, Columns>& row : rows)
        bytes += static_cast<char>(zigzag(row[column]) >> shift & 0xFFU);
}

/// An angle in steps of a turn, from half a turn back on.
std::int32_t withinATurn(std::int32_t steps)
{
  return static_cast<std::int32_t>(static_cast<unsigned>(steps + ANGLE_STEPS / 2) % ANGLE_STEPS) -
         ANGLE_STEPS / 2;
}

}  // namespace

/// A disk in consecutive frames.
struct MotionRecord::Track
{
  std::size_t first_frame;
  std::vector<const Disk*> states;
};

MotionRecord::MotionRecord(const SceneDefinition& scene, std::size_t most_bytes)
    : scene_(scene),
      position_unit_(smallestRadius(scene) / UNITS_PER_RADIUS),
      velocity_unit_(position_unit_ * UNITS_PER_SECOND),
      radius_unit_(smallestRadius(scene) / RADIUS_UNITS),
      most_bytes_(most_bytes)
{
}

void MotionRecord::add(const ParticleFrame& frame)
{
  if (taken_++ % thinning_.every != 0 || thinning_.cut)
  {
    last_ = frame;
    return;
  }
  last_.reset();
  kept_.push_back(rounded(frame));
  kept_states_ += 1 + kept_.back().disks.size();
  // Thinned at an odd number of frames, of which every second one includes the last.
  if (kept_states_ <= most_bytes_ / LEAST_STATE || kept_.size() <= FEWEST_FRAMES || kept_.size() % 2 == 0)
    return;
  if (mostEvery(kept_) < 2 && !leavesOutDisks(kept_, 2.0))
  {
    thinning_.cut = true;
    return;
  }
  thin(kept_, 2.0, thinning_);
  kept_states_ = kept_.size() + countStates(kept_);
}

/// The largest k of which every k-th frame leaves LEAST_RATE frames a second; at least 1.
std::size_t MotionRecord::mostEvery(const std::vector<Frame>& frames)
{
  const double span = frames.back().time - frames.front().time;
  const double rate = span > 0.0 ? static_cast<double>(frames.size() - 1) / span : 0.0;
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::floor(rate / LEAST_RATE * (1.0 + ROUNDING))));
}

std::size_t MotionRecord::countStates(const std::vector<Frame>& frames)
{
  std::size_t states = 0;
  for (const Frame& frame : frames)
    states += frame.disks.size();
  return states;
}

MotionRecord::Frame MotionRecord::rounded(const ParticleFrame& frame) const
{
  Frame result{frame.time, {}};
  for (const DiskState& disk : frame.disks)
    if (disk.id % thinning_.disk_every == 0)
      result.disks.push_back({disk.id, disk.species, inUnits(disk.x, position_unit_),
                              inUnits(disk.y, position_unit_), inUnits(disk.vx, velocity_unit_),
                              inUnits(disk.vy, velocity_unit_), inUnits(disk.angle, TWO_PI / ANGLE_STEPS),
                              inUnits(disk.spin, SPIN_UNIT),
                              inUnits(radiusOf(disk, scene_.species), radius_unit_)});
  return result;
}

/// Whether what is thinned by a factor beyond that of frames loses disks: as long as there are so many.
bool MotionRecord::leavesOutDisks(const std::vector<Frame>& frames, double factor) const
{
  return !scene_.contact.pair_collisions &&
         static_cast<double>(countStates(frames)) >= factor * static_cast<double>(frames.size());
}

void MotionRecord::thin(std::vector<Frame>& frames, double factor, Thinning& thinning) const
{
  const std::size_t every = std::min(static_cast<std::size_t>(std::ceil(factor)), mostEvery(frames));
  const double rest = factor / static_cast<double>(every);
  const bool fewer_disks = leavesOutDisks(frames, rest);
  std::size_t end = frames.size();
  if (rest > 1.0 && !fewer_disks)
  {
    thinning.cut = true;
    end =
        std::clamp(static_cast<std::size_t>(static_cast<double>(end) / rest), std::min(every + 1, end), end);
  }
  else if (rest > 1.0)
    thinning.disk_every *= static_cast<std::uint32_t>(std::ceil(rest));
  thinning.every *= every;
  std::vector<Frame> kept;
  for (std::size_t k = 0; k < end; ++k)
    if (k % every == 0 || k + 1 == frames.size())
      kept.push_back(std::move(frames[k]));
  frames = std::move(kept);
  const auto left_out = [&](const Disk& disk) { return disk.id % thinning.disk_every != 0; };
  for (Frame& frame : frames)
    frame.disks.erase(std::remove_if(frame.disks.begin(), frame.disks.end(), left_out), frame.disks.end());
}

EncodedMotion MotionRecord::encoded(std::size_t size) const
{
  std::vector<Frame> all = kept_;
  if (last_ && !thinning_.cut)
    all.push_back(rounded(*last_));
  Thinning thinning = thinning_;
  EncodedMotion encoded = encode(all);
  std::size_t frames_left = all.size();
  for (double factor =
           std::max(MORE, static_cast<double>(encoded.bytes.size()) / std::max<double>(size, 1.0));
       encoded.bytes.size() > size && frames_left > FEWEST_FRAMES; factor *= MORE)
  {
    std::vector<Frame> frames = all;
    thinning = thinning_;
    thin(frames, factor, thinning);
    frames_left = frames.size();
    encoded = encode(frames);
  }
  encoded.description["taken"] = taken_;
  encoded.description["every"] = thinning.every;
  encoded.description["disk_every"] = thinning.disk_every;
  encoded.description["cut"] = thinning.cut;
  return encoded;
}

std::vector<MotionRecord::Track> MotionRecord::tracksOf(const std::vector<Frame>& frames)
{
  std::vector<Track> tracks;
  std::unordered_map<std::uint32_t, std::size_t> last;  ///< track, by id
  for (std::size_t k = 0; k < frames.size(); ++k)
    for (const Disk& disk : frames[k].disks)
    {
      const auto [found, is_new] = last.try_emplace(disk.id, tracks.size());
      if (is_new || tracks[found->second].first_frame + tracks[found->second].states.size() != k)
      {
        found->second = tracks.size();
        tracks.push_back({k, {}});
      }
      tracks[found->second].states.push_back(&disk);
    }
  return tracks;
}

std::vector<MotionRecord::State> MotionRecord::statesOf(const std::vector<Track>& tracks,
                                                        const std::vector<Frame>& frames)
{
  std::vector<State> states;
  for (const Track& track : tracks)
  {
    Disk before{};        // a track's first state is given by its difference from zero
    double factor = 0.0;  // units of positions by units of velocities, in the time between
    for (std::size_t i = 0; i < track.states.size(); ++i)
    {
      const Disk& now = *track.states[i];
      const std::size_t k = track.first_frame + i;
      if (i > 0)
        factor = (frames[k].time - frames[k - 1].time) * UNITS_PER_SECOND;
      const auto moved = [&](std::int32_t Disk::*position, std::int32_t Disk::*velocity)
      {
        const double mean = 0.5 * (before.*velocity + now.*velocity);
        return difference(now.*position, before.*position + std::floor(mean * factor + 0.5));
      };
      states.push_back({now.vx, now.vy, moved(&Disk::x, &Disk::vx), moved(&Disk::y, &Disk::vy), now.spin,
                        withinATurn(now.angle - before.angle)});
      before = now;
    }
  }
  return states;
}

EncodedMotion MotionRecord::encode(const std::vector<Frame>& frames) const
{
  const std::vector<Track> all = tracksOf(frames);
  std::vector<std::array<std::int32_t, 5>> tracks;
  for (const Track& track : all)
  {
    const Disk& first = *track.states.front();
    tracks.push_back({static_cast<std::int32_t>(first.id), static_cast<std::int32_t>(first.species),
                      first.radius, static_cast<std::int32_t>(track.first_frame),
                      static_cast<std::int32_t>(track.states.size())});
  }
  const std::vector<State> states = statesOf(all, frames);
  std::string bytes;
  for (const Frame& frame : frames)
    bytes.append(reinterpret_cast<const char*>(&frame.time), sizeof frame.time);
  addColumns(bytes, tracks);
  addColumns(bytes, states);
  return {{{"frames", frames.size()},
           {"position_unit", position_unit_},
           {"velocity_unit", velocity_unit_},
           {"positions_per_velocity", UNITS_PER_SECOND},
           {"spin_unit", SPIN_UNIT},
           {"angle_steps", ANGLE_STEPS},
           {"radius_unit", radius_unit_},
           {"tracks", tracks.size()},
           {"states", states.size()}},
          deflated(bytes)};
}

}  // namespace ratchet_sieve
