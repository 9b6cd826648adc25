#include "simd/batch_run.h"

namespace ratchet_sieve
{

void BatchRun::executeEvents(const BatchKernel& kernel, const BatchScene& scene, std::size_t rows)
{
  for (std::size_t row = 0; row < rows && share_->wantsFlights(); ++row)
  {
    Disk disk;
    readState(batch_, row, disk);
    disk.species = species_[row];
    share_->flew({slots_[row], disk, batch_.event_time[row]});
  }
  kernel.collide(scene, batch_, rows);
  report_.events += rows;
  share_->collided(rows,
                   [this](std::size_t row) { return outcomeOf(batch_, row, slots_[row], species_[row]); });
  kernel.search(scene, batch_, rows);
}

BatchRun::Report BatchRun::takeReport(Observers::Share& share)
{
  if (share_)
    share.merge(std::move(*share_));
  share_.reset();
  return std::exchange(report_, Report());
}

}  // namespace ratchet_sieve
