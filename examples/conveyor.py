#!/usr/bin/python3
"""Carries what leaves one sieve into another one: a second stage, live.

Usage: rosrun ratchet_sieve conveyor.py _from:=s1 _to:=s2 [_side:=right]

Parameters:
  ~from, ~to  names of the two sieves' nodes
  ~side       left or right: the side of the first on which disks enter the conveyor (default: right)

The numbers of each species are carried on: ~pour of the second sieve draws the radii from the sizes of its own scene.
Disk by disk, with their radii and at their exact times: feed.file of a scene (docs/scenes.md, Two stages).

An example of a node between two sieves, to be copied.
"""
import collections
import queue
import sys

import rospy

from ratchet_sieve.msg import DiskExit
from ratchet_sieve.srv import PourDisks

PERIOD = 0.05  # between two pours [s of wall time]


def main():
    if '--help' in sys.argv:
        print(__doc__)
        return
    rospy.init_node('conveyor')
    for name in ('~from', '~to'):
        if not rospy.has_param(name):
            sys.exit(f'conveyor: {name} is missing: the name of a sieve')
    side, belt = rospy.get_param('~side', 'right'), queue.Queue()
    target = rospy.resolve_name(rospy.get_param('~to'))
    # Before it waits: what leaves meanwhile is poured, too.
    rospy.Subscriber(rospy.resolve_name(rospy.get_param('~from')) + '/exits', DiskExit, belt.put)
    rospy.loginfo('conveyor: pours once %s has its service pour', target)
    rospy.wait_for_service(f'{target}/pour')
    pour = rospy.ServiceProxy(f'{target}/pour', PourDisks)
    while not rospy.is_shutdown():
        disks = [belt.get() for _ in range(belt.qsize())]
        for species, count in collections.Counter(disk.species for disk in disks if disk.side == side).items():
            try:
                answer = pour(species, count)
                failure = None if answer.success else answer.message
            except rospy.ServiceException as error:
                failure = str(error)
            if failure is not None:
                rospy.logwarn('%d disks of %s were not poured into %s: %s', count, species, target, failure)
        rospy.rostime.wallsleep(PERIOD)


if __name__ == '__main__':
    try:
        main()
    except rospy.ROSInterruptException:
        pass
