#!/usr/bin/python3
"""Climbs to the inclination at which a fed sieve separates best.

Parameters: ~sieve (name of its node), ~step [rad], ~dwell [s]
"""
import rospy
from std_msgs.msg import Float64
from std_srvs.srv import Empty

from my_feeder.climber import Climber
from my_feeder.msg import Report
from ratchet_sieve.msg import BinCounts

rospy.init_node('climb')
sieve = rospy.resolve_name(rospy.get_param('~sieve', 'sieve'))
climber = Climber(rospy.get_param('~step', 0.03), rospy.get_param('~dwell', 2.0))
setpoint = rospy.Publisher(f'{sieve}/inclination_setpoint', Float64, queue_size=1)
reports = rospy.Publisher('~report', Report, queue_size=10)


def take(bins):
    inclination = climber.take(bins)
    setpoint.publish(inclination)
    reports.publish(bins, inclination)


rospy.Subscriber(f'{sieve}/bins', BinCounts, take, queue_size=1, tcp_nodelay=True)
# The sieve is launched paused: a node's start of two seconds would be 40 s at 20 times real time.
rospy.wait_for_service(f'{sieve}/unpause_physics')
rospy.ServiceProxy(f'{sieve}/unpause_physics', Empty)()
rospy.spin()
