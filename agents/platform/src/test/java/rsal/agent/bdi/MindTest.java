package rsal.agent.bdi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentContext;
import rsal.agent.bdi.Mind.GoalState;
import rsal.agent.bdi.Mind.GoalView;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.platform.Run;

class MindTest {
    private final Run run = new Run();
    private final List<String> log = new ArrayList<>();
    private Optional<Mind> mind = Optional.empty();

    private void agent(Consumer<Mind> declare) {
        run.start("amy", self -> {
            var own = new Mind(self);
            mind = Optional.of(own);
            declare.accept(own);
            own.begin();
        });
        run.advance(0);
    }

    private Mind mind() {
        return mind.orElseThrow();
    }

    private GoalView goal(String name) {
        return mind().view().goals().stream()
                .filter(goal -> goal.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /// Goes on until somebody ends it, and logs what becomes of it.
    private Consumer<PlanContext> endless(String name) {
        return doing -> {
            log.add(name + " begins");
            doing.onSuspend(() -> log.add(name + " waits"))
                    .onResume(() -> log.add(name + " goes on"))
                    .onEnd(() -> log.add(name + " ends"));
        };
    }

    @Test
    void mostUrgentGoalThatIsWantedIsPursuedAndTheOtherWaits() {
        var danger = new ArrayList<Belief<Boolean>>();
        agent(mind -> {
            Belief<Boolean> hunted = mind.belief("hunted", false);
            danger.add(hunted);
            mind.goal("explore").plan("wander", endless("wander"));
            mind.goal("escape").priority(() -> 5).when(hunted::get).plan("flee", endless("flee"));
        });
        danger.getFirst().set(true);
        run.advance(0);
        assertThat(goal("explore").state()).isEqualTo(GoalState.SUSPENDED);
        assertThat(goal("escape").state()).isEqualTo(GoalState.PURSUED);
        assertThat(run.view("amy").state()).isEqualTo("escape: flee");
        danger.getFirst().set(false);
        run.advance(0);
        assertThat(log).containsExactly("wander begins", "wander waits", "flee begins", "flee ends", "wander goes on");
        assertThat(goal("escape").state()).isEqualTo(GoalState.NOT_WANTED);
    }

    @Test
    void oneOfEqualUrgencyDoesNotDisturb() {
        agent(mind -> {
            mind.goal("first").plan("a", endless("a"));
            mind.goal("second").plan("b", endless("b"));
        });
        mind().think();
        run.advance(10);
        assertThat(log).containsExactly("a begins");
        assertThat(goal("second").state()).isEqualTo(GoalState.WAITING);
    }

    @Test
    void urgencyMayChange() {
        var hunger = new ArrayList<Belief<Double>>();
        agent(mind -> {
            Belief<Double> charge = mind.belief("charge", 1.0);
            hunger.add(charge);
            mind.goal("recharge").priority(() -> 1 - charge.get()).plan("dock", endless("dock"));
            mind.goal("work").priority(() -> 0.5).plan("dig", endless("dig"));
        });
        for (double charge : new double[] {0.7, 0.4, 0.9}) {
            hunger.getFirst().set(charge);
            run.advance(0);
        }
        assertThat(log).containsExactly("dig begins", "dig waits", "dock begins", "dock waits", "dig goes on");
    }

    @Test
    void plansAreTriedInTurnAsFarAsTheyApply() {
        agent(mind -> mind.goal("enter")
                .plan("window", () -> false, endless("window"))
                .plan("door", doing -> doing.fail("It is locked."))
                .plan("knock", endless("knock")));
        assertThat(log).containsExactly("knock begins");
        assertThat(goal("enter").failure()).isEqualTo("door: It is locked.");
        assertThat(goal("enter").steps()).containsExactly("enter: knock");
    }

    @Test
    void goalWhosePlansHaveAllFailedRestsAndIsTriedAgain() {
        agent(mind -> {
            mind.goal("enter").priority(() -> 9).pause(Duration.ofSeconds(5)).plan("door", doing -> {
                log.add("door");
                doing.fail("It is locked.");
            });
            mind.goal("wait").plan("sit", endless("sit"));
        });
        run.advance(4);
        assertThat(goal("enter").state()).isEqualTo(GoalState.RESTING);
        run.advance(7);
        assertThat(log)
                .containsExactly(
                        "door", "sit begins", "sit waits", "door", "sit goes on", "sit waits", "door", "sit goes on");
    }

    @Test
    void whatIsReachedOtherwiseIsGivenUp() {
        var charge = new ArrayList<Belief<Double>>();
        agent(mind -> {
            charge.add(mind.belief("charge", 0.1));
            mind.goal("recharge").until(() -> charge.getFirst().get() > 0.9).plan("dock", endless("dock"));
        });
        charge.getFirst().set(1.0);
        run.advance(0);
        assertThat(log).containsExactly("dock begins", "dock ends");
        assertThat(goal("recharge").state()).isEqualTo(GoalState.REACHED);
        charge.getFirst().set(0.5);
        run.advance(0);
        assertThat(log).hasSize(3).last().isEqualTo("dock begins");
    }

    @Test
    void planThatSucceedsWithoutReachingTheTargetMakesRoomForTheNext() {
        agent(mind -> mind.goal("tidy")
                .until(() -> false)
                .plan("sweep", PlanContext::succeed)
                .plan("mop", endless("mop")));
        assertThat(log).containsExactly("mop begins");
    }

    @Test
    void goalForOnceEndsForGood() {
        agent(mind -> {
            mind.goal("wave").priority(() -> 1).once().plan("lift the arm", doing -> {
                log.add("waved");
                doing.succeed();
            });
            mind.goal("fail").priority(() -> 1).once().plan("try", doing -> {
                log.add("tried");
                doing.fail("no");
            });
        });
        run.advance(100);
        assertThat(log).containsExactly("waved", "tried");
        assertThat(mind().view().goals()).isEmpty();
        assertThat(run.view("amy").state()).isEqualTo("nothing to do");
    }

    @Test
    void planMayTakeStepsAndWaitsForThem() {
        agent(mind -> mind.goal("fetch").once().plan("by hand", doing -> {
            Goal door = mind.step("open the door")
                    .plan("pull", tried -> tried.fail("It sticks."))
                    .plan("push", tried -> {
                        log.add(String.join(
                                " > ", mind.view().goals().getFirst().steps()));
                        tried.succeed();
                    });
            doing.achieve(door, open -> {
                log.add("open: " + open);
                doing.succeed();
            });
        }));
        run.advance(0);
        assertThat(log).containsExactly("fetch: by hand > open the door: push", "open: true");
    }

    @Test
    void stepThatFailsIsTheAffairOfThePlanThatTookIt() {
        agent(mind -> mind.goal("fetch")
                .plan(
                        "by hand",
                        doing -> doing.achieve(mind.step("open the door"), open -> {
                            log.add("open: " + open);
                            doing.fail("There is no way in.");
                        }))
                .plan("ask", endless("ask")));
        assertThat(log).containsExactly("open: false", "ask begins");
    }

    @Test
    void planThatFailsWhileItsStepIsUnderWayEndsTheStep() {
        agent(mind -> mind.goal("fetch")
                .plan("by hand", doing -> {
                    doing.achieve(mind.step("walk").plan("on foot", endless("walk")), _ -> log.add("never"));
                    run.scheduler.after(Duration.ofSeconds(1), () -> doing.fail("It is gone."));
                })
                .plan("ask", endless("ask")));
        run.advance(2);
        assertThat(log).containsExactly("walk begins", "walk ends", "ask begins");
    }

    @Test
    void planThatFailsWhileItIsSuspendedMakesRoomForTheNextWhenItsTurnComes() {
        var danger = new ArrayList<Belief<Boolean>>();
        agent(mind -> {
            Belief<Boolean> hunted = mind.belief("hunted", false);
            danger.add(hunted);
            mind.goal("go")
                    .plan("drive", doing -> {
                        log.add("drive");
                        doing.onSuspend(() -> doing.fail("cancelled"));
                    })
                    .plan("walk", endless("walk"));
            mind.goal("escape").priority(() -> 5).when(hunted::get).plan("flee", endless("flee"));
        });
        danger.getFirst().set(true);
        run.advance(0);
        assertThat(log).containsExactly("drive", "flee begins");
        danger.getFirst().set(false);
        run.advance(0);
        assertThat(log).containsExactly("drive", "flee begins", "flee ends", "walk begins");
    }

    @Test
    void whatAgentsDoEndsWithThem() {
        var danger = new ArrayList<Belief<Boolean>>();
        agent(mind -> {
            danger.add(mind.belief("hunted", false));
            mind.goal("low").plan("a", endless("a"));
            mind.goal("high").priority(() -> 9).when(danger.getFirst()::get).plan("b", endless("b"));
        });
        danger.getFirst().set(true);
        run.advance(0);
        run.stop("amy");
        assertThat(log).containsExactly("a begins", "a waits", "b begins", "b ends", "a ends");
    }

    @Test
    void whatIsDroppedEnds() {
        var goals = new ArrayList<Goal>();
        agent(mind -> goals.add(mind.goal("sit").plan("down", endless("sit"))));
        goals.getFirst().drop();
        run.advance(10);
        assertThat(log).containsExactly("sit begins", "sit ends");
        assertThat(mind().view().goals()).isEmpty();
    }

    @Test
    void planThatThrowsEndsTheAgent() {
        agent(mind -> mind.goal("jump").plan("high", _ -> {
            throw new IllegalStateException("My legs!");
        }));
        assertThat(run.view("amy").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("amy").state()).isEqualTo("My legs!");
    }

    @Test
    void beliefsAreShownAndHaveNamesOfTheirOwn() {
        agent(mind -> {
            mind.belief("charge", 0.5);
            assertThatThrownBy(() -> mind.belief("charge", 0.5))
                    .hasMessageContaining("'amy'")
                    .hasMessageContaining("'charge'");
        });
        assertThat(run.view("amy").beliefs()).containsEntry("charge", "0.5");
        assertThat(mind().view().beliefs()).containsEntry("charge", "0.5");
    }

    @Test
    void whoLooksIntoAnAgentSeesItsMind() {
        agent(mind -> {
            mind.belief("charge", 0.5);
            mind.goal("explore")
                    .priority(() -> 3)
                    .plan("wander", endless("wander"))
                    .plan("stroll", endless("stroll"));
        });
        assertThat(run.look("amy", Mind.View.class)).contains(mind().view());
        assertThat(goal("explore").plans()).containsExactly("wander", "stroll");
        assertThat(goal("explore").urgency()).isEqualTo(3);
        run.stop("amy");
        assertThat(run.look("amy", Mind.View.class)).isEmpty();
        assertThat(run.look("zoe", Mind.View.class)).isEmpty();
    }

    @Test
    void lookingDoesAnAgentNoHarmThatCannotShowItsMind() {
        var tired = new boolean[1];
        agent(mind -> mind.goal("explore")
                .priority(() -> {
                    if (tired[0]) {
                        throw new IllegalStateException("too tired to say");
                    }
                    return 1;
                })
                .plan("wander", endless("wander")));
        tired[0] = true;
        assertThatThrownBy(() -> run.look("amy", Mind.View.class))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'amy' can't be inspected");
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
    }

    /// Whatever happens, one plan at most has the robot, and each that began ends once.
    @Test
    void onePlanAtATimeHasTheRobot() {
        for (int seed = 0; seed < 300; seed++) {
            var random = new SplittableRandom(seed);
            var chaos = new Run();
            var ledger = new Ledger();
            chaos.start("amy", self -> chaotic(self, random, ledger));
            chaos.advance(60);
            chaos.stop("amy");
            assertThat(chaos.view("amy").status()).as("seed %d", seed).isEqualTo(Status.ENDED);
            assertThat(ledger.holders).as("seed %d", seed).isZero();
            assertThat(ledger.begun).as("seed %d", seed).isEqualTo(ledger.ended).isPositive();
        }
    }

    private static final class Ledger {
        private int holders;
        private int begun;
        private int ended;

        void take() {
            holders++;
            assertThat(holders).isEqualTo(1);
        }
    }

    private static void chaotic(AgentContext self, SplittableRandom random, Ledger ledger) {
        var mind = new Mind(self);
        for (int i = 0; i < 4; i++) {
            Belief<Double> urgency = mind.belief("urgency " + i, 0.0);
            self.scheduler().every(Duration.ofMillis(300 + 100 * i), () -> urgency.set((double) random.nextInt(4)));
            Goal goal = mind.goal("goal " + i).priority(urgency::get).when(() -> urgency.get() > 0);
            for (int j = 0; j < 3; j++) {
                goal.plan("plan " + j, doing -> {
                    var holds = new boolean[] {true};
                    ledger.begun++;
                    ledger.take();
                    doing.onSuspend(() -> {
                                holds[0] = false;
                                ledger.holders--;
                            })
                            .onResume(() -> {
                                holds[0] = true;
                                ledger.take();
                            })
                            .onEnd(() -> {
                                ledger.ended++;
                                ledger.holders -= holds[0] ? 1 : 0;
                            });
                    if (random.nextInt(3) > 0) {
                        self.scheduler()
                                .after(
                                        Duration.ofMillis(random.nextInt(2_000)),
                                        random.nextBoolean() ? doing::succeed : () -> doing.fail("chance"));
                    }
                });
            }
        }
        mind.begin();
    }
}
