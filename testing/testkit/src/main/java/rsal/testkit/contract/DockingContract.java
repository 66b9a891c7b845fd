package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.device.Docking;
import rsal.device.Docking.Progress;
import rsal.device.Docking.Result;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;

/// What every [Docking] owes. Its robot knows the dock `home`, and no dock `nowhere`; there is a dock at `a` of the
/// bench's world.
public abstract class DockingContract extends DeviceContract<Docking> {
    private static final double LONG = 60;

    protected DockingContract() {
        super(Docking.class);
    }

    @Test
    void docksByNameAndByPlaceAndLeaves() {
        assertThat(await(device().dock("home").result(), LONG)).isEqualTo(new Result.Reached());
        assertThat(await(device().undock().result(), LONG)).isEqualTo(new Result.Reached());
        assertThat(await(device().dock(WORLD.pose('a', 0), "").result(), LONG)).isEqualTo(new Result.Reached());
        assertStands();
    }

    @Test
    void reportsItsProgress() {
        List<Progress> progress = new ArrayList<>();
        GoalHandle<Progress, Result> handle = device().dock("home");
        handle.onFeedback(reported -> progress.add(reported.value()));
        await(handle.result(), LONG);
        assertThat(progress).isNotEmpty().extracting(Progress::working).isSorted();
        assertThat(progress).extracting(Progress::stage).contains(Docking.Stage.MOVING);
        int reported = progress.size();
        advance(2);
        assertThat(progress).as("told nothing after the end").hasSize(reported);
    }

    @Test
    void aDockThatIsNotKnownFailsWithAReason() {
        assertThat(await(device().dock("nowhere").result(), LONG))
                .isInstanceOfSatisfying(
                        Result.Failed.class, failed -> assertThat(failed.why()).isNotBlank());
        assertStands();
    }

    @Test
    void aNewGoalEndsTheOneBefore() {
        GoalHandle<Progress, Result> first = device().dock("home");
        advance(0.5);
        GoalHandle<Progress, Result> second = device().undock();
        assertThat(await(first.result(), 1)).isInstanceOf(Result.Cancelled.class);
        assertThat(await(second.result(), LONG)).isEqualTo(new Result.Reached());
    }

    @Test
    void standsWhenItIsCancelled() {
        GoalHandle<Progress, Result> handle = device().dock("home");
        advance(2);
        handle.cancel();
        assertThat(await(handle.result(), 1)).isInstanceOf(Result.Cancelled.class);
        assertStands();
        handle.cancel();
    }

    @Test
    void doesNothingWhileMotorsAreOff() {
        GoalHandle<Progress, Result> handle = device().dock("home");
        advance(2);
        robot().require(DriveBase.class).enable(false);
        assertThat(await(handle.result(), 2)).isInstanceOf(Result.Cancelled.class);
        assertThat(await(device().dock("home").result(), 2)).isInstanceOf(Result.Failed.class);
        assertStands();
        robot().require(DriveBase.class).enable(true);
        assertThat(await(device().dock("home").result(), LONG)).isEqualTo(new Result.Reached());
    }

    @Test
    void placesAreFinite() {
        assertThatIllegalArgumentException().isThrownBy(() -> device().dock(new Pose2d(Double.NaN, 0, 0), ""));
    }

    private void assertStands() {
        advance(1);
        Pose2d before = truth();
        advance(1);
        assertThat(truth().distanceTo(before)).isLessThan(0.02);
    }
}
