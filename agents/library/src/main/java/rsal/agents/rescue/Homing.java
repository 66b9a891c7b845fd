package rsal.agents.rescue;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agents.driving.NavigationClient;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;

/// Takes a robot back to where its agent first knew to be, when nobody has wanted it for a few seconds, so that it
/// waits in nobody's way.
final class Homing {
    private static final Duration LOOK = Duration.ofSeconds(1);
    private static final Duration PATIENCE = Duration.ofSeconds(5);
    private static final Tolerance THERE = Tolerance.position(0.5);

    private final AgentContext self;
    private final NavigationClient driver;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final BooleanSupplier idle;
    private Optional<Pose2d> mapFromHome = Optional.empty();
    private Instant since = Instant.MIN; // it was wanted, or on its way

    /// @param idle whether nobody wants the robot
    Homing(AgentContext self, NavigationClient driver, Supplier<Optional<Pose2d>> mapFromBase, BooleanSupplier idle) {
        this.self = self;
        this.driver = driver;
        this.mapFromBase = mapFromBase;
        this.idle = idle;
    }

    void begin() {
        self.scheduler().every(LOOK, this::look);
    }

    private void look() {
        Instant now = self.scheduler().instant();
        Optional<Pose2d> here = mapFromBase.get();
        mapFromHome = mapFromHome.or(() -> here);
        boolean away = here.isPresent() && here.get().distanceTo(mapFromHome.orElseThrow()) > 2 * THERE.distance();
        if (!idle.getAsBoolean() || driver.mapFromGoal().isPresent()) {
            since = now;
        } else if (away && !since.plus(PATIENCE).isAfter(now)) {
            driver.goTo(mapFromHome.orElseThrow(), THERE, _ -> {}); // if it does not get there, it tries again
        }
    }
}
