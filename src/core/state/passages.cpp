#include "state/passages.h"

namespace ratchet_sieve
{

void Passages::entered(const Disk& disk, double time)
{
  Passage passage;
  passage.entered_x = disk.position.x();
  passage.counted_x = disk.position.x();
  passage.counted_from = time;
  passages_.push_back(passage);
}

void Passages::integrate(Passage& passage, const Disk& disk, double local_time) const
{
  const double span = local_time - disk.time;
  const double fall = gravity_ * span;
  passage.translation += translationOver(disk.velocity.x(), disk.velocity.y(), fall, span);
  if (!spin_)
    return;
  passage.rotation += rotationOver(disk.spin, span);
  passage.angle = positionAfter(passage.angle, disk.spin, span);
}

void Passages::restart(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active, double time,
                       double local_time)
{
  for (std::uint32_t slot = 0; slot < disks.size(); ++slot)
  {
    Passage& passage = passages_[slot];
    passage.counted_from = Passage::NEVER;
    if (!active[slot])
      continue;
    // The part of the present flight before now is subtracted here, because it is added at the end of the
    // flight.
    Passage before;
    integrate(before, disks[slot], local_time);
    passage.translation = -before.translation;
    passage.rotation = -before.rotation;
    passage.counted_x = flown(disks[slot], local_time, gravity_).position.x() + passage.offset;
    passage.counted_from = time;
  }
}

}  // namespace ratchet_sieve
