#pragma once

#include <functional>
#include <map>
#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "clock_publisher.h"
#include "ratchet_sieve/live/sensors.h"
#include "ratchet_sieve/recording/run.h"

namespace ratchet_sieve
{

/// Publishes what the sensors say, each on the topic of its name: ~left/scale, ~right/scale, ~left/count,
/// ~right/count, ~level. Stamps are those of the measurements. Topics without subscribers are skipped.
class SensorPublisher
{
public:
  /// @param sensors that there are @param current returns the present run @param frame_id of the messages
  /// @param clock is advanced to the time of each sending; outlives this
  SensorPublisher(ros::NodeHandle private_node, const SensorParameters& sensors,
                  const std::function<const Run&()>& current, std::string frame_id, ClockPublisher& clock);

  void publish(const Sensor& sensor, const Reading& reading);

private:
  std::function<const Run&()> current_;
  std::string frame_id_;
  ClockPublisher& clock_;
  std::map<std::string, ros::Publisher> publishers_;  ///< by the names of the sensors
};

}  // namespace ratchet_sieve
