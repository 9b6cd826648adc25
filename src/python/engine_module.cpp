#include <pybind11/pybind11.h>

#include "bindings.h"
#include "errors.h"
#include "ratchet_sieve/recording/version.h"
#include "to_python.h"

PYBIND11_MODULE(_engine, module)
{
  module.doc() = "The engine of ratchet_sieve in C++; use it through the package.";
  module.attr("__version__") = ratchet_sieve::version();
  ratchet_sieve::translateErrors();
  ratchet_sieve::describeArrays();
  ratchet_sieve::bindScene(module);
  ratchet_sieve::bindSimulation(module);
  ratchet_sieve::bindControl(module);
  ratchet_sieve::bindRun(module);
  ratchet_sieve::bindSweep(module);
  ratchet_sieve::bindFrames(module);
}
