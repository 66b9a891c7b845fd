"""Controls a simulator by the package simulation_interfaces, as rmw_cyclonedds does, on the loopback network; asks for
nodes, parameters and lifecycles, as ros2 node, ros2 param and ros2 lifecycle do, and hears what robots are like.

Arguments: domain, version of the package (1 or 2), type hash of GetSpawnables_Response in version 2. Prints what it was answered, as lines of JSON: [service, answer].
"""
import json
import random
import sys
import time
import xml.etree.ElementTree

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import array, float64, int32, int64, int8, sequence, uint8, uint16, uint32, uint64
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

domain, version = int(sys.argv[1]), int(sys.argv[2])
NEW_SPAWNABLES = sys.argv[3]  # hash of the response's type in version 2
PATIENCE = 60  # s


def struct(name, /, **fields):
    package, kind, short = name.split('/')
    return final(make_idl_struct(name.replace('/', '_'), f'{package}::{kind}::dds_::{short}_', fields))


def simulation(kind, /, **fields):
    return struct(f'simulation_interfaces/{kind}', **fields)


Time = struct('builtin_interfaces/msg/Time', sec=int32, nanosec=uint32)
Header = struct('std_msgs/msg/Header', stamp=Time, frame_id=str)
Vector = struct('geometry_msgs/msg/Vector3', x=float64, y=float64, z=float64)
Point = struct('geometry_msgs/msg/Point', x=float64, y=float64, z=float64)
Quaternion = struct('geometry_msgs/msg/Quaternion', x=float64, y=float64, z=float64, w=float64)
Pose = struct('geometry_msgs/msg/Pose', position=Point, orientation=Quaternion)
PoseStamped = struct('geometry_msgs/msg/PoseStamped', header=Header, pose=Pose)
Twist = struct('geometry_msgs/msg/Twist', linear=Vector, angular=Vector)
Accel = struct('geometry_msgs/msg/Accel', linear=Vector, angular=Vector)
Uuid = struct('unique_identifier_msgs/msg/UUID', uuid=array[uint8, 16])
Result = simulation('msg/Result', result=uint8, error_message=str)
State = simulation('msg/SimulationState', state=uint8)
EntityState = simulation('msg/EntityState', header=Header, pose=Pose, twist=Twist, acceleration=Accel)
Category = simulation('msg/EntityCategory', category=uint8)
Tags = simulation('msg/TagsFilter', tags=sequence[str], filter_mode=uint8)
Bounds = simulation('msg/Bounds', type=uint8, points=sequence[Vector])
Filters = simulation('msg/EntityFilters', filter=str, categories=sequence[Category], tags=Tags, bounds=Bounds)
Features = simulation('msg/SimulatorFeatures', features=sequence[uint16], spawn_formats=sequence[str], custom_info=str)
Info = simulation('msg/EntityInfo', category=Category, description=str, tags=sequence[str])
Resource = simulation('msg/Resource', uri=str, resource_string=str)
old = version == 1
Spawnable = simulation('msg/Spawnable', **({'uri': str} if old else {'entity_resource': Resource}),
                       description=str, spawn_bounds=Bounds)
RESOURCE = {'uri': str, 'resource_string': str} if old else {'entity_resource': Resource}
SET = {} if old else {'set_pose': bool, 'set_twist': bool, 'set_acceleration': bool}
EMPTY = {'structure_needs_at_least_one_member': uint8}
Goal = simulation('action/SimulateSteps_Goal', steps=uint64)
StepsResult = simulation('action/SimulateSteps_Result', result=Result)

# request and response
SERVICES = {
    'GetSimulatorFeatures': (EMPTY, {'features': Features}),
    'GetEntities': ({'filters': Filters}, {'result': Result, 'entities': sequence[str]}),
    'GetEntitiesStates': ({'filters': Filters},
                          {'result': Result, 'entities': sequence[str], 'states': sequence[EntityState]}),
    'GetEntityState': ({'entity': str}, {'result': Result, 'state': EntityState}),
    'SetEntityState': ({'entity': str, 'state': EntityState, **SET}, {'result': Result}),
    'GetEntityInfo': ({'entity': str}, {'result': Result, 'info': Info}),
    'GetSpawnables': ({'sources': sequence[str]}, {'result': Result, 'spawnables': sequence[Spawnable]}),
    'SpawnEntity': ({'name': str, 'allow_renaming': bool, **RESOURCE, 'entity_namespace': str,
                     'initial_pose': PoseStamped}, {'result': Result, 'entity_name': str}),
    'DeleteEntity': ({'entity': str}, {'result': Result}),
    'ResetSimulation': ({'scope': uint8}, {'result': Result}),
    'GetSimulationState': (EMPTY, {'state': State, 'result': Result}),
    'SetSimulationState': ({'state': State}, {'result': Result}),
    'StepSimulation': ({'steps': uint64}, {'result': Result}),
}
qos = [Policy.Reliability.Reliable(duration(infinite=True)), Policy.Durability.Volatile, Policy.History.KeepLast(10),
       Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False)]
of_domain = Domain(domain, '<General><Interfaces><NetworkInterface address="127.0.0.1" multicast="true"/></Interfaces>'
                           '<AllowMulticast>spdp</AllowMulticast></General>')
participant = DomainParticipant(domain)


def zero(kind):
    if kind is bool:
        return False
    if kind is str:
        return ''
    if isinstance(kind, type):
        return made(kind)
    for meta in getattr(kind, '__metadata__', ()):
        if isinstance(meta, array):
            return [0] * meta.length
        if isinstance(meta, sequence):
            return []
        if meta == 'float64':
            return 0.0
    return 0


def made(kind, /, **values):
    return kind(**{field: values[field] if field in values else zero(of) for field, of in kind.__annotations__.items()})


class Client:
    """Requests and replies of one service, which have 16 bytes in front."""

    def __init__(self, name, kind, request, response, digest=''):
        front = {'client': uint64, 'number': int64}
        self.request = struct(kind + '_Request', **front, **request)
        reply = struct(kind + '_Response', **front, **response)
        user_data = [Policy.Userdata(data=f'typehash={digest};'.encode())] if digest else []
        self.requests = DataWriter(participant, Topic(participant, f'rq{name}Request', self.request), qos=Qos(*qos))
        self.replies = DataReader(participant, Topic(participant, f'rr{name}Reply', reply), qos=Qos(*qos, *user_data))
        self.id, self.number = random.getrandbits(63), 0

    def call(self, /, **values):
        end = time.monotonic() + PATIENCE
        while not (self.requests.get_matched_subscriptions() and self.replies.get_matched_publications()):
            assert time.monotonic() < end, 'nobody serves it'
            time.sleep(0.01)
        self.number += 1
        self.requests.write(made(self.request, client=self.id, number=self.number, **values))
        while time.monotonic() < end:
            for reply in self.replies.take(N=10):
                if reply.client == self.id and reply.number == self.number:
                    return reply
            time.sleep(0.002)
        raise TimeoutError(self.request)


def service(name):
    request, response = SERVICES[name]
    snake = ''.join('_' + c.lower() if c.isupper() else c for c in name)[1:]
    digest = NEW_SPAWNABLES if name == 'GetSpawnables' and not old else ''
    return Client(f'/rsal/{snake}', f'simulation_interfaces/srv/{name}', request, response, digest)


clients = {name: service(name) for name in SERVICES}
ACTION = 'simulation_interfaces/action/SimulateSteps'
send = Client('/rsal/simulate_steps/_action/send_goal', ACTION + '_SendGoal', {'goal_id': Uuid, 'goal': Goal},
              {'accepted': bool, 'stamp': Time})
result = Client('/rsal/simulate_steps/_action/get_result', ACTION + '_GetResult', {'goal_id': Uuid},
                {'status': int8, 'result': StepsResult})


def call(name, /, **values):
    return clients[name].call(**values)


def tell(name, answer):
    print(json.dumps([name, answer]), flush=True)


def code(name, /, **values):
    reply = call(name, **values).result
    tell(name, [reply.result, reply.error_message])


def seconds():
    stamp = call('GetEntityState', entity='prey-1').state.header.stamp
    return stamp.sec + stamp.nanosec / 1e9


def pose(x, y):
    return made(Pose, position=made(Point, x=x, y=y), orientation=made(Quaternion, w=1.0))


def uri(kind):
    return {'uri': kind} if old else {'entity_resource': made(Resource, uri=kind)}


Gid = struct('rmw_dds_common/msg/Gid', data=array[uint8, 16])
Node = struct('rmw_dds_common/msg/NodeEntitiesInfo', node_namespace=str, node_name=str,
              reader_gid_seq=sequence[Gid], writer_gid_seq=sequence[Gid])
Graph = struct('rmw_dds_common/msg/ParticipantEntitiesInfo', gid=Gid, node_entities_info_seq=sequence[Node])
Value = struct('rcl_interfaces/msg/ParameterValue', type=uint8, bool_value=bool, integer_value=int64,
               double_value=float64, string_value=str, byte_array_value=sequence[uint8],
               bool_array_value=sequence[bool], integer_array_value=sequence[int64],
               double_array_value=sequence[float64], string_array_value=sequence[str])
Listed = struct('rcl_interfaces/msg/ListParametersResult', names=sequence[str], prefixes=sequence[str])
Lifecycle = struct('lifecycle_msgs/msg/State', id=uint8, label=str)


def nodes():
    """Full names of those that the other participant tells of, once it tells nothing new."""
    latched = Qos(Policy.Reliability.Reliable(duration(infinite=True)), Policy.Durability.TransientLocal,
                  Policy.History.KeepAll, qos[-1])
    reader = DataReader(participant, Topic(participant, 'ros_discovery_info', Graph), qos=latched)
    end, names, changed = time.monotonic() + PATIENCE, [], time.monotonic()
    while time.monotonic() < end and (len(names) < 2 or time.monotonic() < changed + 1):
        for graph in reader.take(N=50):
            changed = time.monotonic()
            names = [f'{each.node_namespace}/{each.node_name}'.replace('//', '/')
                     for each in graph.node_entities_info_seq]
        time.sleep(0.01)
    return sorted(names)


def first(topic, kind, latched=False):
    """The first message on a topic."""
    durability = Policy.Durability.TransientLocal if latched else Policy.Durability.Volatile
    reader = DataReader(participant, Topic(participant, 'rt' + topic, kind), qos=Qos(qos[0], durability, *qos[2:]))
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        for message in reader.take(N=1):
            return message
        time.sleep(0.01)
    raise TimeoutError(topic)


Text = struct('std_msgs/msg/String', data=str)
WithCovariance = {name: struct(f'geometry_msgs/msg/{name}WithCovariance', **{name.lower(): kind},
                               covariance=array[float64, 36]) for name, kind in (('Pose', Pose), ('Twist', Twist))}
Odometry = struct('nav_msgs/msg/Odometry', header=Header, child_frame_id=str, pose=WithCovariance['Pose'],
                  twist=WithCovariance['Twist'])
KeyValue = struct('diagnostic_msgs/msg/KeyValue', key=str, value=str)
Status = struct('diagnostic_msgs/msg/DiagnosticStatus', level=uint8, name=str, message=str, hardware_id=str,
                values=sequence[KeyValue])
Diagnostics = struct('diagnostic_msgs/msg/DiagnosticArray', header=Header, status=sequence[Status])
robot = xml.etree.ElementTree.fromstring(first('/prey_1/robot_description', Text, latched=True).data)
tell('urdf', [robot.get('name'), robot.find('link').get('name'), len(robot.findall('joint')) > 0])
truth = first('/prey_1/ground_truth', Odometry)
tell('truth', [truth.header.frame_id, truth.child_frame_id, round(truth.pose.pose.position.x, 2)])
tell('health', [[each.level, each.message] for each in first('/diagnostics', Diagnostics).status
                if each.name == 'prey-1: laser'])
tell('nodes', [node for node in nodes() if 'hunter' not in node])
parameters = Client('/prey_1/rsal/list_parameters', 'rcl_interfaces/srv/ListParameters',
                    {'prefixes': sequence[str], 'depth': uint64}, {'result': Listed}).call()
tell('parameters', list(parameters.result.names))
values = Client('/prey_1/rsal/get_parameters', 'rcl_interfaces/srv/GetParameters',
                {'names': sequence[str]}, {'values': sequence[Value]}).call(names=list(parameters.result.names))
tell('values', [each.bool_value or each.double_value or each.string_value for each in values.values])
state = Client('/prey_1/amcl/get_state', 'lifecycle_msgs/srv/GetState', EMPTY, {'current_state': Lifecycle}).call()
tell('amcl', [state.current_state.id, state.current_state.label])

tell('features', list(call('GetSimulatorFeatures').features.features))
code('SetSimulationState', state=State(2))
tell('state', call('GetSimulationState').state.state)
before = seconds()
time.sleep(0.5)
tell('standing', seconds() - before)
code('StepSimulation', steps=5)
tell('stepped', round(seconds() - before, 3))
goal = made(Uuid, uuid=[7] * 16)
tell('accepted', send.call(goal_id=goal, goal=Goal(3)).accepted)
ended = result.call(goal_id=goal)
tell('simulated', [ended.status, ended.result.result.result])
tell('stepped', round(seconds() - before, 3))

robots = call('GetEntities', filters=made(Filters, categories=[Category(1)]))
tell('robots', list(robots.entities))
states = call('GetEntitiesStates', filters=made(Filters, filter='^hunter'))
tell('states', [[name, state.header.frame_id, state.pose.position.x, state.pose.position.y]
                for name, state in zip(states.entities, states.states)])
tell('info', call('GetEntityInfo', entity='prey-1').info.description)
start = call('GetEntityState', entity='prey-1').state.pose.position
code('SetEntityState', entity='prey-1', state=made(EntityState, pose=pose(start.x + 0.5, start.y)),
     **({} if old else {'set_pose': True}))
moved = call('GetEntityState', entity='prey-1').state.pose.position
tell('moved', round(moved.x - start.x, 3))
code('GetEntityState', entity='nobody')

spawnables = call('GetSpawnables').spawnables
tell('spawnables', [[each.uri if old else each.entity_resource.uri, each.description] for each in spawnables])
code('SpawnEntity', name='visitor', **uri('rsal:turtlebot3-burger'),
     initial_pose=made(PoseStamped, pose=pose(start.x, start.y)))
code('SpawnEntity', name='visitor', **uri('rsal:box'), initial_pose=made(PoseStamped, pose=pose(start.x, start.y)))
code('SetSimulationState', state=State(1))
end = time.monotonic() + PATIENCE
while 'visitor' not in call('GetEntities').entities and time.monotonic() < end:
    time.sleep(0.05)
tell('entities', list(call('GetEntities').entities))
code('ResetSimulation', scope=6)
tell('entities', list(call('GetEntities').entities))
code('ResetSimulation', scope=1)
tell('early', seconds() < 5)
code('ResetSimulation', scope=255)
code('SetSimulationState', state=State(0))
tell('stopped', [call('GetSimulationState').state.state, seconds()])
code('SetSimulationState', state=State(2))
code('StepSimulation', steps=5)
tell('began', round(seconds(), 3))
code('SetSimulationState', state=State(3))
