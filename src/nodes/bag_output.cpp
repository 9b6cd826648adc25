#include "bag_output.h"

#include <stdexcept>

#include <dlfcn.h>

#include "bag_plugin.h"

namespace ratchet_sieve
{
namespace
{

/// Never unloads the library, because ROS's libraries do not support it.
std::unique_ptr<BagPlugin> openBag(const std::string& path)
{
  void* library = dlopen(BAG_PLUGIN_FILE, RTLD_NOW | RTLD_LOCAL);
  void* function = library != nullptr ? dlsym(library, BAG_PLUGIN_FUNCTION) : nullptr;
  if (function == nullptr)
    throw std::runtime_error("--bag " + path + ": " + dlerror());
  return std::unique_ptr<BagPlugin>(reinterpret_cast<OpenBagPlugin*>(function)(path.c_str()));
}

}  // namespace

struct BagOutput::Implementation
{
  std::unique_ptr<BagPlugin> bag;
};

BagOutput::BagOutput(const std::string& path) : implementation_(new Implementation{openBag(path)}) {}

BagOutput::~BagOutput() = default;

FrameSink& BagOutput::sink()
{
  return implementation_->bag->sink();
}

void BagOutput::close()
{
  implementation_->bag->close();
}

}  // namespace ratchet_sieve
