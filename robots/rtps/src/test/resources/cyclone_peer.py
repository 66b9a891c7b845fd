"""Writes texts and a long text, and reads those of RSAL, by Cyclone DDS on the loopback network.

Arguments: domain, 'multicast' or 'unicast', how many texts, length of the long text. Prints what it read.
"""
import hashlib
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

domain, discovery, count, length = int(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4])


@dataclass
@final
class Text(IdlStruct, typename='std_msgs::msg::dds_::String_'):
    data: str


def qos(latched):
    return Qos(
        Policy.Reliability.Reliable(duration(infinite=True)),
        Policy.Durability.TransientLocal if latched else Policy.Durability.Volatile,
        Policy.History.KeepLast(1) if latched else Policy.History.KeepAll,
        Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False))


face = '<General><Interfaces><NetworkInterface address="127.0.0.1" multicast="true"/></Interfaces>'
if discovery == 'unicast':
    xml = (face + '<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>'
           '<MaxAutoParticipantIndex>32</MaxAutoParticipantIndex><Peers><Peer address="127.0.0.1"/></Peers></Discovery>')
else:
    xml = face + '<AllowMulticast>spdp</AllowMulticast></General>'
of_domain = Domain(domain, xml)
participant = DomainParticipant(domain)


def writer(name, latched=False):
    return DataWriter(participant, Topic(participant, name, Text, qos=qos(latched)), qos=qos(latched))


def reader(name, latched=False):
    return DataReader(participant, Topic(participant, name, Text, qos=qos(latched)), qos=qos(latched))


texts, long = writer('rt/peer/text'), writer('rt/peer/long', latched=True)
heard, heard_long = reader('rt/rsal/text'), reader('rt/rsal/long', latched=True)
long.write(Text('p' * length))

end = time.monotonic() + 60
while not (texts.get_matched_subscriptions() and long.get_matched_subscriptions()) and time.monotonic() < end:
    time.sleep(0.01)
for number in range(count):
    texts.write(Text(f'peer {number}'))

read, read_long = [], []
while (len(read) < count or not read_long) and time.monotonic() < end:
    read += [each.data for each in heard.take(N=100)]
    read_long += [each.data for each in heard_long.take(N=1)]
    time.sleep(0.005)
texts.wait_for_acks(duration(seconds=20))
long.wait_for_acks(duration(seconds=20))
print('texts', len(read), read == [f'rsal {number}' for number in range(count)])
print('long', *[hashlib.sha256(each.encode()).hexdigest() for each in read_long])
