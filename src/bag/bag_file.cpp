#include "ratchet_sieve/bag/bag_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <roslz4/lz4s.h>
#include <sys/file.h>
#include <unistd.h>

#include "bag_record.h"
#include "record_text.h"

namespace ratchet_sieve
{
namespace
{
/// Fixed size of the file's header, so that it can be overwritten in place [bytes].
constexpr std::size_t HEAD_SIZE = 4096;

/// Blocks of 1 MiB, as in rosbag; incompressible blocks are stored uncompressed.
constexpr int BLOCK_SIZE = 6;
constexpr std::size_t BLOCK_HEAD = 4;   // bytes
constexpr std::size_t FRAME_HEAD = 64;  // bytes, an upper bound

/// Errors for a full disk, an exceeded quota or the largest file size: a smaller write might fit.
bool isFull(int error)
{
  return error == ENOSPC || error == EDQUOT || error == EFBIG;
}

/// Chunks are removed for the index up to the size of the index plus this reserve, because other programs may
/// use up space at the same time [bytes].
constexpr std::uint64_t ROOM_BESIDE = std::uint64_t{1} << 20;

std::string stampBytes(ros::Time time)
{
  return bytesOf(time.sec) + bytesOf(time.nsec);
}

/// Tries a lock that the kernel releases when the program ends in any way. File systems without locks always
/// grant it.
bool refusesLock(int descriptor, int kind)
{
  return flock(descriptor, kind | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

bool BagFile::isBeingWritten(const std::string& path)
{
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  // A file that cannot be opened for the check is assumed to be being written.
  if (descriptor < 0)
    return errno != ENOENT;
  const bool refused = refusesLock(descriptor, LOCK_SH);
  ::close(descriptor);
  return refused;
}

BagFile::BagFile(const std::string& path)
    : descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666))
{
  if (descriptor_ < 0)
    throw BagError(std::strerror(errno));
  if (refusesLock(descriptor_, LOCK_EX))
  {
    ::close(descriptor_);
    throw BagError("another program is recording into it");
  }
  try
  {
    // Only a regular file can be truncated.
    if (ftruncate(descriptor_, 0) != 0 && errno != EINVAL)
      fail(errno);
    const std::string head = std::string(VERSION_LINE) + headRecord(0);
    writeAt(0, head);
    end_ = head.size();
  }
  catch (const BagError&)
  {
    ::close(descriptor_);
    unlink(path.c_str());
    throw;
  }
}

BagFile::~BagFile()
{
  if (stored_.valid())
    stored_.wait();
  for (const int descriptor : {descriptor_, lock_})
    if (descriptor >= 0)
      ::close(descriptor);
}

void BagFile::startMessage(ros::Time time)
{
  if (failure_ != 0)
    fail(failure_);
  if (!filling_.bytes.empty() && (time - filling_.start).toSec() >= CHUNK_DURATION)
    endChunk();
  if (filling_.bytes.empty())
    filling_.start = time;
}

std::uint32_t BagFile::connectionOf(const Connection& connection)
{
  const auto found =
      std::find_if(connections_.begin(), connections_.end(),
                   [&](const Connection& candidate) { return candidate.topic == connection.topic; });
  const auto id = static_cast<std::uint32_t>(found - connections_.begin());
  if (found != connections_.end())
    return id;
  connections_.push_back(connection);
  // Before its first message, for `rosbag reindex`.
  filling_.bytes += connectionRecord(id);
  return id;
}

void BagFile::finishMessage(std::uint32_t connection, ros::Time time)
{
  filling_.end = time;
  filling_.index.resize(connections_.size());
  filling_.index[connection].push_back({time, static_cast<std::uint32_t>(filling_.bytes.size())});
  appendRecord(filling_.bytes,
               FieldText(BagOp::MESSAGE).add("conn", bytesOf(connection)).add("time", stampBytes(time)),
               {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()});
  if (filling_.bytes.size() >= CHUNK_SIZE)
    endChunk();
}

/// Compresses storing_ into packed_.
void BagFile::pack()
{
  std::string& bytes = storing_.bytes;
  const std::size_t blocks =
      bytes.size() / static_cast<std::size_t>(roslz4_blockSizeFromIndex(BLOCK_SIZE)) + 1;
  packed_.resize(bytes.size() + blocks * BLOCK_HEAD + FRAME_HEAD);
  auto size = static_cast<unsigned int>(packed_.size());
  if (roslz4_buffToBuffCompress(bytes.data(), static_cast<unsigned int>(bytes.size()), packed_.data(), &size,
                                BLOCK_SIZE) != ROSLZ4_OK)
    fail(ENOMEM);
  packed_.resize(size);
}

/// The records of a chunk's index.
/// @param counts takes the number of messages per connection, in the format of the file's index
/// @return number of connections with messages
std::uint32_t BagFile::appendIndexes(std::string& to, std::string& counts) const
{
  std::uint32_t connections = 0;
  for (std::uint32_t connection = 0; connection < storing_.index.size(); ++connection)
  {
    const std::vector<IndexEntry>& entries = storing_.index[connection];
    if (entries.empty())
      continue;
    std::string bytes;
    for (const IndexEntry& entry : entries)
      bytes += stampBytes(entry.time) + bytesOf(entry.offset);
    const auto count = static_cast<std::uint32_t>(entries.size());
    appendRecord(to,
                 FieldText(BagOp::INDEX)
                     .add("ver", bytesOf(INDEX_VERSION))
                     .add("conn", bytesOf(connection))
                     .add("count", bytesOf(count)),
                 bytes);
    counts += bytesOf(connection) + bytesOf(count);
    ++connections;
  }
  return connections;
}

void BagFile::Content::clear()
{
  bytes.clear();
  for (std::vector<IndexEntry>& entries : index)
    entries.clear();
}

/// Without a free thread the chunk is stored by the caller, at the latest when the next one is finished.
void BagFile::endChunk()
{
  if (filling_.bytes.empty())
    return;
  waitForStoring();
  std::swap(filling_, storing_);
  filling_.clear();
  stored_ = std::async(&BagFile::store, this);
}

/// @throws BagError if it failed
void BagFile::waitForStoring()
{
  if (stored_.valid())
    stored_.get();
}

std::uint64_t BagFile::size() const
{
  if (stored_.valid())
    stored_.wait();
  return end_ + filling_.bytes.size();
}

/// Writes storing_ to the end of the file.
void BagFile::store()
{
  pack();
  record_.clear();
  appendRecord(record_,
               FieldText(BagOp::CHUNK)
                   .add("compression", "lz4")
                   .add("size", bytesOf(static_cast<std::uint32_t>(storing_.bytes.size()))),
               packed_);
  std::string counts;
  const std::uint32_t connections = appendIndexes(record_, counts);
  writeAt(end_, record_);

  chunks_.push_back({end_, storing_.end, chunk_infos_.size()});
  appendRecord(chunk_infos_,
               FieldText(BagOp::CHUNK_INFO)
                   .add("ver", bytesOf(CHUNK_INFO_VERSION))
                   .add("chunk_pos", bytesOf(end_))
                   .add("start_time", stampBytes(storing_.start))
                   .add("end_time", stampBytes(storing_.end))
                   .add("count", bytesOf(connections)),
               counts);
  end_ += record_.size();
}

std::string BagFile::headRecord(std::uint64_t index_position) const
{
  const FieldText fields = FieldText(BagOp::FILE_HEADER)
                               .add("index_pos", bytesOf(index_position))
                               .add("conn_count", bytesOf(std::uint32_t(connections_.size())))
                               .add("chunk_count", bytesOf(std::uint32_t(chunks_.size())));
  std::string record;
  appendRecord(record, fields, std::string(HEAD_SIZE - fields.text().size(), ' '));
  return record;
}

std::string BagFile::connectionRecord(std::uint32_t id) const
{
  const Connection& connection = connections_[id];
  FieldText header;
  header.add("topic", connection.topic)
      .add("type", connection.type)
      .add("md5sum", connection.md5sum)
      .add("message_definition", connection.definition);
  if (connection.latched)
    header.add("latching", "1");
  std::string record;
  appendRecord(record, FieldText(BagOp::CONNECTION).add("conn", bytesOf(id)).add("topic", connection.topic),
               header.text());
  return record;
}

std::string BagFile::indexOfFile() const
{
  std::string index;
  for (std::uint32_t id = 0; id < connections_.size(); ++id)
    index += connectionRecord(id);
  return index + chunk_infos_;
}

void BagFile::writeAt(std::uint64_t position, const std::string& bytes)
{
  std::size_t done = 0;
  while (done < bytes.size())
  {
    const ssize_t written =
        pwrite(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(position + done));
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      fail(written < 0 ? errno : ENOSPC);
    done += static_cast<std::size_t>(written);
  }
}

void BagFile::fail(int error)
{
  failure_ = error;
  throw BagError(std::strerror(error));
}

void BagFile::writeIndex()
{
  // Without messages no connections are indexed, so that the index fits on a disk where nothing else does.
  if (chunks_.empty())
    connections_.clear();
  // Remove the partial chunk, which takes up space.
  if (ftruncate(descriptor_, static_cast<off_t>(end_)) != 0)
    fail(errno);
  writeAt(end_, indexOfFile());
  // The header refers to the index only after the index was written.
  writeAt(VERSION_LINE.size(), headRecord(end_));
}

void BagFile::makeIndex()
{
  const std::uint64_t least = end_ - std::min(end_, indexOfFile().size() + ROOM_BESIDE);
  while (true)
  {
    try
    {
      return writeIndex();
    }
    catch (const BagError&)
    {
      if (!isFull(failure_) || chunks_.empty() || chunks_.back().position < least)
        throw;
      end_ = chunks_.back().position;
      chunk_infos_.resize(chunks_.back().info_offset);
      chunks_.pop_back();
    }
  }
}

std::optional<BagFile::Loss> BagFile::close()
{
  if (descriptor_ < 0)
    return std::nullopt;
  try
  {
    if (failure_ == 0)
      endChunk();
    waitForStoring();
  }
  catch (const BagError&)
  {
    // Reported below, after the index was written.
  }
  makeIndex();
  // Another descriptor of the same file keeps its lock.
  lock_ = fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  // Some file systems report write errors only here.
  const int closed = ::close(std::exchange(descriptor_, -1));
  if (closed != 0)
    fail(errno);
  if (failure_ == 0)
    return std::nullopt;
  return Loss{std::strerror(failure_), chunks_.empty() ? ros::Time() : chunks_.back().end};
}

}  // namespace ratchet_sieve
