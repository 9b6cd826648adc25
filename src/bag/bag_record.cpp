#include "bag_record.h"

namespace ratchet_sieve
{
namespace
{

/// Longest field that ROS itself reads (ros::Header::parse) [bytes].
constexpr std::size_t LONGEST_FIELD = 1'000'000;

}  // namespace

BagFields::BagFields(std::string_view header)
{
  BagBytes rest(header);
  while (!rest.atEnd())
  {
    const std::string_view field = rest.takeSized();
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos || field.size() > LONGEST_FIELD)
      throw DamagedBag("a record's header has an invalid field");
    if (!values_.emplace(field.substr(0, equals), field.substr(equals + 1)).second)
      throw DamagedBag("a record's header has a field twice");
  }
}

std::string_view BagFields::text(const std::string& name) const
{
  const auto found = values_.find(name);
  if (found == values_.end())
    throw DamagedBag("a record has no field " + name);
  return found->second;
}

void BagRecord::requireOp(BagOp op) const
{
  if (fields.op() != op)
    throw DamagedBag("a record of kind " + std::to_string(static_cast<int>(fields.op())) +
                     " is in place of one of kind " + std::to_string(static_cast<int>(op)) + " has to");
}

std::string_view BagBytes::take(std::size_t count)
{
  if (count > bytes_.size() - position_)
    throw DamagedBag("a record at byte " + std::to_string(position_) + " extends beyond the end");
  const std::string_view taken = bytes_.substr(position_, count);
  position_ += count;
  return taken;
}

std::uint32_t BagBytes::takeNumber()
{
  std::uint32_t number;
  std::memcpy(&number, take(sizeof number).data(), sizeof number);
  return number;
}

std::string_view BagBytes::takeSized()
{
  return take(takeNumber());
}

BagRecord BagBytes::takeRecord()
{
  BagFields fields(takeSized());
  return {std::move(fields), takeSized()};
}

}  // namespace ratchet_sieve
