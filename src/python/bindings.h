#pragma once

#include <string>

#include <pybind11/pybind11.h>

/// What each part adds to the module ratchet_sieve._engine, whose functions are wrapped and described in
/// Python.
namespace ratchet_sieve
{

void bindScene(pybind11::module_& module);
void bindSimulation(pybind11::module_& module);
void bindControl(pybind11::module_& module);
void bindRun(pybind11::module_& module);
void bindFrames(pybind11::module_& module);

/// Warns (SieveWarning). @pre Python's lock is held @throws what a filter of warnings makes of it
void warnPython(const std::string& text);

}  // namespace ratchet_sieve
