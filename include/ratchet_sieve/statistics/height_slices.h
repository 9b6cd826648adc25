#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ratchet_sieve
{

/// Part of a flight, seen from the base: its velocity changes at a constant rate.
struct SeenFlight
{
  double duration;                       ///< > 0 [s]
  std::array<double, 2> height;          ///< at its start and its end [m]
  std::array<double, 2> along, upwards;  ///< velocity along the base and normal to it, at both [m/s]
  double weight;                         ///< of the disk: its mass in units of its species'
};

/// Integrals over time of the disks of one species, by the slice of height in which they are and by the part
/// of the drive's period. Each slice is of the same height; exact for a SeenFlight.
class HeightSlices
{
public:
  /// Disks above this many slices are counted as above.
  static constexpr std::size_t MOST = 1000;

  /// Over the disks and the time that they spend in a slice.
  struct Sums
  {
    double time = 0.0;     ///< [s]
    double weight = 0.0;   ///< of the weight [s]
    double along = 0.0;    ///< of weight and velocity [m]
    double upwards = 0.0;  ///< of weight and velocity [m]
    double squared = 0.0;  ///< of weight and velocity squared [m^2/s]

    Sums& operator+=(const Sums& other);

    /// The mean over the disks of their weight times the square of their velocity relative to that of their
    /// centre of mass [m^2/s^2]. @pre time > 0
    double variance() const;

    template <typename Archive>
    void archive(Archive& state)
    {
      state(time, weight, along, upwards, squared);
    }
  };

  /// @param height of a slice [m] @param parts of a period
  HeightSlices(double height, std::size_t parts) : height_(height), parts_(parts) {}

  /// Adds a flight within one part of a period.
  void add(const SeenFlight& flight, std::size_t part);

  /// Slices up to the highest that a disk was in.
  std::size_t count() const { return sums_.size() / parts_; }
  const Sums& at(std::size_t slice, std::size_t part) const { return sums_[slice * parts_ + part]; }

  double time() const { return time_; }                       ///< of all disks [s]
  double heightIntegral() const { return height_integral_; }  ///< over disks and time [m s]
  double timeAbove() const { return time_above_; }            ///< of disks above all slices [s]

  template <typename Archive>
  void archive(Archive& state)
  {
    state(sums_, time_, height_integral_, time_above_);
  }

private:
  /// A velocity and its rate of change.
  struct Linear
  {
    double start, rate;
    double at(double time) const { return start + rate * time; }
  };
  struct Fall;

  void addMonotone(const Fall& fall, double from, double to, std::size_t part);
  void addWithin(const Fall& fall, double from, double to, std::size_t slice, std::size_t part);
  std::size_t sliceAt(double height) const;

  double height_;
  std::size_t parts_;
  std::vector<Sums> sums_;  ///< per slice and part
  double time_ = 0.0;
  double height_integral_ = 0.0;
  double time_above_ = 0.0;
};

}  // namespace ratchet_sieve
