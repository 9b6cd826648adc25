#include <array>
#include <string>
#include <utility>

#include "ratchet_sieve/scene/scalars.h"

namespace ratchet_sieve
{
namespace
{

template <typename Choice, std::size_t COUNT>
using ChoiceNames = std::array<std::pair<Choice, const char*>, COUNT>;

constexpr ChoiceNames<Boundary, 3> BOUNDARY_NAMES = {
    {{Boundary::PERIODIC, "periodic"}, {Boundary::OPEN, "open"}, {Boundary::WALLED, "walled"}}};

constexpr ChoiceNames<DriveFrame, 2> DRIVE_FRAME_NAMES = {
    {{DriveFrame::WORLD, "world"}, {DriveFrame::BASE, "base"}}};

constexpr ChoiceNames<CollapseAction, 2> COLLAPSE_ACTION_NAMES = {
    {{CollapseAction::STOP, "stop"}, {CollapseAction::REBOUND, "rebound"}}};

constexpr ChoiceNames<ChokeAction, 2> CHOKE_ACTION_NAMES = {
    {{ChokeAction::RUN, "run"}, {ChokeAction::STOP, "stop"}}};

constexpr ChoiceNames<Method, 2> METHOD_NAMES = {{{Method::EVENTS, "events"}, {Method::STEPS, "steps"}}};

constexpr ChoiceNames<SizeDistribution, 4> SIZE_DISTRIBUTION_NAMES = {
    {{SizeDistribution::UNIFORM, "uniform"},
     {SizeDistribution::NORMAL, "normal"},
     {SizeDistribution::LOGNORMAL, "lognormal"},
     {SizeDistribution::TABLE, "table"}}};

constexpr ChoiceNames<SizeShare, 2> SIZE_SHARE_NAMES = {
    {{SizeShare::NUMBER, "number"}, {SizeShare::MASS, "mass"}}};

template <typename Choice, std::size_t COUNT>
LegalValues legalChoice(const ChoiceNames<Choice, COUNT>& choices)
{
  std::string names;
  for (std::size_t i = 0; i < COUNT; ++i)
    names += (i == 0 ? "" : i + 1 < COUNT ? ", " : " or ") + std::string(choices[i].second);
  return {"choice", names};
}

template <typename Choice, std::size_t COUNT>
void readChoice(const Entry& entry, const ChoiceNames<Choice, COUNT>& choices, Choice& value)
{
  for (const auto& [choice, name] : choices)
    if (entry.node().IsScalar() && entry.node().Scalar() == name)
    {
      value = choice;
      return;
    }
  entry.refuseValue("must be " + legalChoice(choices).values);
}

template <typename Choice, std::size_t COUNT>
std::string choiceText(const ChoiceNames<Choice, COUNT>& choices, Choice value)
{
  for (const auto& [choice, name] : choices)
    if (choice == value)
      return name;
  return "";
}

}  // namespace

void readScalar(const Entry& entry, const Range&, Boundary& value)
{
  readChoice(entry, BOUNDARY_NAMES, value);
}

void readScalar(const Entry& entry, const Range&, DriveFrame& value)
{
  readChoice(entry, DRIVE_FRAME_NAMES, value);
}

void readScalar(const Entry& entry, const Range&, CollapseAction& value)
{
  readChoice(entry, COLLAPSE_ACTION_NAMES, value);
}

void readScalar(const Entry& entry, const Range&, ChokeAction& value)
{
  readChoice(entry, CHOKE_ACTION_NAMES, value);
}

void readScalar(const Entry& entry, const Range&, Method& value)
{
  readChoice(entry, METHOD_NAMES, value);
}

void readScalar(const Entry& entry, const Range&, SizeDistribution& value)
{
  readChoice(entry, SIZE_DISTRIBUTION_NAMES, value);
}

void readScalar(const Entry& entry, const Range&, SizeShare& value)
{
  readChoice(entry, SIZE_SHARE_NAMES, value);
}

LegalValues legalValues(const Range&, Boundary)
{
  return legalChoice(BOUNDARY_NAMES);
}

LegalValues legalValues(const Range&, DriveFrame)
{
  return legalChoice(DRIVE_FRAME_NAMES);
}

LegalValues legalValues(const Range&, CollapseAction)
{
  return legalChoice(COLLAPSE_ACTION_NAMES);
}

LegalValues legalValues(const Range&, ChokeAction)
{
  return legalChoice(CHOKE_ACTION_NAMES);
}

LegalValues legalValues(const Range&, Method)
{
  return legalChoice(METHOD_NAMES);
}

LegalValues legalValues(const Range&, SizeDistribution)
{
  return legalChoice(SIZE_DISTRIBUTION_NAMES);
}

LegalValues legalValues(const Range&, SizeShare)
{
  return legalChoice(SIZE_SHARE_NAMES);
}

std::string scalarText(Boundary value)
{
  return choiceText(BOUNDARY_NAMES, value);
}

std::string scalarText(DriveFrame value)
{
  return choiceText(DRIVE_FRAME_NAMES, value);
}

std::string scalarText(CollapseAction value)
{
  return choiceText(COLLAPSE_ACTION_NAMES, value);
}

std::string scalarText(ChokeAction value)
{
  return choiceText(CHOKE_ACTION_NAMES, value);
}

std::string scalarText(Method value)
{
  return choiceText(METHOD_NAMES, value);
}

std::string scalarText(SizeDistribution value)
{
  return choiceText(SIZE_DISTRIBUTION_NAMES, value);
}

std::string scalarText(SizeShare value)
{
  return choiceText(SIZE_SHARE_NAMES, value);
}

}  // namespace ratchet_sieve
