package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.engine.report.Answer;
import rsal.engine.report.RobotView;
import rsal.engine.report.Snapshot;
import rsal.server.description.Descriptions;
import rsal.server.frame.FrameEncoder;
import rsal.server.message.Messages.RealDetails;

/// How the page is told of robots that nobody simulates.
class RealRobotsTest {
    private static final Pose2d THERE = new Pose2d(1.5, -2, 0);

    private static Snapshot snapshot(Optional<RobotView.Real> real) {
        var robot = new RobotView(
                "ann",
                "hunter",
                "#0072b2",
                "pioneer3at",
                false,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Path2d.EMPTY,
                Path2d.EMPTY,
                Optional.empty(),
                "",
                "",
                "",
                Optional.empty(),
                false,
                false,
                false,
                List.of(),
                real,
                List.of(),
                List.of());
        return new Snapshot(
                1,
                Duration.ofSeconds(9),
                false,
                false,
                1,
                1,
                Optional.empty(),
                List.of(robot),
                List.of(),
                List.of(),
                List.of(),
                Answer.Linked.NONE);
    }

    private static Optional<RobotView.Real> real(Optional<Pose2d> standIn, Optional<Duration> silence) {
        return Optional.of(new RobotView.Real(true, standIn, silence));
    }

    private static Optional<RealDetails> details(Optional<RobotView.Real> real) {
        return Descriptions.details(1, snapshot(real), new CompletableFuture<>())
                .robots()
                .getFirst()
                .real();
    }

    @Test
    void oneThatNobodyElsePlacesIsWhereItsStandInIs() {
        ByteBuffer frame = ByteBuffer.wrap(new FrameEncoder()
                        .encode(1, 1, snapshot(real(Optional.of(THERE), Optional.empty())), List.of("ann"), List.of()))
                .order(ByteOrder.LITTLE_ENDIAN);
        assertThat(frame.getInt(FrameEncoder.HEADER_BYTES)).isEqualTo(1500);
        assertThat(frame.getInt(FrameEncoder.HEADER_BYTES + 4)).isEqualTo(-2000);
        assertThat(frame.getShort(FrameEncoder.HEADER_BYTES + 14)).isEqualTo((short) FrameEncoder.PRESENT);
    }

    @Test
    void silenceIsReportedOnceItIsLong() {
        assertThat(details(real(Optional.empty(), Optional.empty()))).contains(new RealDetails(true, Optional.empty()));
        assertThat(details(real(Optional.empty(), Optional.of(Duration.ofMillis(900)))))
                .contains(new RealDetails(true, Optional.empty()));
        assertThat(details(real(Optional.empty(), Optional.of(Duration.ofMillis(3900)))))
                .contains(new RealDetails(true, Optional.of(3.0)));
    }

    @Test
    void simulatedOnesAreNotReal() {
        assertThat(details(Optional.empty())).isEmpty();
    }
}
