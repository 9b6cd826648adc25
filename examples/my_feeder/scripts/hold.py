#!/usr/bin/python3
"""Holds the purity of what leaves on the right, by the counter and the scale there.

Parameters: ~sieve (name of its node), ~purity (share of the first species), ~masses (of a disk of each species [kg])
"""
import rospy
from geometry_msgs.msg import WrenchStamped
from std_msgs.msg import Float64
from std_srvs.srv import Empty

from my_feeder.holder import Holder
from my_feeder.msg import Holding
from ratchet_sieve.msg import DiskCounts

GRAVITY = 9.81  # m/s^2

rospy.init_node('hold')
sieve = rospy.resolve_name(rospy.get_param('~sieve', 'sieve'))
holder = Holder(rospy.get_param('~purity', 0.62), rospy.get_param('~masses', [0.010, 0.001]))
setpoint = rospy.Publisher(f'{sieve}/inclination_setpoint', Float64, queue_size=10)
reports = rospy.Publisher('~report', Holding, queue_size=10)


def take(sensor, message, value):
    fault = holder.fault
    inclination = holder.take(sensor, message.header.stamp.to_sec(), value)
    if inclination is not None:
        setpoint.publish(inclination)
        reports.publish(message.header, inclination, holder.fault or '')
    if holder.fault and not fault:
        rospy.logwarn('to the level base: %s', holder.fault)


rospy.Subscriber(f'{sieve}/right/count', DiskCounts, lambda m: take('count', m, m.count), tcp_nodelay=True)
rospy.Subscriber(f'{sieve}/right/scale', WrenchStamped, lambda m: take('scale', m, -m.wrench.force.z / GRAVITY),
                 tcp_nodelay=True)
# See climb.py.
rospy.wait_for_service(f'{sieve}/unpause_physics')
rospy.ServiceProxy(f'{sieve}/unpause_physics', Empty)()
rospy.spin()
