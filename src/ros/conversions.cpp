#include "ratchet_sieve/ros/conversions.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "ratchet_sieve/core/fields.h"

namespace ratchet_sieve
{
namespace
{
constexpr double LATEST_STAMP = 4294967295.0;  // s

/// Copies a frame into a message, field by field.
struct Writer
{
  template <typename From, typename To>
  void operator()(const FieldInfo&, const From& from, To&& to) const
  {
    if constexpr (IS_OPTIONAL<From>)
    {
      to.value = from.value_or(0.0);
      to.defined = from.has_value();
    }
    else if constexpr (IS_OPTIONAL_LIST<From>)
      for (const auto& value : from)
      {
        to.value.push_back(value.value_or(0.0));
        to.defined.push_back(value.has_value());
      }
    else if constexpr (std::is_enum_v<From>)
      to = static_cast<std::underlying_type_t<From>>(from);
    else
      put(from, to);
  }

private:
  template <typename Value, typename To>
  void put(const Value& from, To& to) const
  {
    to = from;
  }

  template <typename Row, typename RowMessage>
  void put(const std::vector<Row>& from, std::vector<RowMessage>& to) const
  {
    if constexpr (!IS_DESCRIBED<Row>)
      to = from;
    else
    {
      to.resize(from.size());
      for (std::size_t k = 0; k < from.size(); ++k)
        Fields<Row>::each(*this, from[k], to[k]);
    }
  }

  template <typename Row, typename Message>
  void put(const std::vector<Row>& from, Columns<Message>& to) const
  {
    const Row any;
    Fields<Row>::each([&](const FieldInfo&, const auto&, auto& column) { column.resize(from.size()); }, any,
                      to.message);
    for (std::size_t k = 0; k < from.size(); ++k)
      Fields<Row>::each([k](const FieldInfo&, const auto& value, auto& column) { column[k] = value; },
                        from[k], to.message);
    Fields<Row>::each(
        [](const FieldInfo& field, const auto&, auto& column)
        {
          if (field.sparse &&
              std::all_of(column.begin(), column.end(), [](auto value) { return value == 0; }))
            column.clear();
        },
        any, to.message);
  }
};

/// Copies a message into a frame, field by field. All arrays of a message have one entry per disk or per
/// species, but for lists of numbers (commanded values, contacts with each face) and of messages.
class Reader
{
public:
  template <typename To, typename From>
  void operator()(const FieldInfo& field, To& to, const From& from)
  {
    if constexpr (IS_OPTIONAL<To>)
      to = from.defined ? To(from.value) : std::nullopt;
    else if constexpr (IS_OPTIONAL_LIST<To>)
    {
      requireLength(field, from.value.size());
      requireLength(field, from.defined.size());
      for (std::size_t k = 0; k < from.value.size(); ++k)
        to.push_back(from.defined[k] ? std::optional(from.value[k]) : std::nullopt);
    }
    else if constexpr (std::is_enum_v<To>)
      to = commandKind(from);
    else
      get(field, to, from);
  }

private:
  template <typename To, typename Value>
  void get(const FieldInfo&, To& to, const Value& from)
  {
    to = from;
  }

  template <typename Row, typename RowMessage>
  void get(const FieldInfo& field, std::vector<Row>& to, const std::vector<RowMessage>& from)
  {
    if constexpr (!std::is_arithmetic_v<Row> && !IS_DESCRIBED<Row>)
      requireLength(field, from.size());
    if constexpr (!IS_DESCRIBED<Row>)
      to = from;
    else
    {
      to.resize(from.size());
      for (std::size_t k = 0; k < from.size(); ++k)
        Fields<Row>::each(Reader(), to[k], from[k]);
    }
  }

  template <typename Row, typename Message>
  void get(const FieldInfo&, std::vector<Row>& to, const Columns<Message>& from)
  {
    const Row any;
    Fields<Row>::each(
        [this](const FieldInfo& field, const auto&, const auto& column)
        {
          if (!field.sparse || !column.empty())
            requireLength(field, column.size());
        },
        any, from.message);
    to.resize(*length_);
    for (std::size_t k = 0; k < to.size(); ++k)
      Fields<Row>::each(
          [k](const FieldInfo& field, auto& value, const auto& column)
          {
            if (!field.sparse || !column.empty())
              value = column[k];
          },
          to[k], from.message);
  }

  void requireLength(const FieldInfo& field, std::size_t length)
  {
    if (length != length_.value_or(length))
      throw std::invalid_argument(std::string(field.name) + " has " + std::to_string(length) +
                                  " entries, not " + std::to_string(*length_));
    length_ = length;
  }

  static CommandKind commandKind(std::uint8_t kind)
  {
    if (kind >= COMMAND_KINDS)
      throw std::invalid_argument("a command has the kind " + std::to_string(kind) + ", which is unknown");
    return static_cast<CommandKind>(kind);
  }

  std::optional<std::size_t> length_;  ///< of the arrays
};

template <typename Frame>
MessageOf<Frame> messageOf(const Frame& frame, const std::string& frame_id)
{
  MessageOf<Frame> message;
  message.header.stamp = ros::Time(frame.time);
  message.header.frame_id = frame_id;
  Fields<Frame>::each(Writer(), frame, message);
  if constexpr (std::is_same_v<Frame, StatisticsFrame>)
    message.collision_rate = frame.collision_rates.total();
  return message;
}

template <typename Frame>
Frame frameOf(const MessageOf<Frame>& message)
{
  Frame frame;
  Fields<Frame>::each(Reader(), frame, message);
  return frame;
}
}  // namespace

bool isStamp(double time)
{
  return time >= 0.0 && time <= LATEST_STAMP;
}

DiskExit toMessage(const ExitRecord& exit, const std::string& species, const std::string& frame_id)
{
  DiskExit message;
  message.header.stamp = ros::Time(exit.time);
  message.header.frame_id = frame_id;
  message.time = exit.time;
  message.id = exit.id;
  message.species = species;
  message.radius = exit.radius;
  message.mass = exit.mass;
  message.side = name(exit.side);
  message.place = exit.place;
  return message;
}

namespace
{
/// @param bin which of both
BinPurity purityIn(const std::vector<SpeciesShares>& species, BinShares SpeciesShares::*bin)
{
  BinPurity message;
  for (const SpeciesShares& shares : species)
  {
    const auto& [number, mass] = shares.*bin;
    message.purity.push_back(number.purity.value_or(0.0));
    message.purity_by_mass.push_back(mass.purity.value_or(0.0));
    message.purity_defined = number.purity.has_value();
    message.recovery.push_back(number.recovery.value_or(0.0));
    message.recovery_by_mass.push_back(mass.recovery.value_or(0.0));
    message.recovery_defined.push_back(number.recovery.has_value());
  }
  return message;
}
}  // namespace

Purity purityOf(const Simulation& simulation, double window_start, const std::string& frame_id)
{
  const std::vector<SpeciesShares> all = binShares(simulation.bins());
  const ExitWindow window = simulation.exitWindow(window_start);
  const std::vector<SpeciesShares> lately = binShares(window.bins);
  Purity message;
  message.header.stamp = ros::Time(simulation.time());
  message.header.frame_id = frame_id;
  message.time = simulation.time();
  message.species = speciesNames(simulation.scene());
  message.left = purityIn(all, &SpeciesShares::left);
  message.right = purityIn(all, &SpeciesShares::right);
  message.window_start = window.start;
  message.window_left = purityIn(lately, &SpeciesShares::left);
  message.window_right = purityIn(lately, &SpeciesShares::right);
  return message;
}

/// The conversions of one kind in both directions, by the list of its fields.
#define RATCHET_SIEVE_CONVERSIONS(FRAME, MESSAGE)                    \
  MESSAGE toMessage(const FRAME& frame, const std::string& frame_id) \
  {                                                                  \
    return messageOf(frame, frame_id);                               \
  }                                                                  \
  FRAME toFrame(const MESSAGE& message)                              \
  {                                                                  \
    return frameOf<FRAME>(message);                                  \
  }
RATCHET_SIEVE_CONVERSIONS(SceneFrame, SceneDescription)
RATCHET_SIEVE_CONVERSIONS(ParticleFrame, ParticleStates)
RATCHET_SIEVE_CONVERSIONS(BinFrame, BinCounts)
RATCHET_SIEVE_CONVERSIONS(BaseFrame, BaseState)
RATCHET_SIEVE_CONVERSIONS(StatisticsFrame, SieveStatistics)
RATCHET_SIEVE_CONVERSIONS(ObservedFrame, Observations)
RATCHET_SIEVE_CONVERSIONS(CommandFrame, Command)

}  // namespace ratchet_sieve
