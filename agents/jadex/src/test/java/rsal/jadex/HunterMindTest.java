package rsal.jadex;

import static org.assertj.core.api.Assertions.assertThat;

import jadex.bridge.IExternalAccess;
import jadex.bridge.service.types.cms.CreationInfo;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.jadex.hunt.mind.HunterBDI;
import rsal.jadex.hunt.mind.Hunting;
import rsal.jadex.hunt.mind.Thinking;

/// The mind of a hunter alone, in Jadex.
@Timeout(60)
class HunterMindTest {
    private final IExternalAccess platform = LonelyPlatform.start();
    private final Deeds deeds = new Deeds();
    private final IExternalAccess mind = platform.createComponent(
                    new CreationInfo().setFilename(HunterBDI.FILE).addArgument(HunterBDI.BODY, deeds))
            .get();

    @BeforeEach
    void think() throws Exception {
        assertThat(deeds.next()).isEqualTo("look out");
    }

    @AfterEach
    void end() {
        platform.killComponent().get();
    }

    @Test
    void goesForThePreyAgainAndAgainWhileItKnowsWhereThatIs() throws Exception {
        deeds.mind.get().knowsPrey(true);
        for (int i = 0; i < 5; i++) {
            assertThat(deeds.next()).isEqualTo("approach");
            assertNothingMoreToDo(true);
            deeds.end();
        }
        untilItWants(true, "find SUSPENDED", "catch ACTIVE");
    }

    @Test
    void looksOutAgainWhenItDoesNotKnowAnyMore() throws Exception {
        for (int i = 0; i < 3; i++) {
            deeds.mind.get().knowsPrey(true);
            assertThat(deeds.next()).isEqualTo("approach");
            deeds.mind.get().knowsPrey(false);
            assertThat(deeds.next()).isEqualTo("look out");
        }
        untilItWants(false, "find ACTIVE", "catch SUSPENDED");
        deeds.end(); // too late
        assertNothingMoreToDo(false);
    }

    @Test
    void wantsNothingOnceThePreyIsCaught() throws Exception {
        deeds.mind.get().knowsPrey(true);
        assertThat(deeds.next()).isEqualTo("approach");
        deeds.mind.get().preyIsCaught();
        deeds.end();
        untilItWants(true);
        assertNothingMoreToDo(true);
    }

    @Test
    void reportsFaultsOfItsThoughts() throws Exception {
        deeds.slips = true;
        deeds.mind.get().knowsPrey(false);
        assertThat(deeds.faults.take())
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("a slip");
    }

    /// Jadex would try one that fails again and again.
    @Test
    void reportsFaultsOfItsPlans() throws Exception {
        deeds.stumbles = true;
        deeds.mind.get().knowsPrey(true);
        assertThat(deeds.faults.take())
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("approach");
        deeds.mind.get().knowsPrey(false);
        Throwable fault = deeds.faults.take();
        while (!"look out".equals(fault.getMessage())) { // those of before
            fault = deeds.faults.take();
        }
    }

    @Test
    void itsEndIsNoFault() throws Exception {
        var end = mind.killComponent();
        for (int i = 0; i < 1000; i++) {
            deeds.mind.get().knowsPrey(i % 2 == 0);
        }
        end.get();
        deeds.mind.get().knowsPrey(true);
        assertThat(deeds.faults).isEmpty();
    }

    /// It does what it has begun in a few steps of its own, so none is left after many that bring nothing new.
    private void assertNothingMoreToDo(boolean known) throws Exception {
        for (int i = 0; i < 50; i++) {
            deeds.wants.clear();
            deeds.mind.get().knowsPrey(known);
            deeds.wants.take();
        }
        assertThat(deeds.done).isEmpty();
        assertThat(deeds.faults).isEmpty();
    }

    /// Tells it the same again and again, as it says what it wants whenever it has been told something.
    private void untilItWants(boolean known, String... desires) throws Exception {
        do {
            deeds.mind.get().knowsPrey(known);
        } while (!deeds.wants.take().equals(List.of(desires)));
    }

    /// Notes what is to be done, and lasts until it is told to end.
    private static final class Deeds implements Hunting {
        private final CompletableFuture<Thinking> mind = new CompletableFuture<>();
        private final BlockingQueue<String> done = new LinkedBlockingQueue<>();
        private final BlockingQueue<Runnable> ends = new LinkedBlockingQueue<>();
        private final BlockingQueue<List<String>> wants = new LinkedBlockingQueue<>();
        private final BlockingQueue<Throwable> faults = new LinkedBlockingQueue<>();
        private volatile boolean slips; // when it is told what is wanted
        private volatile boolean stumbles; // when it is to do something

        @Override
        public void begun(Thinking thinking) {
            mind.complete(thinking);
        }

        @Override
        public void lookOut() {
            begin("look out");
        }

        @Override
        public void approach(Runnable over) {
            ends.add(over);
            begin("approach");
        }

        private void begin(String deed) {
            if (stumbles) {
                throw new IllegalStateException(deed);
            }
            done.add(deed);
        }

        @Override
        public void failed(Throwable fault) {
            faults.add(fault);
        }

        @Override
        public void wants(List<Desire> desires) {
            if (slips) {
                throw new IllegalStateException("a slip");
            }
            wants.add(desires.stream()
                    .map(desire -> desire.name() + " " + desire.state())
                    .toList());
        }

        void end() throws InterruptedException {
            ends.take().run();
        }

        String next() throws InterruptedException {
            return done.take();
        }
    }
}
