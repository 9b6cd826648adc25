// A node with a message of its own, which holds one of ratchet_sieve's.
#include <foreign/Report.h>
#include <ros/ros.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "own_node");
  ros::NodeHandle node;
  const ros::Publisher publisher = node.advertise<foreign::Report>("report", 1, true);
  foreign::Report report;
  report.bins.left.push_back(1);
  publisher.publish(report);
  ros::spin();
}
