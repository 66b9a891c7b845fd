package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Stamped;
import rsal.device.Sensor;
import rsal.device.Subscription;

/// What everything with readings owes.
public abstract class SensorContract<T, D extends Sensor<T>> extends DeviceContract<D> {
    private final String frame;

    /// @param frame of the readings
    protected SensorContract(Class<D> type, String frame) {
        super(type);
        this.frame = frame;
    }

    /// Makes the sensor have readings, for those that have none by themselves.
    protected void wake() {}

    /// The newest reading after a while.
    protected final T reading() {
        wake();
        advance(1);
        return device().latest().orElseThrow().value();
    }

    @Test
    final void itsReadingsAreInItsFrame() {
        reading();
        assertThat(device().latest().orElseThrow().frame()).isEqualTo(frame);
    }

    @Test
    final void reportsEveryReadingOnceInTheOrderOfTime() {
        wake();
        var times = new ArrayList<Instant>();
        var newest = new ArrayList<Boolean>();
        device().subscribe(reading -> {
            times.add(reading.time());
            newest.add(device().latest().orElseThrow().equals(reading));
            assertThat(reading.time()).isBeforeOrEqualTo(run.instant());
            assertThat(reading.time()).isAfterOrEqualTo(run.instant().minus(Duration.ofSeconds(1)));
        });
        advance(3);
        assertThat(times).hasSizeGreaterThanOrEqualTo(3).isSorted().doesNotHaveDuplicates();
        assertThat(newest).doesNotContain(false);
    }

    @Test
    final void nextIsTheReadingAfterNow() {
        reading();
        Instant before = device().latest().orElseThrow().time();
        Stamped<T> next = await(device().next());
        assertThat(next.time()).isAfter(before);
        assertThat(next).isSameAs(device().latest().orElseThrow());
    }

    @Test
    final void listenersAreCalledInTheOrderInWhichTheyCame() {
        wake();
        var reported = new ArrayList<String>();
        device().subscribe(_ -> reported.add("first"));
        device().subscribe(_ -> reported.add("second"));
        await(device().next());
        assertThat(reported.subList(0, 2)).containsExactly("first", "second");
    }

    @Test
    final void noCallbackComesAfterCancel() {
        wake();
        var reported = new ArrayList<Stamped<T>>();
        Subscription subscription = device().subscribe(reported::add);
        await(device().next());
        int before = reported.size();
        subscription.cancel();
        subscription.cancel();
        advance(2);
        assertThat(before).isPositive();
        assertThat(reported).hasSize(before);
    }

    @Test
    final void aListenerMayCancelAnotherThatIsDue() {
        wake();
        var reported = new ArrayList<String>();
        var later = new ArrayList<Subscription>();
        device().subscribe(_ -> later.forEach(Subscription::cancel));
        later.add(device().subscribe(_ -> reported.add("cancelled")));
        advance(2);
        assertThat(reported).isEmpty();
    }

    @Test
    final void aListenerThatThrowsLosesItsPlaceAndHarmsNobody() {
        wake();
        var reported = new ArrayList<String>();
        device().subscribe(_ -> {
            reported.add("bad");
            throw new IllegalStateException("A listener that a test made to fail.");
        });
        device().subscribe(_ -> reported.add("good"));
        advance(3);
        assertThat(reported.stream().filter("bad"::equals)).hasSize(1);
        assertThat(reported.stream().filter("good"::equals)).hasSizeGreaterThan(1);
        assertThat(device().health().isOk()).isTrue();
    }

    @Test
    final void everythingHappensOnTheRunsThread() {
        wake();
        var threads = new HashSet<Thread>();
        device().subscribe(_ -> threads.add(Thread.currentThread()));
        advance(2);
        assertThat(List.copyOf(threads)).containsExactly(Thread.currentThread());
    }
}
