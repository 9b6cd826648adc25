#pragma once

#include <filesystem>
#include <string>

/// The names of a trajectory's files.
namespace ratchet_sieve
{

/// run.xyz, _base -> run_base.xyz
inline std::string withSuffix(const std::string& path, const std::string& suffix, const std::string& ending)
{
  const std::filesystem::path whole(path);
  return (whole.parent_path() / (whole.stem().string() + suffix + ending)).string();
}

/// The file of the base of a trajectory.
inline std::string basePath(const std::string& path)
{
  return withSuffix(path, "_base", std::filesystem::path(path).extension().string());
}

/// The folder of the frames of a trajectory that has one file for each.
inline std::string framesPath(const std::string& path)
{
  return withSuffix(path, "_frames", "");
}

}  // namespace ratchet_sieve
