package rsal.world.yaml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.ArrayList;
import org.junit.jupiter.api.Test;
import rsal.data.FreeSpace;
import rsal.data.OccupancyGrid;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.testkit.LongTest;

class SpacesTest {
    private static final Location HERE = Location.of("here");

    private static OccupancyGrid map(int side) {
        return new OccupancyGrid(side, side, 0.05, 0, 0, new byte[side * side]);
    }

    @Test
    void whatNoCellDistinguishesIsOne() {
        var spaces = new Spaces(map(40));
        FreeSpace space = spaces.with(0.501, HERE);
        assertThat(spaces.with(0.502, HERE)).isSameAs(space);
        assertThat(spaces.with(0.6, HERE)).isNotSameAs(space);
        assertThat(spaces.with(0.501, HERE)).isSameAs(space);
    }

    @LongTest
    @Test
    void onlySomeOfALargeMapAreKept() {
        var spaces = new Spaces(map(4000));
        var first = new ArrayList<FreeSpace>();
        for (int i = 0; i < 5; i++) {
            first.add(spaces.with(60 + 5 * i, HERE));
        }
        assertThat(spaces.with(80, HERE)).isSameAs(first.getLast());
        assertThat(spaces.with(60, HERE)).isNotSameAs(first.getFirst());
    }

    @Test
    void tooManyAreRefused() {
        var spaces = new Spaces(map(100), 50 * 10_000);
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> {
                    for (int i = 0; i < 51; i++) {
                        spaces.with(0.05 * i, HERE);
                    }
                })
                .satisfies(refused -> assertThat(refused.problems())
                        .singleElement()
                        .asString()
                        .contains("too many different clearances for a map of 10000 cells"));
    }
}
