#pragma once

#include <string>
#include <string_view>

#include "bag_record.h"

namespace ratchet_sieve
{

/// A number in a bag: its bytes, little-endian, as on the supported machines.
template <typename Number>
std::string bytesOf(Number number)
{
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// The named fields of a header, as BagFields reads them.
class FieldText
{
public:
  FieldText() = default;
  explicit FieldText(BagOp op) { add("op", bytesOf(op)); }

  FieldText& add(const std::string& name, std::string_view value)
  {
    text_ += bytesOf(static_cast<std::uint32_t>(name.size() + 1 + value.size()));
    text_.append(name).append("=").append(value);
    return *this;
  }

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

/// A length of 32 bits, and this many bytes.
inline void appendSized(std::string& to, std::string_view bytes)
{
  to += bytesOf(static_cast<std::uint32_t>(bytes.size()));
  to += bytes;
}

/// A complete record, as BagBytes::takeRecord() reads it.
inline void appendRecord(std::string& to, const FieldText& fields, std::string_view bytes)
{
  appendSized(to, fields.text());
  appendSized(to, bytes);
}

}  // namespace ratchet_sieve
