#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <zlib.h>

#include "motion_encoding.h"
#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

inline std::string inflated(const std::string& bytes)
{
  std::string result(1000 * bytes.size() + 100'000, '\0');
  uLongf length = result.size();
  if (uncompress(reinterpret_cast<Bytef*>(result.data()), &length,
                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK)
    throw std::runtime_error("no zlib data");
  result.resize(length);
  return result;
}

/// Columns as bytePlanes() writes them, one after the other.
class PlaneReader
{
public:
  explicit PlaneReader(std::string bytes) : bytes_(std::move(bytes)) {}

  std::vector<std::int32_t> next(std::size_t rows)
  {
    std::vector<std::int32_t> column;
    for (std::size_t k = 0; k < rows; ++k)
    {
      std::uint32_t zigzag = 0;
      for (unsigned plane = 0; plane < 4; ++plane)
        zigzag |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_.at(place_ + plane * rows + k)))
                  << 8U * plane;
      column.push_back(static_cast<std::int32_t>((zigzag >> 1U) ^ (0U - (zigzag & 1U))));
    }
    place_ += 4 * rows;
    return column;
  }

  std::vector<double> nextDoubles(std::size_t rows)
  {
    std::vector<double> column(rows);
    for (std::size_t k = 0; k < rows; ++k)
    {
      std::uint64_t bits = 0;
      for (unsigned plane = 0; plane < 8; ++plane)
        bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_.at(place_ + plane * rows + k)))
                << 8U * plane;
      std::memcpy(&column[k], &bits, sizeof bits);
    }
    place_ += 8 * rows;
    return column;
  }

  bool atEnd() const { return place_ == bytes_.size(); }

private:
  std::string bytes_;
  std::size_t place_ = 0;
};

/// The frames of an encoded motion, with displacement 0 and the disks in order of their tracks.
inline std::vector<ParticleFrame> framesOf(const EncodedMotion& encoded)
{
  const auto& description = encoded.description;
  std::vector<ParticleFrame> frames;
  PlaneReader columns(inflated(encoded.bytes));
  for (const double time : columns.nextDoubles(description["frames"]))
    frames.push_back({time, {}});
  const std::size_t tracks = description["tracks"];
  const std::size_t states = description["states"];
  const auto id = columns.next(tracks), species = columns.next(tracks), radius = columns.next(tracks);
  const auto first = columns.next(tracks), length = columns.next(tracks);
  const auto vx = columns.next(states), vy = columns.next(states), x = columns.next(states);
  const auto y = columns.next(states), spin = columns.next(states), angle = columns.next(states);
  if (!columns.atEnd())
    throw std::runtime_error("more columns than described");
  const double position_unit = description["position_unit"];
  const double velocity_unit = description["velocity_unit"];
  const double turn = 6.283185307179586 / description["angle_steps"].get<double>();
  std::size_t k = 0;
  for (std::size_t track = 0; track < tracks; ++track)
  {
    double x_now = 0.0, y_now = 0.0, angle_now = 0.0;
    for (int i = 0; i < length[track]; ++i, ++k)
    {
      const auto frame = static_cast<std::size_t>(first[track] + i);
      const double factor = i > 0 ? (frames[frame].time - frames[frame - 1].time) *
                                        description["positions_per_velocity"].get<double>()
                                  : 0.0;
      x_now += x[k] + (i > 0 ? std::floor(0.5 * (vx[k] + vx[k - 1]) * factor + 0.5) : 0.0);
      y_now += y[k] + (i > 0 ? std::floor(0.5 * (vy[k] + vy[k - 1]) * factor + 0.5) : 0.0);
      angle_now += angle[k];
      DiskState disk;
      disk.id = static_cast<std::uint32_t>(id[track]);
      disk.species = static_cast<std::uint32_t>(species[track]);
      disk.radius = radius[track] * description["radius_unit"].get<double>();
      disk.x = position_unit * x_now;
      disk.y = position_unit * y_now;
      disk.vx = velocity_unit * vx[k];
      disk.vy = velocity_unit * vy[k];
      disk.spin = spin[k] * description["spin_unit"].get<double>();
      disk.angle = turn * angle_now;
      frames[frame].disks.push_back(disk);
    }
  }
  return frames;
}

}  // namespace ratchet_sieve
