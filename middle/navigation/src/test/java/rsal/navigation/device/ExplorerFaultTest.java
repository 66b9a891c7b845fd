package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.device.Device;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Subscription;
import rsal.fault.Fault;
import rsal.fault.FaultyLocalizer;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;
import rsal.testkit.LongTest;
import rsal.testkit.contract.RobotBench;

/// An explorer whose localizer has faults, as scenarios give them.
class ExplorerFaultTest extends RobotBench {
    /// Puts around its localizers what scenarios do.
    private record Breakable(DeviceDriver inner) implements DeviceDriver {
        @Override
        public String key() {
            return inner.key();
        }

        @Override
        public String description() {
            return inner.description();
        }

        @Override
        public Class<? extends Device> makes() {
            return inner.makes();
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return inner.needs();
        }

        @Override
        public List<Parameter<?>> parameters() {
            return inner.parameters();
        }

        @Override
        public Device create(Context context, Arguments arguments) {
            return new FaultyLocalizer((Localizer) inner.create(context, arguments));
        }
    }

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new Breakable(new SlamDriver()), new NavigatorDriver(), new ExplorerDriver());
    }

    private Explorer explorer() {
        return robot().require(Explorer.class);
    }

    private Subscription begin(Fault.OfSensor fault) {
        return robot().require(FaultyLocalizer.class).begin(fault, new SplittableRandom(1));
    }

    private boolean isFree(char place) {
        OccupancyGrid map = explorer().latest().orElseThrow().value();
        return map.isFree(WORLD.pose(place, 0).x(), WORLD.pose(place, 0).y());
    }

    @LongTest
    @Test
    void standsAndSaysSoWhileItsLocalizerSaysNothingAndGoesOnAfterwards() {
        advance(20);
        var reported = new ArrayList<Health>();
        explorer().onHealth(reported::add);
        Subscription dead = begin(new Fault.Dead());
        advance(10);
        assertThat(robot().require(Localizer.class).health()).isInstanceOf(Health.Stale.class);
        assertThat(robot().require(Navigator.class).health()).isInstanceOf(Health.Stale.class);
        assertThat(explorer().health()).isInstanceOf(Health.Stale.class);
        assertThat(explorer().isComplete()).isFalse();
        var stands = truth();
        advance(80); // longer than its navigator's patience
        assertThat(truth()).isEqualTo(stands);
        dead.cancel();
        for (int seconds = 0; seconds < 600 && !explorer().isComplete(); seconds += 10) {
            advance(10);
        }

        assertThat(robot().devices()).allMatch(device -> device.health().isOk());
        assertThat(reported).as("once each").hasSize(2);
        assertThat(List.of('@', 'a', 'b', 'c')).allMatch(this::isFree);
        assertThat(explorer().isComplete()).isTrue();
        assertThat(simulation().contacts()).isEmpty();
    }
}
