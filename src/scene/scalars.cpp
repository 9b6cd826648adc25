#include "ratchet_sieve/scene/scalars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>

namespace ratchet_sieve
{
namespace
{

/// Longest name of a species [characters].
constexpr std::size_t LONGEST_NAME = 64;

template <typename Choice, std::size_t COUNT>
using ChoiceNames = std::array<std::pair<Choice, const char*>, COUNT>;

constexpr ChoiceNames<Boundary, 3> BOUNDARY_NAMES = {
    {{Boundary::PERIODIC, "periodic"}, {Boundary::OPEN, "open"}, {Boundary::WALLED, "walled"}}};

constexpr ChoiceNames<CollapseAction, 2> COLLAPSE_ACTION_NAMES = {
    {{CollapseAction::STOP, "stop"}, {CollapseAction::REBOUND, "rebound"}}};

constexpr ChoiceNames<Method, 2> METHOD_NAMES = {{{Method::EVENTS, "events"}, {Method::STEPS, "steps"}}};

template <typename Choice, std::size_t COUNT>
void readChoice(const Entry& entry, const ChoiceNames<Choice, COUNT>& choices, Choice& value)
{
  std::string allowed;
  for (std::size_t i = 0; i < COUNT; ++i)
  {
    if (entry.node().IsScalar() && entry.node().Scalar() == choices[i].second)
    {
      value = choices[i].first;
      return;
    }
    allowed += (i == 0 ? "" : i + 1 < COUNT ? ", " : " or ") + std::string(choices[i].second);
  }
  entry.refuseValue("must be " + allowed);
}

template <typename Choice, std::size_t COUNT>
std::string choiceText(const ChoiceNames<Choice, COUNT>& choices, Choice value)
{
  for (const auto& [choice, name] : choices)
    if (choice == value)
      return name;
  return "";
}

/// The text of a scalar that is not in quotes: YAML's text in quotes is never a number.
std::optional<std::string> plainText(const Entry& entry)
{
  if (!entry.node().IsScalar() || entry.node().Tag() == "!")
    return std::nullopt;
  return entry.node().Scalar();
}

/// The whole text as a value, whatever the program's locale.
template <typename T>
std::optional<T> parsed(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  T value{};
  if (text.empty() || !(stream >> value) || stream.peek() != std::istringstream::traits_type::eof())
    return std::nullopt;
  return value;
}

std::string formatted(double value, int digits)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(digits);
  stream << value;
  return stream.str();
}

bool allowedInName(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.';
}

}  // namespace

std::string Range::text() const
{
  const bool floor = std::isfinite(lowest);
  const bool ceiling = std::isfinite(highest);
  const std::string unit_text = *unit == '\0' ? "" : std::string(" ") + unit;
  if (floor && ceiling)
    return "from " + scalarText(lowest) + " to " + scalarText(highest) + unit_text;
  if (floor)
    return "of at least " + scalarText(lowest) + unit_text;
  return "that is finite";
}

void readScalar(const Entry& entry, const Range& range, double& value)
{
  const std::optional<std::string> text = plainText(entry);
  const std::optional<double> number = text ? parsed<double>(*text) : std::nullopt;
  if (!number || !std::isfinite(*number) || !range.holds(*number))
    entry.refuseValue("must be a number " + range.text());
  value = *number;
}

void readScalar(const Entry& entry, const Range& range, int& value)
{
  const std::optional<std::string> text = plainText(entry);
  const std::optional<int> number = text ? parsed<int>(*text) : std::nullopt;
  if (!number || !range.holds(*number))
    entry.refuseValue("must be an integer " + range.text());
  value = *number;
}

void readScalar(const Entry& entry, const Range&, std::uint64_t& value)
{
  const std::optional<std::string> text = plainText(entry);
  const bool digits =
      text && std::all_of(text->begin(), text->end(), [](char c) { return c >= '0' && c <= '9'; });
  const std::optional<std::uint64_t> number = digits ? parsed<std::uint64_t>(*text) : std::nullopt;
  if (!number)
    entry.refuseValue("must be an integer from 0 to " +
                      scalarText(std::numeric_limits<std::uint64_t>::max()));
  value = *number;
}

void readScalar(const Entry& entry, const Range&, bool& value)
{
  const std::optional<std::string> text = plainText(entry);
  if (!text || (*text != "true" && *text != "false"))
    entry.refuseValue("must be true or false");
  value = *text == "true";
}

void readScalar(const Entry& entry, const Range&, std::string& value)
{
  const bool legal = entry.node().IsScalar() && !entry.node().Scalar().empty() &&
                     entry.node().Scalar().size() <= LONGEST_NAME &&
                     std::all_of(entry.node().Scalar().begin(), entry.node().Scalar().end(), allowedInName);
  if (!legal)
    entry.refuseValue("must be a name of 1 to " + std::to_string(LONGEST_NAME) +
                      " letters, digits, '_', '-' or '.'");
  value = entry.node().Scalar();
}

void readScalar(const Entry& entry, const Range&, Boundary& value)
{
  readChoice(entry, BOUNDARY_NAMES, value);
}

void readScalar(const Entry& entry, const Range&, CollapseAction& value)
{
  readChoice(entry, COLLAPSE_ACTION_NAMES, value);
}

void readScalar(const Entry& entry, const Range&, Method& value)
{
  readChoice(entry, METHOD_NAMES, value);
}

std::string scalarText(double value)
{
  // Every double comes back from 17 digits; most do from fewer, which are easier to read.
  for (int digits = 15; digits < 17; ++digits)
  {
    std::string text = formatted(value, digits);
    if (parsed<double>(text) == value)
      return text;
  }
  return formatted(value, 17);
}

std::string scalarText(int value)
{
  return std::to_string(value);
}

std::string scalarText(std::uint64_t value)
{
  return std::to_string(value);
}

std::string scalarText(bool value)
{
  return value ? "true" : "false";
}

std::string scalarText(const std::string& value)
{
  return '"' + value + '"';
}

std::string scalarText(Boundary value)
{
  return choiceText(BOUNDARY_NAMES, value);
}

std::string scalarText(CollapseAction value)
{
  return choiceText(COLLAPSE_ACTION_NAMES, value);
}

std::string scalarText(Method value)
{
  return choiceText(METHOD_NAMES, value);
}

}  // namespace ratchet_sieve
