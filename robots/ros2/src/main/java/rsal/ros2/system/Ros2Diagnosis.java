package rsal.ros2.system;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.link.RtpsLink;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.RosType;
import rsal.rtps.GraphListener;
import rsal.rtps.UdpParticipant;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.ParticipantData;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.system.Diagnosis;
import rsal.time.AllowedToReadWallClock;

/// What of ROS 2 is found on the network, and what hides it: another domain, the loopback address, shared memory,
/// quality of service that does not match.
@AllowedToReadWallClock("Networks live in real time.")
public final class Ros2Diagnosis implements Diagnosis {
    private static final String NODE = "rsal_doctor";
    private static final Parameter<Double> TIME = Parameter.number(
            "time", 4, 1, 60, "s", "For how long to look; robots announce themselves every few seconds.");
    private static final Parameter<String> TOPIC = Parameter.text(
            "topic",
            "",
            "A topic whose fields and newest message are to be shown, such as /robot1/scan. Default: none.");
    private static final Parameter<String> DEFINITIONS = Parameter.text(
            "definitions",
            "",
            "A folder with definitions of messages that RSAL does not know, for 'topic': PACKAGE/msg/NAME.msg, as in the"
                    + " sources of a workspace. Default: none.");
    private static final Duration AGAIN = Duration.ofMillis(50); // to look whether the topic is there
    private static final int GOOD_BUFFER = 2 << 20; // B
    private static final Path BUFFER = Path.of("/proc/sys/net/core/rmem_max");
    private static final Map<Integer, String> VENDORS = Map.of(
            0x0101,
            "RTI Connext",
            0x0102,
            "OpenSplice",
            0x0103,
            "OpenDDS",
            0x010f,
            "Fast DDS",
            0x0110,
            "Cyclone DDS",
            0x0112,
            "RustDDS",
            UdpParticipant.VENDOR,
            "RSAL");

    @Override
    public String key() {
        return "ros2";
    }

    @Override
    public String description() {
        return "Looks for programs and robots of ROS 2 on the network, and says what hides them.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(
                Ros2Provider.DOMAIN,
                Ros2Provider.ADDRESS,
                Ros2Provider.PEERS,
                Ros2Provider.ROSBRIDGE,
                TIME,
                TOPIC,
                DEFINITIONS);
    }

    @Override
    public List<Finding> look(Arguments settings) {
        if (!settings.get(Ros2Provider.ROSBRIDGE).isBlank()) {
            if (!settings.get(TOPIC).isBlank() || !settings.get(DEFINITIONS).isBlank()) {
                throw new IllegalArgumentException(
                        "'topic' and 'definitions' need DDS, which 'rosbridge' replaces. Remove them, or 'rosbridge'.");
            }
            return RosbridgeFindings.of(settings, settings.seconds(TIME));
        }
        UdpParticipant.Options options = Ros2Provider.network(settings, NODE);
        List<RosType> definitions =
                TopicReading.definitions(settings.get(DEFINITIONS).strip());
        var findings = new ArrayList<Finding>();
        findings.add(new Finding("domain", true, String.valueOf(options.domain()), ""));
        String environment = RosNetwork.environment().words();
        if (!environment.isEmpty()) {
            findings.add(new Finding("environment", true, environment, ""));
        }
        boolean isLocal = options.isLocal();
        findings.add(new Finding(
                "address",
                true,
                words(options.addresses()) + (isLocal ? ", for programs on this machine" : ""),
                isLocal ? "For robots elsewhere: --set address=ADDRESS of this machine in their network." : ""));
        findings.addAll(RouteFindings.of(options, RosNetwork::route));
        bufferSize().ifPresent(findings::add);
        boolean isThere = false; // the network
        try (var participant = new UdpParticipant(options, System::nanoTime, new SecureRandom(), GraphListener.NONE)) {
            findings.add(new Finding(
                    "multicast",
                    participant.hasMulticast(),
                    participant.hasMulticast() ? "can be received" : "can't be received there",
                    participant.hasMulticast() ? "" : "Name the robots' machines: --set peers=HOST,HOST."));
            Thread.sleep(settings.seconds(TIME));
            findings.addAll(of(participant.participants(), participant.endpoints()));
            isThere = true;
        } catch (IOException e) {
            findings.add(new Finding(
                    "network",
                    false,
                    String.valueOf(e.getMessage()),
                    "Set another address, such as %s.".formatted(words(RosNetwork.all()))));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        String topic = settings.get(TOPIC).strip();
        if (isThere && !topic.isEmpty()) {
            findings.addAll(
                    topic(options, topic.startsWith("/") ? topic : "/" + topic, definitions, settings.seconds(TIME)));
        }
        return findings;
    }

    /// @param patience how long to look for the topic, and then for a message
    private static List<Finding> topic(
            UdpParticipant.Options options, String topic, List<RosType> definitions, Duration patience) {
        try (RosLink link = RosNetwork.join(options, Distribution.JAZZY, NODE)) {
            var reading = new TopicReading(link, definitions);
            long begun = System.nanoTime();
            while (!reading.isThere(topic) && System.nanoTime() - begun < patience.toNanos()) {
                Thread.sleep(AGAIN);
            }
            return reading.look(topic, patience);
        } catch (IOException e) {
            return List.of(new Finding("topic", false, String.valueOf(e.getMessage()), "Set another address."));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return List.of();
        }
    }

    static String words(List<InetAddress> addresses) {
        return addresses.stream().map(InetAddress::getHostAddress).collect(Collectors.joining(", "));
    }

    private static Optional<Finding> bufferSize() {
        try (var file = Files.newBufferedReader(BUFFER)) { // which is there for the first read only
            long most = Long.parseLong(String.valueOf(file.readLine()));
            boolean isGood = most >= GOOD_BUFFER;
            return Optional.of(new Finding(
                    "buffer",
                    isGood,
                    "at most %d KiB for what is received".formatted(most >> 10),
                    isGood ? "" : "For large maps and many robots: sysctl -w net.core.rmem_max=8388608"));
        } catch (IOException | NumberFormatException e) {
            return Optional.empty(); // not Linux
        }
    }

    /// What there is, and what of it does not work.
    static List<Finding> of(List<ParticipantData> participants, List<EndpointData> endpoints) {
        var findings = new ArrayList<Finding>();
        var vendors = new TreeMap<String, Integer>();
        participants.forEach(each -> vendors.merge(vendor(each), 1, Integer::sum));
        findings.add(new Finding(
                "programs",
                !participants.isEmpty(),
                participants.isEmpty()
                        ? "none of ROS 2"
                        : vendors.entrySet().stream()
                                .map(each -> "%d of %s".formatted(each.getValue(), each.getKey()))
                                .collect(Collectors.joining(", ")),
                participants.isEmpty()
                        ? "Are they of this domain? Do they run on this machine, or in the network of the address?"
                                + " Docker, WSL and many Wi-Fi networks need --set peers."
                        : ""));
        for (ParticipantData each : participants) {
            boolean isReached = each.userTraffic().stream()
                    .anyMatch(locator -> locator.unicast().isPresent());
            if (!isReached) {
                findings.add(new Finding(
                        "program",
                        false,
                        "%s '%s' receives by shared memory or TCP only".formatted(vendor(each), each.name()),
                        "Start it without FASTDDS_BUILTIN_TRANSPORTS, or with UDPv4."));
            }
        }
        findings.addAll(RobotFindings.of(endpoints.stream()
                .flatMap(each -> RtpsLink.endpoint(each).stream())
                .toList()));
        findings.addAll(mismatches(endpoints));
        return findings;
    }

    private static String vendor(ParticipantData participant) {
        int vendor = participant.prefix().vendor();
        return VENDORS.getOrDefault(vendor, "DDS of vendor 0x%04x".formatted(vendor));
    }

    /// Writers and readers of one topic that don't fit, each reason once for a topic.
    private static List<Finding> mismatches(List<EndpointData> endpoints) {
        Map<String, List<EndpointData>> writers = endpoints.stream()
                .filter(EndpointData::isWriter)
                .collect(Collectors.groupingBy(EndpointData::topic, LinkedHashMap::new, Collectors.toList()));
        var reported = new LinkedHashSet<String>();
        for (EndpointData reader : endpoints) {
            if (!reader.isWriter()) {
                for (EndpointData writer : writers.getOrDefault(reader.topic(), List.of())) {
                    writer.mismatch(reader).ifPresent(why -> reported.add("'%s': %s".formatted(topic(reader), why)));
                }
            }
        }
        return reported.stream()
                .map(each -> new Finding("topic", false, each, "Change the quality of service of one of them."))
                .toList();
    }

    /// As ROS calls it, where it is a topic of ROS.
    private static String topic(EndpointData endpoint) {
        return RtpsLink.endpoint(endpoint).map(each -> each.topic().name()).orElse(endpoint.topic());
    }
}
