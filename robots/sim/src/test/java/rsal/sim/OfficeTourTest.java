package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.behavior.PilotDriver;
import rsal.behavior.PioneerStack;
import rsal.data.Pose2d;
import rsal.model.RobotModels;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.LongTest;

/// The office floor is made for robots that follow their left wall.
class OfficeTourTest {
    @LongTest
    @ParameterizedTest
    @CsvSource({"1, pioneer2dx, urg04lx", "2, pioneer2dx, urg04lx", "3, pioneer3at, utm30lx"})
    void aWallFollowerToursTheOfficeAndGetsStuckNowhere(long seed, String name, String laser) {
        RobotModel model = model(name, laser);
        var spec = SimRun.robot("prey", model, Pose2d.ofDegrees(-12, -1, 180));
        var run = SimRun.seeded(SimProviderTest.OFFICE, seed, Runnable::run, List.of(spec));
        var driver = new PilotDriver();
        driver.create(
                        new DeviceDriver.Context(
                                "pilot",
                                run.robot("prey"),
                                SimProviderTest.OFFICE,
                                Optional.empty(),
                                run.scheduler,
                                new SplittableRandom(seed)),
                        Arguments.defaults(driver.parameters()))
                .engage(PioneerStack.followLeftWall(model));
        Pose2d here = run.truth("prey");
        double distance = 0;
        int meter = 0; // in which it has been for so many steps
        for (int step = 0; step < 3000; step++) {
            run.advance(0.1);
            meter++;
            if (run.truth("prey").distanceTo(here) > 1) {
                here = run.truth("prey");
                distance++;
                meter = 0;
            }
            assertThat(meter).as("steps near %s", here).isLessThan(600);
        }
        assertThat(distance).isGreaterThan(50);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    private static RobotModel model(String name, String laser) {
        var here = Location.of("test");
        return new RobotModels(FileSource.folder(Path.of(".")))
                .read(name, here, Map.of("laser", new RobotModels.Choice(laser, here)));
    }
}
