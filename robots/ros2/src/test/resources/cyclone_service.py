"""Serves the service /lights of the type std_srvs/srv/SetBool as rmw_cyclonedds does, on the loopback network.

Arguments: domain, how many requests it answers. Prints the data of each request.
"""
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import int64, uint64
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

domain, count = int(sys.argv[1]), int(sys.argv[2])


@dataclass
@final
class Request(IdlStruct, typename='std_srvs::srv::dds_::SetBool_Request_'):
    client: uint64
    number: int64
    data: bool


@dataclass
@final
class Response(IdlStruct, typename='std_srvs::srv::dds_::SetBool_Response_'):
    client: uint64
    number: int64
    success: bool
    message: str


qos = Qos(
    Policy.Reliability.Reliable(duration(infinite=True)), Policy.Durability.Volatile, Policy.History.KeepLast(10),
    Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False))
of_domain = Domain(domain, '<General><Interfaces><NetworkInterface address="127.0.0.1" multicast="true"/></Interfaces>'
                           '<AllowMulticast>spdp</AllowMulticast></General>')
participant = DomainParticipant(domain)
requests = DataReader(participant, Topic(participant, 'rq/lightsRequest', Request, qos=qos), qos=qos)
replies = DataWriter(participant, Topic(participant, 'rr/lightsReply', Response, qos=qos), qos=qos)
answered, end = 0, time.monotonic() + 60
while answered < count and time.monotonic() < end:
    for request in requests.take(N=10):
        replies.write(Response(request.client + 1, request.number, True, 'for somebody else'))
        replies.write(Response(request.client, request.number, request.data, f'number {request.number}'))
        print(request.data)
        answered += 1
    time.sleep(0.005)
replies.wait_for_acks(duration(seconds=10))
