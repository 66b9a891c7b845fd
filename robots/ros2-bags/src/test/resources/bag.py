import math, sys
from pathlib import Path
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
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
storage, packed = (sys.argv[3] if len(sys.argv) > 3 else 'mcap/').split('/')
def writer():
    w = Writer(out, version=9, storage_plugin=StoragePlugin.MCAP if storage == 'mcap' else StoragePlugin.SQLITE3)
    if packed in ('file', 'message'):
        w.set_compression(CompressionMode[packed.upper()], CompressionFormat.ZSTD)
    return w
with writer() as w:
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

def lz4():
    from mcap.reader import make_reader
    from mcap.writer import Writer as McapWriter, CompressionType
    path = out / (out.name + '.mcap')
    whole = path.read_bytes()
    import io
    with open(path, 'wb') as f:
        m = McapWriter(f, compression=CompressionType.LZ4)
        m.start('ros2', 'a test')
        channels = {}
        for schema, channel, message in make_reader(io.BytesIO(whole)).iter_messages():
            if channel.id not in channels:
                s = m.register_schema(schema.name, schema.encoding, schema.data)
                channels[channel.id] = m.register_channel(channel.topic, channel.message_encoding, s, channel.metadata)
            m.add_message(channels[channel.id], message.log_time, message.data, message.publish_time)
        m.finish()
if packed == 'lz4': lz4()
if packed in ('humble', 'lyrical', 'open', 'utf16'):
    # as recorders of ROS have their tables: the module sqlite3 writes them anew, from what rosbags has written
    import sqlite3
    path = next(out.glob('*.db3'))
    old = sqlite3.connect(path)
    topics = old.execute('SELECT id, name, type, serialization_format, offered_qos_profiles FROM topics').fetchall()
    messages = old.execute('SELECT id, topic_id, timestamp, data FROM messages ORDER BY id').fetchall()
    old.close()
    path.unlink()
    new = sqlite3.connect(path)
    new.execute('PRAGMA page_size = 512' if packed == 'humble' else 'PRAGMA page_size = 65536')
    if packed == 'utf16': new.execute("PRAGMA encoding = 'UTF-16be'")
    if packed == 'open': new.execute('PRAGMA journal_mode = WAL')
    new.execute('CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL' + (')' if packed == 'humble' else ',type_description_hash TEXT NOT NULL)'))
    new.execute('CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL, data BLOB NOT NULL)')
    if packed == 'lyrical':
        new.execute('CREATE TABLE schema(schema_version INTEGER PRIMARY KEY,ros_distro TEXT NOT NULL)')
        new.execute('CREATE TABLE message_definitions(id INTEGER PRIMARY KEY,topic_type TEXT NOT NULL,encoding TEXT NOT NULL,encoded_message_definition TEXT NOT NULL,type_description_hash TEXT NOT NULL)')
        for t in topics:
            text, h = store.generate_msgdef(t[2], ros_version=2)[0], 'RIHS01_0'
            new.execute('INSERT INTO message_definitions(topic_type, encoding, encoded_message_definition, type_description_hash) VALUES(?, ?, ?, ?)', (t[2], 'ros2msg', text, h))
    for t in topics:
        new.execute('INSERT INTO topics VALUES(?, ?, ?, ?, ?%s)' % ('' if packed == 'humble' else ', "RIHS01_0"'), t)
    big = bytes([0, 1, 0, 0]) + bytes(3_000_000)
    new.execute('INSERT INTO topics VALUES(?, ?, ?, ?, ?%s)' % ('' if packed == 'humble' else ', "RIHS01_0"'), (99, '/image', 'sensor_msgs/msg/Image', 'cdr', ''))
    new.executemany('INSERT INTO messages VALUES(?, ?, ?, ?)', messages)
    if packed != 'utf16' and len(sys.argv) <= 4: new.execute('INSERT INTO messages VALUES(?, ?, ?, ?)', (100_000, 99, 5, big))
    new.execute('CREATE INDEX timestamp_idx ON messages (timestamp ASC)')
    new.commit()
    if packed == 'open':
        import os
        os._exit(0)  # killed, so that nothing is checkpointed
    new.close()
