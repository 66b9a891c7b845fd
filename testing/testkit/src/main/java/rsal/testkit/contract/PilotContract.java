package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.behavior.Behavior;
import rsal.behavior.Decision;
import rsal.behavior.Percept;
import rsal.behavior.Pilot;
import rsal.behavior.PilotDriver;
import rsal.behavior.PioneerStack;
import rsal.behavior.SetSpeed;
import rsal.behavior.Subsumption;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.robot.DeviceDriver;
import rsal.testkit.Rounds;

/// What the [Pilot] owes on every robot system.
public abstract class PilotContract extends SensorContract<Decision, Pilot> {
    private static final Behavior FORWARD = new SetSpeed(Twist2d.drive(0.3, 0));

    protected PilotContract() {
        super(Pilot.class, "r1/base_link");
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new PilotDriver());
    }

    @Override
    protected void wake() {
        device().engage(new Subsumption().layer("go", FORWARD));
    }

    @Test
    void leavesTheRobotAloneUntilItIsEngaged() {
        advance(2);
        assertThat(truth()).isEqualTo(START);
        assertThat(device().latest()).isEmpty();
        assertThat(device().engaged()).isFalse();
    }

    @Test
    void drivesAsTheStackDecides() {
        wake();
        advance(4);
        assertThat(device().engaged()).isTrue();
        assertThat(truth().x() - START.x()).isBetween(0.8, 1.3);
    }

    @Test
    void reportsWhoIsInCharge() {
        device().engage(new Subsumption()
                .layer("go", FORWARD)
                .layer("turn", (_, below) -> new Twist2d(below.vx(), 0, 0.5))
                .layer("agree", (_, below) -> below));
        advance(1);
        Decision decision = device().latest().orElseThrow().value();
        assertThat(decision.inCharge()).isEqualTo("turn");
        assertThat(decision.twist()).isEqualTo(Twist2d.drive(0.3, 0.5));
        assertThat(decision.opinions()).extracting(Decision.Opinion::layer).containsExactly("go", "turn", "agree");
    }

    @Test
    void releasedItStandsStill() {
        wake();
        advance(2);
        device().release();
        advance(1);
        Pose2d stopped = truth();
        advance(2);
        assertThat(truth()).isEqualTo(stopped);
        assertThat(device().engaged()).isFalse();
    }

    @Test
    void pausedItLeavesTheRobotToOthersAndKeepsItsStack() {
        wake();
        advance(2);
        device().pause();
        advance(1);
        Pose2d stopped = truth();
        var last = device().latest();
        drive(Twist2d.drive(-0.2, 0), 2);
        assertThat(truth().x()).isLessThan(stopped.x() - 0.2);
        assertThat(device().latest()).isEqualTo(last);
        assertThat(device().paused()).isTrue();
        assertThat(device().engaged()).isTrue();
        Pose2d driven = truth();
        device().resume();
        advance(2);
        assertThat(truth().x()).isGreaterThan(driven.x() + 0.2);
    }

    @Test
    void anotherStackTakesOver() {
        wake();
        advance(1);
        device().engage(new Subsumption().layer("spin", new SetSpeed(Twist2d.drive(0, 0.5))));
        advance(2);
        assertThat(device().latest().orElseThrow().value().inCharge()).isEqualTo("spin");
        assertThat(truth().theta()).isGreaterThan(0.5);
    }

    @Test
    void aBehaviorThatThrowsStopsTheRobotAndIsReportedAsLost() {
        var healths = new ArrayList<Health>();
        device().onHealth(healths::add);
        wake();
        advance(1);
        device().engage(new Subsumption().layer("broken", (_, _) -> {
            throw new IllegalStateException("A behavior of a test.");
        }));
        advance(1);
        assertThat(device().engaged()).isFalse();
        assertThat(healths).last().isInstanceOf(Health.Lost.class);
        Pose2d stopped = truth();
        advance(1);
        assertThat(truth()).isEqualTo(stopped);
        wake();
        advance(1);
        assertThat(device().health().isOk()).isTrue();
        assertThat(truth().distanceTo(stopped)).isGreaterThan(0.1);
    }

    @Test
    void aBehaviorThatWantsWhatIsNoNumberCountsAsOneThatThrows() {
        wake();
        advance(1);
        device().engage(new Subsumption().layer("dizzy", (_, _) -> Twist2d.drive(0.3, Double.NaN)));
        advance(1);
        assertThat(device().engaged()).isFalse();
        assertThat(device().health()).isInstanceOf(Health.Lost.class);
    }

    @Test
    void behaviorsPerceiveWhatTheSensorsSee() {
        var percepts = new ArrayList<Percept>();
        device().engage(new Subsumption().layer("look", (percept, below) -> {
            percepts.add(percept);
            return below;
        }));
        advance(1);
        Percept percept = percepts.getLast();
        assertThat(percept.time()).isEqualTo(run.instant());
        assertThat(percept.surroundings().nearest(-0.1, 0.1)).isInfinite(); // along the hall
        assertThat(percept.surroundings().nearest(-2, -1)).isBetween(1.5, 4.5); // the wall on the right
    }

    @Test
    void theThesissPioneerFollowsTheWallAndTouchesNothing() {
        needs(Capability.TRUTH);
        device().engage(PioneerStack.followLeftWall(model()));
        double distance = 0;
        Pose2d last = truth();
        int steps = Rounds.of(400, 1200);
        for (int step = 0; step < steps; step++) {
            run.advance(STEP);
            distance += last.distanceTo(truth());
            last = truth();
        }
        assertThat(simulation().contacts()).isEmpty();
        assertThat(distance).isGreaterThan(0.02 * steps);
    }
}
