#include "ratchet_sieve/recording/collision_file.h"

#include <fmt/format.h>

namespace ratchet_sieve
{
namespace
{

/// Lines are collected up to this size, so that the cost of writing is small [bytes].
constexpr std::size_t FLUSH_SIZE = 1u << 20;

}  // namespace

struct CollisionFile::Buffer
{
  fmt::memory_buffer text;
};

CollisionFile::CollisionFile(const std::string& path) : file_(path), buffer_(std::make_unique<Buffer>())
{
  file_.stream() << "time,kind,i,j,normal_speed,normal_impulse,tangential_impulse\n";
}

CollisionFile::~CollisionFile() = default;

void CollisionFile::take(const CollisionRecord& record)
{
  const auto out = std::back_inserter(buffer_->text);
  fmt::format_to(out, "{},{},{},", record.time, name(record.kind), record.i);
  if (record.j)
    fmt::format_to(out, "{}", *record.j);
  fmt::format_to(out, ",{},{},{}\n", record.normal_speed, record.normal_impulse, record.tangential_impulse);
  if (buffer_->text.size() >= FLUSH_SIZE)
    flush();
}

void CollisionFile::flush()
{
  file_.stream().write(buffer_->text.data(), static_cast<std::streamsize>(buffer_->text.size()));
  buffer_->text.clear();
}

void CollisionFile::commit()
{
  flush();
  file_.commit();
}

}  // namespace ratchet_sieve
