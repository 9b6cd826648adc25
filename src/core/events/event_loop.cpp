#include "events/event_loop.h"

#include "state/system_state.h"

namespace ratchet_sieve
{

void EventLoop::requireDisks(std::size_t count, const SystemState& state)
{
  if (count != state.disks().size())
    throw StateError("it has another number of disks");
}

}  // namespace ratchet_sieve
