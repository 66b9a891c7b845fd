import math, sys
from pathlib import Path
from rosbags.rosbag2 import Writer, StoragePlugin
from rosbags.typesys import Stores, get_typestore
store = get_typestore(Stores.ROS2_JAZZY)
T = store.types
import numpy as np
def stamp(t): return T['builtin_interfaces/msg/Time'](sec=int(t), nanosec=int(round((t - int(t)) * 1e9)))
def header(t, frame): return T['std_msgs/msg/Header'](stamp=stamp(t), frame_id=frame)
def vec(x, y, z): return T['geometry_msgs/msg/Vector3'](x=x, y=y, z=z)
def quat(roll, yaw):
    cr, sr, cy, sy = math.cos(roll/2), math.sin(roll/2), math.cos(yaw/2), math.sin(yaw/2)
    return T['geometry_msgs/msg/Quaternion'](x=sr*cy, y=sr*sy, z=cr*sy, w=cr*cy)
def link(t, parent, child, x, y, roll, yaw):
    return T['geometry_msgs/msg/TransformStamped'](header=header(t, parent), child_frame_id=child, transform=T['geometry_msgs/msg/Transform'](translation=vec(x, y, 0.2), rotation=quat(roll, yaw)))
kind, out = sys.argv[1], Path(sys.argv[2])
with Writer(out, version=9, storage_plugin=StoragePlugin.MCAP) as w:
    def topic(name, kind): return w.add_connection(name, kind, typestore=store)
    scan, odom, tf, static = topic('/r1/scan', 'sensor_msgs/msg/LaserScan'), topic('/r1/odom', 'nav_msgs/msg/Odometry') if kind != 'tf' else None, topic('/r1/tf', 'tf2_msgs/msg/TFMessage'), topic('/r1/tf_static', 'tf2_msgs/msg/TFMessage')
    def write(c, t, m): w.write(c, int(t * 1e9) + 1000, store.serialize_cdr(m, c.msgtype))
    roll = math.pi if kind == 'down' else 0.0
    write(static, 0, T['tf2_msgs/msg/TFMessage'](transforms=[link(0, 'base_footprint', 'base_link', 0.0, 0.0, 0.0, 0.0), link(0, 'base_link', 'laser', 0.25, 0.05, roll, 0.5)]))
    for i in range(20):
        t, x = 1 + i * 0.1, i * 0.05
        if odom:
            pose = T['geometry_msgs/msg/Pose'](position=T['geometry_msgs/msg/Point'](x=x, y=0.0, z=0.0), orientation=quat(0.0, 0.1 * i))
            write(odom, t, T['nav_msgs/msg/Odometry'](header=header(t, 'odom'), child_frame_id='base_footprint', pose=T['geometry_msgs/msg/PoseWithCovariance'](pose=pose, covariance=np.zeros(36)), twist=T['geometry_msgs/msg/TwistWithCovariance'](twist=T['geometry_msgs/msg/Twist'](linear=vec(0.5, 0.0, 0.0), angular=vec(0.0, 0.0, 1.0)), covariance=np.zeros(36))))
        write(tf, t, T['tf2_msgs/msg/TFMessage'](transforms=[link(t, 'odom', 'base_footprint', x, 0.0, 0.0, 0.1 * i)]))
        increment = -0.25 if kind == 'clockwise' else 0.25
        first = 1.0 if kind == 'clockwise' else -1.0
        ranges = np.array([1, 2, 3, 4, 5, float('inf'), float('nan'), 0.01, 40], dtype=np.float32)
        write(scan, t, T['sensor_msgs/msg/LaserScan'](header=header(t, 'laser'), angle_min=first, angle_max=first + 8 * increment, angle_increment=increment, time_increment=0.0, scan_time=0.1, range_min=0.1, range_max=30.0, ranges=ranges, intensities=np.array([], dtype=np.float32)))
