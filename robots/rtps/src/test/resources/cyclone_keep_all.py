"""Writes texts and reads those of RSAL, keeping all, by Cyclone DDS on the loopback network.

Arguments: domain, how many texts, a file. It makes FILE.before when all of its texts are acknowledged. It reads once FILE
exists, and then slowly: while its reader is full, Cyclone DDS receives nothing on other topics either. Prints what it
read.
"""
import os
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

domain, count, go = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]


@dataclass
@final
class Text(IdlStruct, typename='std_msgs::msg::dds_::String_'):
    data: str


def qos(*more):
    return Qos(
        Policy.Reliability.Reliable(duration(infinite=True)),
        Policy.History.KeepAll,
        Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False),
        *more)


of_domain = Domain(domain, '<General><Interfaces><NetworkInterface address="127.0.0.1" multicast="true"/></Interfaces>'
                   '<AllowMulticast>spdp</AllowMulticast></General>')
participant = DomainParticipant(domain)


def topic(name):
    return Topic(participant, name, Text, qos=qos())


texts = DataWriter(participant, topic('rt/peer/text'), qos=qos())
few = Policy.ResourceLimits(max_samples=50, max_instances=1, max_samples_per_instance=50)
heard = DataReader(participant, topic('rt/rsal/text'), qos=qos(few))

end = time.monotonic() + 120
while not texts.get_matched_subscriptions() and time.monotonic() < end:
    time.sleep(0.01)
for number in range(count):
    texts.write(Text(f'peer {number}'))
texts.wait_for_acks(duration(seconds=60))
open(go + '.before', 'w').close()  # from now on its reader may be full: no acknowledgment is awaited any more

while not os.path.exists(go) and time.monotonic() < end:
    time.sleep(0.01)
read = []
while len(read) < count and time.monotonic() < end:
    read += [each.data for each in heard.take(N=20)]
    time.sleep(0.002)
time.sleep(0.5)  # for the last acknowledgments
print('texts', len(read), read == [f'rsal {number}' for number in range(count)])
