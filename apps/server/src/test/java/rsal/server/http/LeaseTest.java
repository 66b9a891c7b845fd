package rsal.server.http;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.server.message.Refusal;

class LeaseTest {
    private final AtomicLong clock = new AtomicLong(Long.MAX_VALUE - 5); // it wraps
    private final Lease lease = new Lease(clock::get);

    @Test
    void allMayWhileNobodyHasIt() {
        assertThat(lease.holder()).isEmpty();
        assertThatCode(() -> lease.check("a")).doesNotThrowAnyException();
        assertThatCode(() -> lease.check("")).doesNotThrowAnyException();
    }

    @Test
    void nobodyElseMayWhileSomebodyHasIt() {
        lease.take("a", "Ann", false);
        assertThat(lease.holder()).contains("Ann");
        assertThatCode(() -> lease.check("a")).doesNotThrowAnyException();
        assertThatThrownBy(() -> lease.check("b")).isInstanceOf(Refusal.class).hasMessageContaining("Ann has control");
        assertThatThrownBy(() -> lease.check("")).isInstanceOf(Refusal.class);
        assertThatThrownBy(() -> lease.take("b", "Bob", false)).isInstanceOf(Refusal.class);
        lease.giveBack("b");
        assertThat(lease.isHeldBy("a")).isTrue();
    }

    @Test
    void knowsWhoHasItAndWhoHadIt() {
        assertThat(lease.name("a")).isEmpty();
        assertThat(lease.name("")).isEmpty();
        lease.take("a", " Ann ", false);
        assertThat(lease.name("a")).isEqualTo("Ann");
        assertThat(lease.name("b")).isEqualTo("somebody without control");
        assertThat(lease.name("")).isEqualTo("somebody without control");
        lease.take("b", "Bob", true);
        assertThat(lease.name("a")).isEqualTo("Ann");
        lease.giveBack("b");
        for (int i = 0; i < 100; i++) {
            lease.take("another " + i, "Carl", true);
        }
        assertThat(lease.name("b")).as("of long ago").isEqualTo("somebody without control");
    }

    @Test
    void isKeptByWhoeverHasItOnly() {
        lease.keep("a");
        assertThat(lease.holder()).as("as nobody had it").isEmpty();
        lease.take("a", "Ann", false);
        clock.addAndGet(Lease.TERM.toNanos() - 1);
        lease.keep("a");
        lease.keep("b");
        clock.addAndGet(Lease.TERM.toNanos() - 1);
        assertThat(lease.holder()).contains("Ann");
        clock.addAndGet(1);
        assertThat(lease.holder()).isEmpty();
    }

    @Test
    void isNotKeptByWhatComesAfterItWasGivenBack() {
        lease.take("a", "Ann", false);
        lease.giveBack("a");
        lease.keep("a");
        assertThat(lease.holder()).isEmpty();
    }

    @Test
    void isTakenOverAndGivenBack() {
        lease.take("a", "Ann", false);
        lease.take("b", " Bob ", true);
        assertThat(lease.holder()).contains("Bob");
        assertThatThrownBy(() -> lease.check("a")).hasMessageContaining("Bob");
        lease.giveBack("b");
        assertThat(lease.holder()).isEmpty();
    }

    @Test
    void endsWhenItIsNotTakenAgain() {
        lease.take("a", "Ann", false);
        clock.addAndGet(Lease.TERM.toNanos() - 1);
        lease.take("a", "Ann", false);
        clock.addAndGet(Lease.TERM.toNanos() - 1);
        assertThat(lease.holder()).contains("Ann");
        clock.addAndGet(1);
        assertThat(lease.holder()).isEmpty();
        assertThat(lease.isHeldBy("a")).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "  ", "a\nb", "0123456789012345678901234567890123456789012345678901234567890123456789"})
    void nobodyIsCalledLikeThat(String name) {
        assertThatThrownBy(() -> lease.take("a", name, false)).isInstanceOf(Refusal.class);
        assertThatThrownBy(() -> lease.take(name, "Ann", false)).isInstanceOf(Refusal.class);
    }
}
