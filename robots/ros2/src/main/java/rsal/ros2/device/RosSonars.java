package rsal.ros2.device;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.device.DeviceInfo;
import rsal.device.SonarArray;
import rsal.robot.RobotModel.Part;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.ScanMessage;

/// Sonars or infrared sensors, each of which publishes `sensor_msgs/Range`. A reading is a round of them: all, or as
/// many as told something before one told again.
final class RosSonars extends RosSensor<RangeArray> implements SonarArray {
    private final Part.Sonars part;
    private final Frames frames;
    private final RobotClock clock;
    private final BitSet round = new BitSet();
    private final float[] ranges;
    private final Pose2d[] baseFromSensors;
    private double fieldOfView;
    private double rangeMin;
    private double rangeMax;
    private long stamp;

    RosSonars(DeviceInfo info, String topic, Part.Sonars part, Frames frames, RobotClock clock) {
        super(info, info.robot() + "/base_link", topic);
        this.part = part;
        this.frames = frames;
        this.clock = clock;
        baseFromSensors = part.baseFromSensors().toArray(Pose2d[]::new);
        ranges = new float[baseFromSensors.length];
        Arrays.fill(ranges, Float.NaN);
        fieldOfView = part.fieldOfView();
        rangeMin = part.rangeMin();
        rangeMax = part.rangeMax();
    }

    /// @param sensor which of them, from 0 on
    void take(int sensor, RosMessage message) {
        RosMessage header = message.message("header");
        FrameTransform usual = FrameTransform.of(part.baseFromSensors().get(sensor));
        Optional<FrameTransform> mount = mount(frames, header.text("frame_id"), RosMessages.stamp(header), usual);
        if (mount.isEmpty()) {
            return;
        }
        if (round.get(sensor)) {
            publishRound();
        }
        stamp = RosMessages.stamp(header);
        fieldOfView = message.number("field_of_view");
        rangeMin = message.number("min_range");
        rangeMax = message.number("max_range");
        ranges[sensor] = ScanMessage.limited((float) message.number("range"), (float) rangeMin, (float) rangeMax);
        baseFromSensors[sensor] = mount.get().planar();
        round.set(sensor);
        if (round.cardinality() == ranges.length) {
            publishRound();
        }
    }

    private void publishRound() {
        float[] now = ranges.clone();
        IntStream.range(0, now.length).filter(sensor -> !round.get(sensor)).forEach(sensor -> now[sensor] = Float.NaN);
        round.clear();
        heard(frames.now());
        publish(clock.time(stamp), new RangeArray(List.of(baseFromSensors), fieldOfView, rangeMin, rangeMax, now));
    }
}
