#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <tuple>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "ratchet_sieve/scene/canonical_scene.h"
#include "scene_texts.h"

namespace ratchet_sieve
{
namespace
{

const char* const HEADER = "time,id,species,radius,mass,side,place\n";

/// The good scene in a file, fed from what is in a file beside it.
class FeedFile : public testing::Test
{
protected:
  FeedFile()
  {
    std::filesystem::create_directory(folder_);
    std::filesystem::create_directory(folder_ / "runs");
  }
  ~FeedFile() override { std::filesystem::remove_all(folder_); }

  SceneDefinition read(const std::string& rows, const std::string& feed = "{file: runs/exits.csv}") const
  {
    std::ofstream(folder_ / "runs/exits.csv", std::ios::binary) << rows;
    std::ofstream(folder_ / "s.yaml") << goodSceneWith("{rate: 0.0}", feed);
    return loadSceneFile(folder_ / "s.yaml").definition;
  }

  /// What is said against it, without the folder.
  std::string refusal(const std::string& rows, const std::string& feed = "{file: runs/exits.csv}") const
  {
    std::string line = refusalBy([&] { read(rows, feed); });
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
      line.erase(at, prefix.size());
    return line;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("feed_file_test." + std::to_string(getpid()));
};

TEST_F(FeedFile, IsReadIntoTheSceneInTheOrderOfTime)
{
  const SceneDefinition scene =
      read(std::string(HEADER) +
           "2.5,7,B,0.0021,0.003,right,0.4\r\n0.1,3,A,0.0011,0.0013333333333333335,left,0\n");
  ASSERT_EQ(scene.feed.disks.size(), 2u);
  EXPECT_EQ(scene.feed.disks[0].time, 0.1);
  EXPECT_EQ(scene.feed.disks[0].species, 0u);
  EXPECT_EQ(scene.feed.disks[0].radius, 0.0011);
  EXPECT_EQ(scene.feed.disks[0].mass, 0.0013333333333333335);
  EXPECT_EQ(scene.feed.disks[1].time, 2.5);
  EXPECT_EQ(scene.feed.disks[1].species, 1u);
}

TEST_F(FeedFile, IsNotNeededToReadTheCanonicalSceneAgain)
{
  const SceneDefinition scene = read(std::string(HEADER) + "0.1,3,A,0.0011,0.0013333333333333335,left,0\n");
  const std::string text = canonicalYaml(scene);
  EXPECT_NE(text.find("feed: {rate: 0, disks: [{species: \"A\", time: 0.1, radius: 0.0011, mass: "
                      "0.0013333333333333335}]}\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(canonicalYaml(sceneFromText(text, "again").definition), text);
  EXPECT_NE(sceneHash(scene), sceneHash(read(HEADER)));
}

/// As write.csv() and write.csv2() of R, spreadsheets and people write it.
TEST_F(FeedFile, IsReadWithQuotesBlanksAndSemicolons)
{
  for (const char* rows :
       {"\"\",\"time\",\"species\",\"radius\",\"mass\",\"side\"\n\"1\",2.5,\"B\",0.0021,0.003,\"left\"\n",
        "time, species, radius, mass, side\r\n2.5, B, 0.0021, 0.003, left\r\n",
        "time;species;radius;mass;side\n2.5;B;0.0021;0.003;left\n",
        "\"note, or \"\"none\"\"\",\"time\",species,radius,mass,side\n\"a, "
        "b\",\"2.5\",B,0.0021,0.003,left\n"})
  {
    const SceneDefinition scene = read(rows, "{file: runs/exits.csv, side: left}");
    ASSERT_EQ(scene.feed.disks.size(), 1u) << rows;
    const FedDisk& disk = scene.feed.disks[0];
    EXPECT_EQ(std::tie(disk.time, disk.species, disk.radius, disk.mass),
              std::make_tuple(2.5, std::size_t{1}, 0.0021, 0.003))
        << rows;
  }
  EXPECT_EQ(refusal("\"time\";\"species\";\"radius\";\"mass\"\n2,5;\"B\";0,0021;0,003\n"),
            "runs/exits.csv:2: time = 2,5: must be a number from 0 to 1000000000 s");
}

/// Nothing is wrong with what is in the file.
TEST_F(FeedFile, IsRefusedWithTheReasonWhereItCannotBeOpened)
{
  read(HEADER);
  const std::string path = folder_ / "runs/exits.csv";
  EXPECT_EQ(whyUnreadable(path), std::nullopt);
  rlimit limit;
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  const rlimit none = {0, limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  const std::optional<std::string> why = whyUnreadable(path);
  setrlimit(RLIMIT_NOFILE, &limit);
  EXPECT_EQ(why, "Too many open files");
}

TEST_F(FeedFile, GivesTheRowsOfItsSideAlone)
{
  const std::string rows = std::string(HEADER) + "1,1,A,0.001,0.001,left,0\n2,2,B,0.001,0.001,right,0\n";
  EXPECT_EQ(read(rows).feed.disks.size(), 2u);
  const SceneDefinition right = read(rows, "{file: runs/exits.csv, side: right}");
  ASSERT_EQ(right.feed.disks.size(), 1u);
  EXPECT_EQ(right.feed.disks[0].time, 2.0);
  EXPECT_EQ(read("radius,mass,species,time\n0.001,0.002,A,3\n").feed.disks.at(0).mass, 0.002);
}

TEST_F(FeedFile, ReplacesTheCountsOfTheSpecies)
{
  const std::string text = goodSceneWith("count: 10, radius: 0.001", "radius: 0.001");
  EXPECT_EQ(refusalOf(text), "s.yaml:4: species.0.count: missing");
  EXPECT_EQ(sceneFromText(text, "s.yaml", {"feed.disks=[{time: 1, species: A, radius: 0.001, mass: 0.001}]"})
                .definition.species[0]
                .count,
            0);
}

TEST_F(FeedFile, IsRefusedByFileLineValueAndWhatIsAllowed)
{
  const std::string header = HEADER;
  EXPECT_EQ(refusal("", "{file: none.csv}"), "s.yaml:8: feed.file = none.csv: no such file: none.csv");
  EXPECT_EQ(refusal("time,species,radius\n"),
            "runs/exits.csv:1: header: its first line has no column mass; must be a CSV file as sieve_run "
            "--exits writes");
  EXPECT_EQ(refusal("time,species,radius,mass\n", "{file: runs/exits.csv, side: left}"),
            "runs/exits.csv:1: header: its first line has no column side; must be a CSV file as sieve_run "
            "--exits writes");
  EXPECT_EQ(refusal(header + "1,1,A,0.001,0.001,left,0\n1,1,A,0.001\n"),
            "runs/exits.csv:3: row: must have 7 cells, as the header");
  EXPECT_EQ(refusal(header + "1,1,A,wide,0.001,left,0\n"),
            "runs/exits.csv:2: radius = wide: must be a number from 1e-09 to 1000 m");
  EXPECT_EQ(refusal(header + "1,1,A,,0.001,left,0\n"),
            "runs/exits.csv:2: radius = : must be a number from 1e-09 to 1000 m");
  EXPECT_EQ(refusal(header + "-1,1,A,0.001,0.001,left,0\n"),
            "runs/exits.csv:2: time = -1: must be a number from 0 to 1000000000 s");
  EXPECT_EQ(refusal(header + "1,1,C,0.001,0.001,left,0\n"),
            "runs/exits.csv:2: species = C: unknown species; must be one of A, B");
  EXPECT_EQ(refusal(header + "1,1,A,0.001,0.001,up,0\n", "{file: runs/exits.csv, side: left}"),
            "runs/exits.csv:2: side = up: must be left or right");
  EXPECT_EQ(refusal(header, "{file: runs/exits.csv, side: both}"),
            "s.yaml:8: feed.side = both: must be left or right");
}

TEST_F(FeedFile, ExcludesOtherFeeds)
{
  const std::string row = std::string(HEADER) + "1,1,A,0.001,0.001,left,0\n";
  EXPECT_EQ(refusal(row, "{file: runs/exits.csv, rate: 3}"),
            "s.yaml:8: feed.rate = 3: must be 0 or absent because a list gives the disks and their times");
  EXPECT_EQ(refusal(row, "{file: runs/exits.csv, disks: []}"),
            "s.yaml:8: feed.disks: must be absent because feed.file gives the disks");
  EXPECT_EQ(refusal(row, "{side: left}"), "s.yaml:8: feed.side: needs feed.file");
  EXPECT_EQ(refusal(row, "{disks: [{time: 1, species: A, radius: 0.3, mass: 1}]}"),
            "s.yaml:8: feed.disks: the disk of radius 0.3 m fed at 1 s is wider than the base, 0.4 m");
  EXPECT_EQ(refusal(row, "{disks: [{time: 1, species: A, radius: 0.01}]}"),
            "s.yaml:8: feed.disks.0.mass: missing");
}

}  // namespace
}  // namespace ratchet_sieve
