#include "ratchet_sieve/recording/collision_file.h"

#include <fmt/ostream.h>

namespace ratchet_sieve
{

CollisionFile::CollisionFile(const std::string& path) : AtomicFile(path)
{
  stream() << "time,kind,i,j,normal_speed,normal_impulse,tangential_impulse\n";
}

void CollisionFile::add(const CollisionRecord& record)
{
  fmt::print(stream(), "{},{},{},{},{},{},{}\n", record.time, name(record.kind), record.i,
             record.j ? std::to_string(*record.j) : "", record.normal_speed, record.normal_impulse,
             record.tangential_impulse);
}

ExitFile::ExitFile(const std::string& path) : AtomicFile(path)
{
  stream() << "time,id,species,radius,mass,side,place\n";
}

void ExitFile::add(const ExitRecord& record, const std::vector<SpeciesDefinition>& species)
{
  fmt::print(stream(), "{},{},{},{},{},{},{}\n", record.time, record.id, species[record.species].name,
             record.radius, record.mass, name(record.side), record.place);
}

}  // namespace ratchet_sieve
