#include "checkpoint_saver.h"

#include <cstdio>

#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{

CheckpointSaver::CheckpointSaver(const std::string& path, const Simulation& simulation,
                                 const RunProgress& progress)
    : path_(path)
{
  writeCheckpoint(path_, simulation, progress);
}

void CheckpointSaver::save(const Simulation& simulation, const RunProgress& progress)
{
  try
  {
    writeCheckpoint(path_, simulation, progress);
    failure_.clear();
  }
  catch (const OutputError& error)
  {
    if (failure_ != error.what())
      std::fprintf(stderr, "sieve_run: warning: %s\n", error.what());
    failure_ = error.what();
  }
}

}  // namespace ratchet_sieve
