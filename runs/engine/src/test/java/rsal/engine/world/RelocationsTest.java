package rsal.engine.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import rsal.data.Stamped;

class RelocationsTest {
    private static final Instant TEN = Instant.ofEpochSecond(10);

    private final Relocations placements = new Relocations();

    private static Stamped<String> sensed(long seconds) {
        return new Stamped<>(Instant.ofEpochSecond(seconds), "map", "something");
    }

    @Test
    void whereNobodyWasPlacedAllReadingsAreOfHere() {
        assertThat(placements.isOfHere("r1", sensed(0))).isTrue();
        assertThat(placements.isBeliefOfHere("r1")).isTrue();
    }

    @Test
    void readingsUpToThePlacementAreOfAnotherPlace() {
        placements.add("r1", TEN, CompletableFuture.completedFuture(null));
        assertThat(placements.isOfHere("r1", sensed(9))).isFalse();
        assertThat(placements.isOfHere("r1", sensed(10))).isFalse();
        assertThat(placements.isOfHere("r1", sensed(11))).isTrue();
        assertThat(placements.isOfHere("r2", sensed(9))).isTrue();
    }

    @Test
    void aBeliefIsOfHereOnceTheLocalizerFollows() {
        var follows = new CompletableFuture<Void>();
        placements.add("r1", TEN, follows);
        assertThat(placements.isBeliefOfHere("r1")).isFalse();
        follows.complete(null);
        assertThat(placements.isBeliefOfHere("r1")).isTrue();
    }
}
