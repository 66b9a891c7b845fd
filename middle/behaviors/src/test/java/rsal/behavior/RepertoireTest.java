package rsal.behavior;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.model.RobotModels;
import rsal.robot.RobotModel;
import rsal.settings.FileSource;
import rsal.settings.Location;

class RepertoireTest {
    private static final RobotModel PIONEER = new RobotModels(FileSource.resources(RepertoireTest.class, "/"))
            .read("pioneer2dx", Location.of("test"), Map.of());

    @Test
    void whatItNamesItCanDo() {
        assertThat(Repertoire.names()).containsExactly("wander", "wall-follow");
        assertThat(Repertoire.stack("wander", PIONEER).orElseThrow().names()).startsWith("wander");
        assertThat(Repertoire.stack("wall-follow", PIONEER).orElseThrow().names())
                .startsWith("follow-wall");
    }

    @Test
    void whatItDoesNotNameItCanNotDo() {
        assertThat(Repertoire.stack("dance", PIONEER)).isEmpty();
    }
}
