package rsal.player.message;

import static rsal.player.wire.MessageKind.COMMAND;
import static rsal.player.wire.MessageKind.DATA;
import static rsal.player.wire.MessageKind.REQUEST;
import static rsal.player.wire.MessageKind.SYNCH;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rsal.player.wire.Header;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

/// Which message has which body, in a version of Player. Immutable.
public final class Protocol {
    /// Of Player 3.1 and later.
    public static final Protocol V3_1 = new Protocol("3.1.1");

    /// Of Player 2 and 3.0: covariances have three numbers, tiles of maps no range, ways no length.
    public static final Protocol V3_0 = V3_1.older();

    private static final Pattern OLD = Pattern.compile("Player v\\.([012]|3\\.0)\\..*");

    private final Map<Key, Class<? extends Record>> bodies = new HashMap<>();
    private final String version;

    private record Key(int interf, MessageKind kind, int subtype) {}

    private Protocol(String version) {
        this.version = version;
        of(Interface.PLAYER, REQUEST)
                .has(Session.DEVICES, Session.Devices.class)
                .has(Session.DRIVER, Session.Driver.class)
                .has(Session.DEVICE, Session.Subscription.class)
                .has(Session.MODE, Session.Mode.class)
                .has(Session.AUTHENTICATION, Session.Authentication.class)
                .has(Session.NAME_SERVICE, Session.NamedService.class)
                .has(Session.REPLACE_RULE, Session.ReplaceRule.class);
        of(Interface.PLAYER, SYNCH).has(Session.OVERFLOW, Session.Lost.class);
        of(Interface.POWER, DATA).has(Power.STATE, Power.State.class);
        of(Interface.POWER, REQUEST).has(Power.CHARGING, Power.Charging.class);
        of(Interface.GRIPPER, DATA).has(GripperInterface.STATE, GripperInterface.State.class);
        of(Interface.GRIPPER, REQUEST).has(GripperInterface.GEOMETRY, GripperInterface.Geometry.class);
        of(Interface.POSITION2D, DATA)
                .has(Position2d.STATE, Position2d.State.class)
                .has(Position2d.GEOMETRY_DATA, Position2d.Geometry.class);
        of(Interface.POSITION2D, COMMAND)
                .has(Position2d.VELOCITY, Position2d.Velocity.class)
                .has(Position2d.GOAL, Position2d.Goal.class)
                .has(Position2d.CAR, Position2d.Car.class)
                .has(Position2d.VELOCITY_HEADING, Position2d.VelocityHeading.class);
        of(Interface.POSITION2D, REQUEST)
                .has(Position2d.GEOMETRY, Position2d.Geometry.class)
                .has(Position2d.MOTORS, Position2d.Motors.class)
                .has(Position2d.VELOCITY_MODE, Position2d.VelocityMode.class)
                .has(Position2d.POSITION_MODE, Position2d.PositionMode.class)
                .has(Position2d.SET_ODOMETRY, Position2d.Odometry.class)
                .has(Position2d.SPEED_GAINS, Position2d.Gains.class)
                .has(Position2d.POSITION_GAINS, Position2d.Gains.class)
                .has(Position2d.SPEED_PROFILE, Position2d.SpeedProfile.class);
        of(Interface.SONAR, DATA).has(Sonar.RANGES, Sonar.Ranges.class).has(Sonar.GEOMETRY_DATA, Sonar.Geometry.class);
        of(Interface.SONAR, REQUEST).has(Sonar.GEOMETRY, Sonar.Geometry.class).has(Sonar.POWER, Sonar.Power.class);
        of(Interface.LASER, DATA)
                .has(Laser.SCAN, Laser.Scan.class)
                .has(Laser.SCAN_POSE, Laser.ScanPose.class)
                .has(Laser.SCAN_ANGLES, Laser.ScanAngles.class);
        of(Interface.LASER, REQUEST)
                .has(Laser.GEOMETRY, Laser.Geometry.class)
                .has(Laser.SET_CONFIGURATION, Laser.Configuration.class)
                .has(Laser.CONFIGURATION, Laser.Configuration.class)
                .has(Laser.POWER, Laser.Power.class)
                .has(Laser.IDENTITY, Laser.Identity.class)
                .has(Laser.FILTER, Laser.Filter.class);
        of(Interface.BLOBFINDER, DATA).has(Blobfinder.BLOBS, Blobfinder.Blobs.class);
        of(Interface.BLOBFINDER, REQUEST)
                .has(Blobfinder.SET_COLOR, Blobfinder.ColorRange.class)
                .has(Blobfinder.SET_IMAGER, Blobfinder.Imager.class)
                .has(Blobfinder.COLOR, Blobfinder.ColorRange.class);
        of(Interface.FIDUCIAL, DATA).has(Fiducial.SCAN, Fiducial.Markers.class);
        of(Interface.FIDUCIAL, REQUEST)
                .has(Fiducial.GEOMETRY, Fiducial.Geometry.class)
                .has(Fiducial.VIEW, Fiducial.View.class)
                .has(Fiducial.SET_VIEW, Fiducial.View.class)
                .has(Fiducial.IDENTITY, Fiducial.Identity.class)
                .has(Fiducial.SET_IDENTITY, Fiducial.Identity.class);
        of(Interface.SPEECH, COMMAND).has(SpeechInterface.SAY, SpeechInterface.Say.class);
        of(Interface.BUMPER, DATA)
                .has(BumperInterface.STATE, BumperInterface.State.class)
                .has(BumperInterface.GEOMETRY_DATA, BumperInterface.Geometry.class);
        of(Interface.BUMPER, REQUEST).has(BumperInterface.GEOMETRY, BumperInterface.Geometry.class);
        of(Interface.DIO, DATA).has(Dio.VALUES, Dio.Values.class);
        of(Interface.DIO, COMMAND).has(Dio.VALUES, Dio.Values.class);
        of(Interface.LOCALIZE, DATA).has(Localize.HYPOTHESES, Localize.Hypotheses.class);
        of(Interface.LOCALIZE, REQUEST)
                .has(Localize.SET_POSE, Localize.SetPose.class)
                .has(Localize.PARTICLES, Localize.Particles.class);
        of(Interface.SIMULATION, REQUEST)
                .has(Simulation.POSE, Simulation.Placed.class)
                .has(Simulation.SET_POSE, Simulation.Placed.class)
                .has(Simulation.POSE3, Simulation.Placed3.class)
                .has(Simulation.SET_POSE3, Simulation.Placed3.class)
                .has(Simulation.PROPERTY, Simulation.Property.class)
                .has(Simulation.SET_PROPERTY, Simulation.Property.class);
        of(Interface.MAP, DATA).has(MapInterface.INFO_DATA, MapInterface.Extent.class);
        of(Interface.MAP, REQUEST)
                .has(MapInterface.INFO, MapInterface.Extent.class)
                .has(MapInterface.TILE, MapInterface.Tile.class)
                .has(MapInterface.LINES, MapInterface.Lines.class);
        of(Interface.PLANNER, DATA).has(PlannerInterface.STATE, PlannerInterface.State.class);
        of(Interface.PLANNER, COMMAND)
                .has(PlannerInterface.GOAL, PlannerInterface.Place.class)
                .has(PlannerInterface.START, PlannerInterface.Place.class);
        of(Interface.PLANNER, REQUEST)
                .has(PlannerInterface.WAYPOINTS, PlannerInterface.Waypoints.class)
                .has(PlannerInterface.ENABLE, PlannerInterface.Enable.class);
        of(Interface.OPAQUE, DATA).has(Opaque.DATA, Opaque.Bytes.class);
        of(Interface.OPAQUE, COMMAND).has(Opaque.DATA, Opaque.Bytes.class);
        of(Interface.OPAQUE, REQUEST).has(Opaque.DATA, Opaque.Bytes.class);
        of(Interface.ACTARRAY, DATA).has(Actarray.STATE, Actarray.State.class);
        of(Interface.ACTARRAY, COMMAND)
                .has(Actarray.POSITION, Actarray.Position.class)
                .has(Actarray.POSITIONS, Actarray.Positions.class)
                .has(Actarray.SPEED, Actarray.Speed.class)
                .has(Actarray.SPEEDS, Actarray.Speeds.class)
                .has(Actarray.HOME, Actarray.Home.class)
                .has(Actarray.CURRENT, Actarray.Current.class)
                .has(Actarray.CURRENTS, Actarray.Currents.class);
        of(Interface.ACTARRAY, REQUEST)
                .has(Actarray.POWER, Actarray.Power.class)
                .has(Actarray.BRAKES, Actarray.Brakes.class)
                .has(Actarray.GEOMETRY, Actarray.Geometry.class)
                .has(Actarray.SET_SPEED, Actarray.Speed.class)
                .has(Actarray.SET_ACCELERATION, Actarray.Acceleration.class);
        of(Interface.GRAPHICS2D, COMMAND)
                .has(Graphics2d.POINTS, Graphics2d.Points.class)
                .has(Graphics2d.POLYLINE, Graphics2d.Points.class)
                .has(Graphics2d.POLYGON, Graphics2d.Polygon.class)
                .has(Graphics2d.LINES, Graphics2d.Points.class);
        of(Interface.RANGER, DATA)
                .has(Ranger.RANGES, Ranger.Ranges.class)
                .has(Ranger.RANGES_STAMPED, Ranger.RangesStamped.class)
                .has(Ranger.INTENSITIES, Ranger.Intensities.class)
                .has(Ranger.INTENSITIES_STAMPED, Ranger.IntensitiesStamped.class)
                .has(Ranger.GEOMETRY_DATA, Ranger.Geometry.class);
        of(Interface.RANGER, REQUEST)
                .has(Ranger.GEOMETRY, Ranger.Geometry.class)
                .has(Ranger.POWER, Ranger.Power.class)
                .has(Ranger.WITH_INTENSITIES, Ranger.WithIntensities.class)
                .has(Ranger.SET_CONFIGURATION, Ranger.Configuration.class)
                .has(Ranger.CONFIGURATION, Ranger.Configuration.class);
    }

    private interface Row {
        Row has(int subtype, Class<? extends Record> body);
    }

    private Row of(Interface interf, MessageKind kind) {
        return new Row() {
            @Override
            public Row has(int subtype, Class<? extends Record> body) {
                bodies.put(new Key(interf.code(), kind, subtype), body);
                return this;
            }
        };
    }

    private Protocol older() {
        var older = new Protocol("3.0.2");
        older.of(Interface.LOCALIZE, DATA).has(Localize.HYPOTHESES, Version30.Hypotheses.class);
        older.of(Interface.LOCALIZE, REQUEST).has(Localize.SET_POSE, Version30.SetPose.class);
        older.of(Interface.MAP, REQUEST).has(MapInterface.TILE, Version30.Tile.class);
        older.of(Interface.PLANNER, REQUEST).has(PlannerInterface.WAYPOINTS, Version30.Waypoints.class);
        return older;
    }

    /// That of a server, by how it introduces itself; of one that says nothing known the newest.
    public static Protocol of(String ident) {
        return OLD.matcher(ident).matches() ? V3_0 : V3_1;
    }

    /// That of the sender of a message: this one, unless the body is just what another version has. Clients don't say
    /// which version they are of.
    public Protocol ofSender(Packet packet) {
        return Stream.of(this, V3_1, V3_0)
                .filter(one -> one.fits(packet))
                .findFirst()
                .orElse(this);
    }

    private boolean fits(Packet packet) {
        try {
            read(packet);
            return true;
        } catch (MalformedException e) {
            return false;
        }
    }

    /// `3.1.1`
    public String version() {
        return version;
    }

    /// The record that the body of a message is; empty when it has none that is known. Answers have that of their
    /// requests.
    public Optional<Class<? extends Record>> body(Header header) {
        MessageKind kind =
                header.kind() == MessageKind.ACK || header.kind() == MessageKind.NACK ? REQUEST : header.kind();
        return Optional.ofNullable(bodies.get(new Key(header.address().interf(), kind, header.subtype())));
    }

    /// What a message says; empty when it has no body, or none that is known.
    ///
    /// @throws MalformedException when its body is not what it should be
    public Optional<Record> read(Packet packet) throws MalformedException {
        Optional<Class<? extends Record>> body = body(packet.header());
        return packet.body().length == 0 || body.isEmpty() ? Optional.empty() : Optional.of(packet.body(body.get()));
    }

    /// What a message says, in the words of the newest version; empty when it has no body, or none that is known.
    ///
    /// @throws MalformedException when its body is not what it should be
    public Optional<Record> readAsNewest(Packet packet) throws MalformedException {
        return read(packet).map(Version30::newer);
    }

    /// The same message in the words of the newest version, and without what stands behind the end of its body, as
    /// Player takes it.
    ///
    /// @throws MalformedException when its body ends too early or says what can't be, or such messages have none
    public Packet asNewest(Packet packet) throws MalformedException {
        if (packet.body().length == 0) {
            return packet;
        }
        Header header = packet.header();
        Class<? extends Record> body = body(header)
                .orElseThrow(() -> new MalformedException("Message %d (%s) of interface '%d' has no body."
                        .formatted(
                                header.subtype(),
                                header.kind(),
                                header.address().interf())));
        return packet.with(Version30.newer(packet.start(body)));
    }

    /// A message's body in the words of this version.
    ///
    /// @param body in those of the newest
    public Record worded(Record body) {
        return this == V3_0 ? Version30.older(body) : body;
    }
}
