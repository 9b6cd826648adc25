#include "ratchet_sieve/recording/collision_file.h"

#include <iterator>

#include <fmt/format.h>

namespace ratchet_sieve
{
namespace
{

/// Lines are collected up to this size, so that the cost of writing is small [bytes].
constexpr std::size_t FLUSH_SIZE = 1u << 20;

}  // namespace

CollisionFile::CollisionFile(const std::string& path)
    : file_(path), lines_("time,kind,i,j,normal_speed,normal_impulse,tangential_impulse\n")
{
}

void CollisionFile::add(const CollisionRecord& record)
{
  const auto out = std::back_inserter(lines_);
  fmt::format_to(out, "{},{},{},", record.time, name(record.kind), record.i);
  if (record.j)
    fmt::format_to(out, "{}", *record.j);
  fmt::format_to(out, ",{},{},{}\n", record.normal_speed, record.normal_impulse, record.tangential_impulse);
  if (lines_.size() >= FLUSH_SIZE)
    flush();
}

void CollisionFile::flush()
{
  file_.stream() << lines_;
  lines_.clear();
}

void CollisionFile::commit()
{
  flush();
  file_.commit();
}

}  // namespace ratchet_sieve
