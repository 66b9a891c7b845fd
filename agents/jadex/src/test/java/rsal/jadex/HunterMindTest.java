package rsal.jadex;

import static org.assertj.core.api.Assertions.assertThat;

import jadex.bridge.IExternalAccess;
import jadex.bridge.service.types.cms.CreationInfo;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
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

    @BeforeEach
    void think() throws Exception {
        platform.createComponent(new CreationInfo().setFilename(HunterBDI.FILE).addArgument(HunterBDI.BODY, deeds));
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
            assertThat(deeds.none()).isTrue();
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
        assertThat(deeds.none()).isTrue();
    }

    @Test
    void wantsNothingOnceThePreyIsCaught() throws Exception {
        deeds.mind.get().knowsPrey(true);
        assertThat(deeds.next()).isEqualTo("approach");
        deeds.mind.get().preyIsCaught();
        deeds.end();
        untilItWants(true);
        assertThat(deeds.none()).isTrue();
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

        @Override
        public void begun(Thinking thinking) {
            mind.complete(thinking);
        }

        @Override
        public void lookOut() {
            done.add("look out");
        }

        @Override
        public void approach(Runnable over) {
            ends.add(over);
            done.add("approach");
        }

        @Override
        public void wants(List<Desire> desires) {
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

        boolean none() throws InterruptedException {
            return done.poll(100, TimeUnit.MILLISECONDS) == null;
        }
    }
}
