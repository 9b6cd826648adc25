#include "bag_output.h"

#include <stdexcept>

#include <dlfcn.h>

namespace ratchet_sieve
{

/// Never unloads the library, because ROS's libraries do not support it.
std::unique_ptr<BagOutput> openBag(const std::string& path)
{
#ifdef RATCHET_SIEVE_BAG_PLUGIN
  void* library = dlopen(RATCHET_SIEVE_BAG_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  void* function = library != nullptr ? dlsym(library, BAG_PLUGIN_FUNCTION) : nullptr;
  if (function == nullptr)
    throw std::runtime_error(
        "--bag " + path +
        ": bags need the ROS part (on Debian: install ros-ratchet-sieve_*.deb): " + dlerror());
  return std::unique_ptr<BagOutput>(reinterpret_cast<OpenBagPlugin*>(function)(path.c_str()));
#else
  throw std::runtime_error("--bag " + path + ": bags need ROS, and this build has none");
#endif
}

}  // namespace ratchet_sieve
