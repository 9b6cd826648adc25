// What check_layers.py must find: the core reading a scene, and ROS below the ROS layer.
#include <ros/ros.h>

#include "ratchet_sieve/scene/scene_file.h"
