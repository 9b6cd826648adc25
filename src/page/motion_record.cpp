#include "motion_record.h"

#include <algorithm>
#include <utility>

namespace ratchet_sieve
{
namespace
{

/// Fewest bytes that a state takes when it is encoded. About 5 are usual.
constexpr std::size_t LEAST_STATE = 4;

/// Frames that are always kept: the first and the last.
constexpr std::size_t FEWEST_FRAMES = 2;

/// [1/s]; 0 for frames of one time.
double rateOf(const std::vector<RoundedFrame>& frames)
{
  const double span = frames.back().time - frames.front().time;
  return span > 0.0 ? static_cast<double>(frames.size() - 1) / span : 0.0;
}

void keepEvery(std::size_t factor, std::vector<RoundedFrame>& frames)
{
  std::vector<RoundedFrame> kept;
  for (std::size_t k = 0; k < frames.size(); ++k)
    if (k % factor == 0 || k + 1 == frames.size())
      kept.push_back(std::move(frames[k]));
  frames = std::move(kept);
}

void keepDisks(std::uint32_t disk_every, std::vector<RoundedDisk>& disks)
{
  disks.erase(std::remove_if(disks.begin(), disks.end(),
                             [disk_every](const RoundedDisk& disk) { return disk.id % disk_every != 0; }),
              disks.end());
}

}  // namespace

MotionRecord::MotionRecord(const SceneDefinition& scene, std::size_t most_bytes)
    : scene_(scene), units_(scene), most_bytes_(most_bytes)
{
}

void MotionRecord::take(const ParticleFrame& frame)
{
  if (taken_++ % thinning_.every != 0)
  {
    last_ = frame;
    return;
  }
  last_.reset();
  kept_.push_back(rounded(frame, scene_, units_, thinning_.disk_every));
  kept_states_ += kept_.back().disks.size();
  // Thinned at an odd number of frames, of which every second one includes the last.
  if (kept_states_ <= most_bytes_ / LEAST_STATE || kept_.size() <= FEWEST_FRAMES || kept_.size() % 2 == 0)
    return;
  thin(kept_, 2, thinning_);
  kept_states_ = 0;
  for (const RoundedFrame& each : kept_)
    kept_states_ += each.disks.size();
}

void MotionRecord::thin(std::vector<RoundedFrame>& frames, std::size_t factor, Thinning& thinning) const
{
  const auto spare = static_cast<std::size_t>(rateOf(frames) / LEAST_RATE);
  const std::size_t by_frames =
      scene_.contact.pair_collisions ? factor : std::clamp<std::size_t>(spare, 1, factor);
  const std::size_t by_disks = (factor + by_frames - 1) / by_frames;
  thinning.every *= by_frames;
  thinning.disk_every *= static_cast<std::uint32_t>(by_disks);
  keepEvery(by_frames, frames);
  if (by_disks > 1)
    for (RoundedFrame& frame : frames)
      keepDisks(thinning.disk_every, frame.disks);
}

EncodedMotion MotionRecord::encoded(std::size_t size) const
{
  std::vector<RoundedFrame> all = kept_;
  if (last_)
    all.push_back(rounded(*last_, scene_, units_, thinning_.disk_every));
  Thinning thinning = thinning_;
  EncodedMotion encoded = encode(all, units_);
  std::size_t frames_left = all.size();
  for (std::size_t factor = std::max<std::size_t>(2, encoded.bytes.size() / std::max<std::size_t>(size, 1));
       encoded.bytes.size() > size && frames_left > FEWEST_FRAMES; ++factor)
  {
    std::vector<RoundedFrame> frames = all;
    thinning = thinning_;
    thin(frames, factor, thinning);
    frames_left = frames.size();
    encoded = encode(frames, units_);
  }
  encoded.description["taken"] = taken_;
  encoded.description["every"] = thinning.every;
  encoded.description["disk_every"] = thinning.disk_every;
  return encoded;
}

}  // namespace ratchet_sieve
