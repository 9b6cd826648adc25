#include "ratchet_sieve/recording/distinct_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{
namespace
{

std::filesystem::path placeOf(const std::string& path)
{
  std::error_code ignored;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(linkTarget(path), ignored), ignored);
}

bool isSameFile(const std::string& one, const std::string& other)
{
  std::error_code error;
  const bool same = std::filesystem::equivalent(one, other, error);
  return error ? placeOf(one) == placeOf(other) : same;
}

/// Whether it can be lost: a device or a pipe cannot.
bool isFile(const NamedFile& file)
{
  std::error_code ignored;
  return !file.path.empty() && !std::filesystem::is_other(file.path, ignored);
}

void requireOthers(const NamedFile& output, const std::vector<NamedFile>& files)
{
  for (const NamedFile& file : files)
    if (isFile(file) && isFile(output) && isSameFile(file.path, output.path))
      throw SameFileError(output.name + ' ' + output.path + ": is the file of " + file.name +
                          "; must be another one");
}

}  // namespace

void requireDistinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs)
{
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    requireOthers(outputs[k], inputs);
    requireOthers(outputs[k], {outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(k)});
  }
}

std::vector<NamedFile> outputsInFolder(const NamedFile& folder, const std::vector<NamedFile>& files,
                                       const std::vector<std::string>& written)
{
  std::vector<NamedFile> outputs;
  for (const NamedFile& file : files)
  {
    const std::string name = '/' + std::filesystem::path(file.path).filename().string();
    const auto ends_so = [&name](const std::string& ending)
    {
      return name.size() >= ending.size() &&
             name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    };
    if (!folder.path.empty() && std::any_of(written.begin(), written.end(), ends_so))
      outputs.push_back({folder.name, folder.path + name});
  }
  return outputs;
}

}  // namespace ratchet_sieve
