#pragma once

#include <memory>
#include <string>

#include "state/observer.h"

namespace ratchet_sieve
{

class SystemState;

/// An observer that a scene asks for by its name.
class Observable : public Observer
{
public:
  /// What was seen until `time`, local to the epoch.
  virtual Observed observed(double time) const = 0;
};

/// @param name of observableNames() @param system outlives it
/// @throws std::invalid_argument for another name
std::unique_ptr<Observable> makeObservable(const std::string& name, const SystemState& system);

constexpr const char* HEIGHT_PROFILE = "height_profile";
std::unique_ptr<Observable> makeHeightProfile(const SystemState& system);

}  // namespace ratchet_sieve
