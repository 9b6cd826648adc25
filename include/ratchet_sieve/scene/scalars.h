#pragma once

#include <cstdint>
#include <string>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/range.h"

/// One value each out of an entry, strictly: a number is no text, a truth value no number, and an
/// integer has no fraction.
namespace ratchet_sieve
{

/// All throw SceneError, naming the value and what is allowed.
void readScalar(const Entry& entry, const Range& range, double& value);
void readScalar(const Entry& entry, const Range& range, int& value);
void readScalar(const Entry& entry, const Range& range, std::uint64_t& value);
void readScalar(const Entry& entry, const Range& range, bool& value);
void readScalar(const Entry& entry, const Range& range, std::string& value);
void readScalar(const Entry& entry, const Range& range, Boundary& value);
void readScalar(const Entry& entry, const Range& range, CollapseAction& value);
void readScalar(const Entry& entry, const Range& range, Method& value);

/// The text that the readers above take back to the same value, bit for bit.
std::string scalarText(double value);
std::string scalarText(int value);
std::string scalarText(std::uint64_t value);
std::string scalarText(bool value);
std::string scalarText(const std::string& value);
std::string scalarText(Boundary value);
std::string scalarText(CollapseAction value);
std::string scalarText(Method value);

}  // namespace ratchet_sieve
