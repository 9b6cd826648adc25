#include <exception>
#include <new>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "bindings.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "ratchet_sieve/sweep/database.h"
#include "to_python.h"

namespace ratchet_sieve
{
namespace
{

namespace py = pybind11;

/// A line may quote a file that is not UTF-8.
py::str lineOf(const std::string& text)
{
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace"));
}

template <typename... Texts>
void raise(const char* type, const Texts&... texts)
{
  const py::object error = py::module_::import("ratchet_sieve.errors").attr(type);
  PyErr_SetObject(error.ptr(), error(lineOf(texts)...).ptr());
}

/// Turns the C++ errors of the layers into those of ratchet_sieve.errors.
void translateErrors()
{
  py::register_exception_translator(
      [](std::exception_ptr pointer)
      {
        try
        {
          std::rethrow_exception(std::move(pointer));
        }
        catch (const SceneError& error)
        {
          raise("SceneError", error.what(), error.key, error.value, error.allowed);
        }
        catch (const StallError& error)
        {
          raise("StallError", error.what());
        }
        catch (const StateError& error)
        {
          raise("StateError", error.what());
        }
        catch (const DatabaseError& error)
        {
          raise("ResultsError", error.what());
        }
        catch (const std::bad_alloc& error)
        {
          PyErr_SetString(PyExc_MemoryError, errorText(error).c_str());
        }
        catch (const OutputError& error)
        {
          PyErr_SetString(PyExc_OSError, error.what());
        }
        catch (const SameFileError& error)
        {
          PyErr_SetString(PyExc_ValueError, error.what());
        }
      });
}

}  // namespace

void warnPython(const std::string& text)
{
  const py::object kind = py::module_::import("ratchet_sieve.errors").attr("SieveWarning");
  if (PyErr_WarnEx(kind.ptr(), text.c_str(), 1) != 0)
    throw py::error_already_set();
}

}  // namespace ratchet_sieve

PYBIND11_MODULE(_engine, module)
{
  using namespace ratchet_sieve;
  module.doc() = "The engine of ratchet_sieve in C++; use it through the package.";
  module.attr("__version__") = version();
  translateErrors();
  describeArrays();
  bindScene(module);
  bindSimulation(module);
  bindControl(module);
  bindRun(module);
  bindFrames(module);
}
