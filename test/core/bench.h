#pragma once

#include "state/contact_execution.h"
#include "state/system_state.h"

namespace ratchet_sieve::test
{

/// A system and the execution of its contacts, for tests that bring their own loop or none.
struct Bench
{
  explicit Bench(const SceneDefinition& scene) : state(scene), execution(state) {}

  SystemState state;
  ContactExecution execution;
};

}  // namespace ratchet_sieve::test
