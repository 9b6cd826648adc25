#include "ratchet_sieve/recording/collision_file.h"

#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    parts.push_back(part);
  return parts;
}

std::vector<std::string> linesOf(const std::vector<CollisionRecord>& records)
{
  const ScratchDirectory directory;
  CollisionFile file(directory / "collisions.csv");
  for (const CollisionRecord& record : records)
    file.add(record);
  file.commit();
  return split(contents(directory / "collisions.csv"), '\n');
}

TEST(CollisionFile, LeavesThePartnerEmptyForTheBase)
{
  const std::vector<std::string> lines =
      linesOf({{0.25, CollisionKind::DISK_DISK, 1, 2, 0.5, 0.125, -0.0625},
               {0.5, CollisionKind::LEFT_SLOPE, 3, std::nullopt, 1.5, 2.0, 0.0}});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "time,kind,i,j,normal_speed,normal_impulse,tangential_impulse");
  EXPECT_EQ(lines[1], "0.25,disk_disk,1,2,0.5,0.125,-0.0625");
  EXPECT_EQ(split(lines[2], ',')[1], "left_slope");
  EXPECT_EQ(split(lines[2], ',')[3], "");
}

RC_GTEST_PROP(CollisionFile, HoldsNumbersThatReadBackBitForBit, (const std::vector<double>& numbers))
{
  std::vector<CollisionRecord> records;
  for (const double number : numbers)
    if (std::isfinite(number))
      records.push_back({number, CollisionKind::APEX, 0, std::nullopt, number / 3.0, number * 0.1, -number});
  const std::vector<std::string> lines = linesOf(records);
  RC_ASSERT(lines.size() == records.size() + 1);
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    const std::vector<std::string> fields = split(lines[i + 1], ',');
    RC_ASSERT(std::strtod(fields[0].c_str(), nullptr) == records[i].time);
    RC_ASSERT(std::strtod(fields[4].c_str(), nullptr) == records[i].normal_speed);
    RC_ASSERT(std::strtod(fields[5].c_str(), nullptr) == records[i].normal_impulse);
    RC_ASSERT(std::strtod(fields[6].c_str(), nullptr) == records[i].tangential_impulse);
  }
}

TEST(ExitFile, NamesSpeciesAndSidesAndHoldsNumbersThatReadBack)
{
  const ScratchDirectory directory;
  ExitFile file(directory / "exits.csv");
  std::vector<SpeciesDefinition> species(2);
  species[0].name = "glass";
  species[1].name = "rubber";
  file.add({1.0 / 3.0, 7, 1, 0.001, 2e-6, Exit::RIGHT_BIN, -0.0625}, species);
  file.add({0.5, 8, 0, 0.001, 2e-6, Exit::LEFT_BIN, 0.5}, species);
  file.commit();
  EXPECT_EQ(contents(directory / "exits.csv"),
            "time,id,species,radius,mass,side,place\n"
            "0.3333333333333333,7,rubber,0.001,2e-06,right,-0.0625\n"
            "0.5,8,glass,0.001,2e-06,left,0.5\n");
}

}  // namespace
}  // namespace ratchet_sieve
