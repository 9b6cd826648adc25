// What check_layers.py must find: a floor of the core including one above it, and the facade.
#include "events/event_queue.h"
#include "ratchet_sieve/core/simulation.h"
