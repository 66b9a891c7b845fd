package rsal.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import org.junit.jupiter.api.Test;

class AreaTest {
    @Test
    void namesBelongToTheirAreaAndDiffer() {
        for (Area area : Area.all()) {
            assertThat(area.names()).doesNotHaveDuplicates().allMatch(name -> name.startsWith(area.name() + "."));
        }
    }

    @Test
    void theMedianCounts() {
        assertThat(Result.more("a", "s/s", 3, 1, 2)).isEqualTo(new Result("a", 2, 1, 3, "s/s", "more"));
        assertThat(Result.less("a", "B", 4, 1).value()).isEqualTo(2.5);
    }

    @Test
    void whatIsNotWantedIsNotMeasured() {
        var results = new ArrayList<Result>();
        Area.all().getFirst().measure(new ArrayList<>(), 1, results::add);
        assertThat(results).isEmpty();
    }
}
