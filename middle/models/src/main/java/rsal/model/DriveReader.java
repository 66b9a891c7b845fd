package rsal.model;

import java.util.List;
import java.util.Optional;
import rsal.data.Interval;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotModel.Wheels;
import rsal.settings.Section;
import rsal.settings.Suggestion;

/// Reads the `drive` of a model file.
final class DriveReader {
    private static final List<String> TYPES = List.of("differential", "omnidirectional", "car");

    /// Worlds of Stage have 999999 where odometry shall be of no use.
    private static final double MOST_NOISE = 1e9;

    private DriveReader() {}

    static Drive read(Section drive) {
        String type = drive.text("type", "differential");
        Steering steering = switch (type) {
            case "differential" -> new Steering.Differential(wheels(drive));
            case "omnidirectional" -> new Steering.Omnidirectional();
            case "car" ->
                new Steering.Car(
                        NumberReader.positive(drive, "wheelbase"),
                        Math.toRadians(NumberReader.checked(drive, "maxSteeringAngle", 1, 80)));
            default -> {
                drive.problem("type", "There is no type of drive '%s'.".formatted(type), Suggestion.among(type, TYPES));
                yield new Steering.Differential();
            }
        };
        Axis forward = new Axis(
                NumberReader.bothWays(drive, "maxSpeed", true), NumberReader.bothWays(drive, "maxAcceleration", false));
        Axis sideways = steering instanceof Steering.Omnidirectional
                ? new Axis(
                        NumberReader.bothWays(drive, "maxSideSpeed", true),
                        NumberReader.bothWays(drive, "maxSideAcceleration", false))
                : Axis.NONE;
        Axis turn = new Axis(
                radians(NumberReader.bothWays(drive, "maxTurnRate", false)),
                radians(NumberReader.bothWays(drive, "maxTurnAcceleration", false)));
        OdometryNoise noise = noise(drive.section("odometryNoise"));
        drive.done();
        return new Drive(steering, forward, sideways, turn, noise);
    }

    private static Optional<Wheels> wheels(Section drive) {
        if (!drive.has("wheels")) {
            return Optional.empty();
        }
        Section wheels = drive.section("wheels");
        var read = new Wheels(NumberReader.positive(wheels, "radius"), NumberReader.positive(wheels, "track"));
        wheels.done();
        return Optional.of(read);
    }

    private static OdometryNoise noise(Section noise) {
        double distancePerMeter = NumberReader.checked(noise, "distancePerMeter", 0, MOST_NOISE);
        double headingPerMeter = NumberReader.checked(noise, "headingPerMeter", 0, MOST_NOISE);
        double headingPerDegree = NumberReader.checked(noise, "headingPerDegree", 0, MOST_NOISE);
        noise.done();
        return new OdometryNoise(
                distancePerMeter, Math.toRadians(headingPerMeter), Math.sqrt(Math.toRadians(1)) * headingPerDegree);
    }

    private static Interval radians(Interval degrees) {
        return new Interval(Math.toRadians(degrees.least()), Math.toRadians(degrees.most()));
    }
}
