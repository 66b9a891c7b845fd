package rsal.server.frame;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.SimulationControl.Standing;
import rsal.server.message.Json;
import rsal.server.message.Messages.ThingInfo;

class ObjectTrackerTest {
    private final ObjectTracker surveyor = new ObjectTracker(1);

    private static Standing thing(int number, double x) {
        Shape shape = number % 2 == 0
                ? new Shape.Disc(new Point2d(0.1, 0), 0.2)
                : new Shape.Polygon(List.of(new Point2d(0, 0), new Point2d(1, 0), new Point2d(0, 1.00004)));
        var piece = rsal.data.Prism.standing(shape, 0.5).in(new Rgb(1, 2, 3));
        return new Standing(number, "thing-" + number, new Solid(List.of(piece)), new Pose2d(x, 0, 0), 0, false);
    }

    @Test
    void describesEachThing() {
        surveyor.look(List.of(thing(1, 5), thing(2, 6)));
        assertThat(Json.write(surveyor.roster().all().values()))
                .isEqualTo("[{\"number\":1,\"name\":\"thing-1\",\"x\":5.0,\"y\":0.0,\"heading\":0.0,\"height\":0.0,"
                        + "\"pieces\":[{\"color\":\"#010203\",\"corners\":[[0.0,0.0],[1.0,0.0],[0.0,1.0]],"
                        + "\"radius\":0.0,\"low\":0.0,\"high\":0.5}]},"
                        + "{\"number\":2,\"name\":\"thing-2\",\"x\":6.0,\"y\":0.0,\"heading\":0.0,\"height\":0.0,"
                        + "\"pieces\":[{\"color\":\"#010203\",\"corners\":[[0.1,0.0]],"
                        + "\"radius\":0.2,\"low\":0.0,\"high\":0.5}]}]");
    }

    @Test
    void knowsWhatIsElsewhereThanItWasReported() {
        surveyor.look(List.of(thing(1, 5), thing(2, 6)));
        assertThat(surveyor.moved()).isEmpty();
        ObjectRegistry before = surveyor.roster();
        surveyor.look(List.of(thing(1, 5), thing(2, 7)));
        assertThat(surveyor.moved()).containsExactly(thing(2, 7));
        assertThat(surveyor.roster()).isSameAs(before);
        surveyor.look(List.of(thing(1, 5), thing(2, 7), thing(3, 1)));
        assertThat(surveyor.moved()).as("it was told where it was first").containsExactly(thing(2, 7));
        assertThat(surveyor.roster().all().get(2)).extracting(ThingInfo::x).isEqualTo(6.0);
        surveyor.look(List.of(thing(1, 5), thing(2, 6), thing(3, 1)));
        assertThat(surveyor.moved()).isEmpty();
    }

    @Test
    void noticesWhenOneGoesAndAnotherComes() {
        surveyor.look(List.of(thing(1, 5), thing(2, 6)));
        surveyor.look(List.of(thing(2, 6), thing(3, 5)));
        assertThat(surveyor.roster().all().keySet()).containsExactly(2, 3);
        surveyor.look(List.of(thing(3, 5)));
        assertThat(surveyor.roster().all().keySet()).containsExactly(3);
    }

    @Test
    void reportsNoMoreThanCanBeDrawn() {
        var things = new ArrayList<Standing>();
        for (int number = 1; number <= ObjectTracker.MOST_THINGS + 7; number++) {
            things.add(thing(2 * number, 0));
        }
        surveyor.look(List.copyOf(things));
        assertThat(surveyor.roster().all()).hasSize(ObjectTracker.MOST_THINGS);
        assertThat(surveyor.roster().left()).isEqualTo(7);
        things.removeFirst();
        surveyor.look(things);
        assertThat(surveyor.roster().left()).isEqualTo(6);
    }
}
