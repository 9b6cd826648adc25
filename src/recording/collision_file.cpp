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

EventFile::EventFile(const std::string& path, const std::string& header) : file_(path), lines_(header + '\n')
{
}

template <typename... Values>
void EventFile::addLine(const char* format, const Values&... values)
{
  fmt::format_to(std::back_inserter(lines_), fmt::runtime(format), values...);
  if (lines_.size() >= FLUSH_SIZE)
    flush();
}

void EventFile::flush()
{
  file_.stream() << lines_;
  lines_.clear();
}

void EventFile::commit()
{
  flush();
  file_.commit();
}

CollisionFile::CollisionFile(const std::string& path)
    : EventFile(path, "time,kind,i,j,normal_speed,normal_impulse,tangential_impulse")
{
}

void CollisionFile::add(const CollisionRecord& record)
{
  addLine("{},{},{},{},{},{},{}\n", record.time, name(record.kind), record.i,
          record.j ? std::to_string(*record.j) : "", record.normal_speed, record.normal_impulse,
          record.tangential_impulse);
}

ExitFile::ExitFile(const std::string& path) : EventFile(path, "time,id,species,radius,mass,side,place") {}

void ExitFile::add(const ExitRecord& record, const std::vector<SpeciesDefinition>& species)
{
  addLine("{},{},{},{},{},{},{}\n", record.time, record.id, species[record.species].name, record.radius,
          record.mass, name(record.side), record.place);
}

}  // namespace ratchet_sieve
