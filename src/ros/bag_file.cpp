#include "bag_file.h"

#include <cerrno>
#include <cstring>
#include <tuple>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ratchet_sieve
{
namespace
{
// Upper bounds of what rosbag adds to the messages (wiki.ros.org/Bags/Format/2.0) [bytes].
constexpr std::uint64_t FILE_HEADER = 5 * 1024;  ///< later what is still in the buffer of the C library
constexpr std::uint64_t MESSAGE_HEADER = 64;     ///< and its entry in the chunk's index
constexpr std::uint64_t CONNECTION_HEADER = 256;
constexpr std::uint64_t CHUNK_HEADER = 256;  ///< and its record in the file's index
constexpr std::uint64_t CHUNK_ENTRY = 96;  ///< of a connection: a record of the chunk's index, and its count

/// Reserved in advance, so that the disk is seldom asked [bytes].
constexpr std::uint64_t RESERVED_AHEAD = std::uint64_t{1} << 20;

/// @return 0, or the system's error if the disk is full, a quota is exceeded or a file may not be as large. A
/// file system that cannot set room aside counts as large enough
int setRoomAside(int descriptor, std::uint64_t size)
{
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && size > limit.rlim_cur)
    return EFBIG;
  if (fallocate(descriptor, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(size)) == 0)
    return 0;
  return errno == ENOSPC || errno == EDQUOT || errno == EFBIG ? errno : 0;
}

/// rosbag's destructor closes the bag. Where that fails, it throws and so ends the program: such a bag is
/// never destroyed.
void leave(std::unique_ptr<rosbag::Bag>& bag)
{
  static_cast<void>(bag.release());
}
}  // namespace

BagFile::BagFile(const std::string& path) : lock_(path)
{
  if (const int error = lock_.error())
    throw BagError(error == EAGAIN ? "another program is recording into it" : std::strerror(error));
  try
  {
    if (const int error = reserve(FILE_HEADER))
      throw BagError(std::strerror(error));
    bag_ = std::make_unique<rosbag::Bag>();
    bag_->setCompression(rosbag::compression::LZ4);
    bag_->open(path, rosbag::bagmode::Write);
    reserved_ = 0;  // it has truncated the file
  }
  catch (const std::exception& error)
  {
    leave(bag_);
    unlink(path.c_str());
    throw BagError(error.what());
  }
}

BagFile::~BagFile()
{
  try
  {
    close();
  }
  catch (const BagError&)
  {
    // Whoever wants to know calls close().
  }
}

void BagFile::startMessage(const std::string& topic, const char* definition, ros::Time time,
                           std::uint64_t size)
{
  if (!bag_ || !failure_.empty())
    throw BagError(failure_);
  std::uint64_t bytes = MESSAGE_HEADER + size;
  if (topics_.insert(topic).second)
  {
    const std::uint64_t connection = CONNECTION_HEADER + 2 * topic.size() + std::strlen(definition);
    connections_ += connection;
    bytes += connection;
  }
  divideAt(time);
  if (const int error = makeRoom(bytes))
  {
    failure_ = std::strerror(error);
    throw BagError(failure_);
  }
  written_ += bytes;
  uncompressed_ += bytes;
  end_ = time;
}

/// Messages of one time are in the same chunk, or each in a chunk of its own: they are recovered together.
void BagFile::divideAt(ros::Time time)
{
  if (written_ == 0)
    chunk_start_ = time;
  if (time > end_ && (time - chunk_start_).toSec() >= CHUNK_DURATION)
    endChunk();
  else if (time > end_ && isDivided())
  {
    bag_->setChunkThreshold(CHUNK_SIZE);
    ++chunks_;
  }
  if (isDivided())
  {
    chunk_start_ = time;
    uncompressed_ = 0;
    ++chunks_;
  }
}

/// From here on each message has a chunk of its own, until the threshold is raised. A threshold alone would
/// end the chunk, too, but rosbag then goes on to keep its messages in memory.
void BagFile::endChunk()
{
  bag_->setChunkThreshold(0);
  uncompressed_ = 0;
}

bool BagFile::isDivided() const
{
  return bag_->getChunkThreshold() == 0;
}

/// Sets room aside for a message and for what is written until the bag is closed after it.
/// @return 0 or the system's error
int BagFile::makeRoom(std::uint64_t bytes)
{
  const int error = reserve(largestSize() + bytes);
  if (error == 0 || isDivided())
    return error;
  // An open chunk counts with its full size, and is smaller once it is compressed.
  endChunk();
  ++chunks_;
  return reserve(largestSize() + bytes);
}

/// Upper bound of the size of the file if it were closed now.
std::uint64_t BagFile::largestSize() const
{
  const std::uint64_t chunks = chunks_ + written_ / CHUNK_SIZE;
  return FILE_HEADER + sizeOnDisk() + uncompressed_ + connections_ +
         chunks * (CHUNK_HEADER + CHUNK_ENTRY * topics_.size());
}

/// Sets room aside for a file of this size.
/// @return 0 or the system's error
int BagFile::reserve(std::uint64_t size)
{
  if (size <= reserved_)
    return 0;
  int error = 0;
  for (const std::uint64_t ahead : {RESERVED_AHEAD, std::uint64_t{0}})
  {
    error = setRoomAside(lock_.descriptor(), size + ahead);
    if (error == 0)
    {
      reserved_ = size + ahead;
      break;
    }
  }
  return error;
}

std::uint64_t BagFile::sizeOnDisk() const
{
  struct stat status
  {
  };
  fstat(lock_.descriptor(), &status);
  return static_cast<std::uint64_t>(status.st_size);
}

std::uint64_t BagFile::size() const
{
  return sizeOnDisk() + uncompressed_;
}

void BagFile::abandon(const std::string& reason)
{
  leave(bag_);
  failure_ = reason;
  throw BagError(reason);
}

std::optional<BagFile::Loss> BagFile::close()
{
  if (!bag_ && failure_.empty())
    return std::nullopt;
  if (!bag_)
    throw BagError(failure_);
  try
  {
    bag_->close();
  }
  catch (const ros::Exception& error)
  {
    abandon(error.what());
  }
  bag_.reset();
  // Gives back the room that it did not need. Where that fails, the file is no worse.
  std::ignore = ftruncate(lock_.descriptor(), static_cast<off_t>(sizeOnDisk()));
  if (failure_.empty())
    return std::nullopt;
  return Loss{failure_, end_};
}

}  // namespace ratchet_sieve
