#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/range.h"

/// Reads values strictly: text is not a number, a number is not a truth value, and an integer has no
/// fraction.
namespace ratchet_sieve
{

/// All throw SceneError, which names the value and what is allowed.
void readScalar(const Entry& entry, const Range& range, double& value);
void readScalar(const Entry& entry, const Range& range, int& value);
void readScalar(const Entry& entry, const Range& range, std::uint64_t& value);
void readScalar(const Entry& entry, const Range& range, bool& value);
void readScalar(const Entry& entry, const Range& range, std::string& value);
void readScalar(const Entry& entry, const Range& range, Boundary& value);
void readScalar(const Entry& entry, const Range& range, DriveFrame& value);
void readScalar(const Entry& entry, const Range& range, CollapseAction& value);
void readScalar(const Entry& entry, const Range& range, ChokeAction& value);
void readScalar(const Entry& entry, const Range& range, Method& value);
void readScalar(const Entry& entry, const Range& range, SizeDistribution& value);
void readScalar(const Entry& entry, const Range& range, SizeShare& value);
void readScalar(const Entry& entry, const Range& range, std::vector<double>& values);  ///< each in the range
/// The outline of a tooth, without overhang. @param range of each number
void readScalar(const Entry& entry, const Range& range, std::vector<OutlineCorner>& value);

/// Names of observables, each once.
void readScalar(const Entry& entry, const Range& range, std::vector<std::string>& value);

/// What a reader above accepts.
struct LegalValues
{
  const char* type;    ///< number, integer, boolean, name, choice or list
  std::string values;  ///< such as "0 to 1000" or "stop or rebound"
};

/// The argument is given for its type alone.
LegalValues legalValues(const Range& range, double);
LegalValues legalValues(const Range& range, int);
LegalValues legalValues(const Range& range, std::uint64_t);
LegalValues legalValues(const Range& range, bool);
LegalValues legalValues(const Range& range, const std::string&);
LegalValues legalValues(const Range& range, Boundary);
LegalValues legalValues(const Range& range, DriveFrame);
LegalValues legalValues(const Range& range, CollapseAction);
LegalValues legalValues(const Range& range, ChokeAction);
LegalValues legalValues(const Range& range, Method);
LegalValues legalValues(const Range& range, const std::vector<std::string>&);
LegalValues legalValues(const Range& range, SizeDistribution);
LegalValues legalValues(const Range& range, SizeShare);
LegalValues legalValues(const Range& range, const std::vector<double>&);
LegalValues legalValues(const Range& range, const std::vector<OutlineCorner>&);

/// The text that the readers above take back to the same value, bit for bit.
std::string scalarText(double value);
std::string scalarText(int value);
std::string scalarText(std::uint64_t value);
std::string scalarText(bool value);
std::string scalarText(const std::string& value);
std::string scalarText(Boundary value);
std::string scalarText(DriveFrame value);
std::string scalarText(CollapseAction value);
std::string scalarText(ChokeAction value);
std::string scalarText(Method value);
std::string scalarText(const std::vector<std::string>& value);
std::string scalarText(SizeDistribution value);
std::string scalarText(SizeShare value);
std::string scalarText(const std::vector<double>& values);
std::string scalarText(const std::vector<OutlineCorner>& value);

}  // namespace ratchet_sieve
