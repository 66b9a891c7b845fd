package rsal.agent.board;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentContext;
import rsal.agent.ChannelModel;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.platform.Run;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Weather;
import rsal.data.Point2d;

class TeamBoardTest {
    private static final Topic<String> CANS = new Topic<>("cans", String.class);
    private static final Duration LONG = Duration.ofHours(1);

    private final Run run = new Run();

    private static void keeper(Run run, String name) {
        keeper(run, name, BoardKeeper.Limits.DEFAULT);
    }

    private static void keeper(Run run, String name, BoardKeeper.Limits limits) {
        run.start(name, self -> new BoardKeeper(self, "team", limits).begin());
    }

    /// An agent that does with its end of the board what a test wants, and keeps what it is told of it.
    private static final class User {
        private final List<BoardEvent> events = new ArrayList<>();
        private final AtomicReference<TeamBoard> board = new AtomicReference<>();
        private final Run run;
        private final String name;

        User(Run run, String name) {
            this.run = run;
            this.name = name;
            run.start(name, self -> board.set(new TeamBoard(self, "team", events::add)));
            run.advance(0);
        }

        TeamBoard board() {
            return board.get();
        }

        void write(String note, String content) {
            board().write(CANS, note, content, LONG);
        }

        /// What the master knows; in a perfect network, as others can't wait for it.
        List<String> ask(Query<String> query) {
            var found = new ArrayList<String>();
            board().ask(query, ending -> found.addAll(words(ending)));
            run.advance(0);
            return found;
        }

        @Override
        public String toString() {
            return name;
        }
    }

    private static List<String> words(ConversationResult<Found<String>> ending) {
        return ending instanceof ConversationResult.Informed<Found<String>>(Found<String> found)
                ? found.notes().stream()
                        .map(note -> note.author() + " " + note.name() + ": " + note.content())
                        .toList()
                : List.of(ending.toString());
    }

    private static List<String> words(BoardWatch<String> watch) {
        return watch.notes().stream()
                .map(note -> note.author() + " " + note.name() + ": " + note.content())
                .toList();
    }

    @Test
    void whatOneWritesOthersFind() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        var bob = new User(run, "bob");
        amy.write("can-1", "red");
        run.advance(1);
        bob.write("can-1", "blue");
        run.advance(1);
        assertThat(amy.ask(Query.of(CANS))).containsExactly("bob can-1: blue", "amy can-1: red");
        assertThat(bob.ask(Query.of(CANS).by("amy"))).containsExactly("amy can-1: red");
        assertThat(bob.ask(Query.of(CANS).newest(1))).containsExactly("bob can-1: blue");
        assertThat(amy.events).containsExactly(new BoardEvent.Kept("master"));
        assertThat(run.view("master").state()).isEqualTo("keeping 2 notes, which 0 watch");
    }

    @Test
    void whenTheNewestGoesThatIsWatchedTheNextIsShown() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        BoardWatch<String> newest = amy.board().watch(Query.of(CANS).newest(1), () -> {});
        for (int can = 1; can <= 5; can++) {
            amy.write("can-" + can, "red");
            run.advance(1);
        }
        assertThat(words(newest)).containsExactly("amy can-5: red");
        amy.board().erase(CANS, "can-5");
        run.advance(1);
        assertThat(words(newest)).containsExactly("amy can-4: red");
    }

    @Test
    void placesAreFoundByDistance() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        amy.board().write(CANS, "near", "red", new Point2d(1, 1), LONG);
        amy.board().write(CANS, "far", "red", new Point2d(9, 1), LONG);
        run.advance(1);
        assertThat(amy.ask(Query.of(CANS).within(2, new Point2d(0, 1)))).containsExactly("amy near: red");
    }

    @Test
    void asMuchAsIsAskedForIsReportedAndHowMuchIsLeft() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        for (int i = 0; i < 10; i++) {
            amy.write("can-" + i, "red");
        }
        run.advance(1);
        var left = new ArrayList<Integer>();
        amy.board().ask(Query.of(CANS).newest(3), ending -> {
            if (ending instanceof ConversationResult.Informed<Found<String>>(Found<String> found)) {
                left.add(found.notes().size());
                left.add(found.left());
            }
        });
        run.advance(0);
        assertThat(left).containsExactly(3, 7);
    }

    @Test
    void notesFadeForTheMasterAndForThoseWhoWatchAtTheSameInstant() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        BoardWatch<String> watch = new User(run, "bob").board().watch(Query.of(CANS), () -> {});
        amy.board().write(CANS, "can-1", "red", Duration.ofSeconds(10));
        run.advance(9.9);
        assertThat(words(watch)).containsExactly("amy can-1: red");
        assertThat(amy.ask(Query.of(CANS))).hasSize(1);
        run.advance(0.1);
        assertThat(words(watch)).isEmpty();
        assertThat(amy.ask(Query.of(CANS))).isEmpty();
    }

    @Test
    void whoWatchesHearsWhatThereIsWhatComesAndWhatGoes() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        amy.write("can-1", "red");
        run.advance(1);
        var heard = new ArrayList<List<String>>();
        var bob = new User(run, "bob");
        var watch = new AtomicReference<BoardWatch<String>>();
        watch.set(bob.board().watch(Query.of(CANS), () -> heard.add(words(watch.get()))));
        run.advance(1);
        amy.write("can-2", "blue");
        run.advance(1);
        amy.board().erase(CANS, "can-1");
        run.advance(1);
        assertThat(heard)
                .containsExactly(
                        List.of("amy can-1: red"),
                        List.of("amy can-2: blue", "amy can-1: red"),
                        List.of("amy can-2: blue"));
        watch.get().cancel();
        amy.write("can-3", "green");
        run.advance(1);
        assertThat(heard).hasSize(3);
        assertThat(run.view("master").state()).isEqualTo("keeping 2 notes, which 0 watch");
    }

    @Test
    void whatIsNoMoreWantedIsGoneForThoseWhoWatch() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        BoardWatch<String> watch =
                new User(run, "bob").board().watch(Query.of(CANS).within(2, new Point2d(0, 0)), () -> {});
        amy.board().write(CANS, "can-1", "red", new Point2d(1, 0), LONG);
        run.advance(1);
        assertThat(words(watch)).hasSize(1);
        amy.board().write(CANS, "can-1", "red", new Point2d(5, 0), LONG);
        run.advance(1);
        assertThat(words(watch)).isEmpty();
    }

    @Test
    void nobodyTouchesWhatAnotherWrote() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        var bob = new User(run, "bob");
        amy.write("can-1", "red");
        run.advance(1);
        bob.board().erase(CANS, "can-1");
        run.start("eve", self -> forge(self, new Note<>(CANS, "can-1", "none", Optional.empty(), "amy", now(), LONG)));
        run.advance(1);
        assertThat(bob.ask(Query.of(CANS))).containsExactly("amy can-1: red");
    }

    private static void forge(AgentContext self, Note<?> note) {
        new Request<>(self, "write team", BoardService.Writing.class, BoardService.Written.class)
                .ask("master", new BoardService.Writing(now(), 1, List.of(note), List.of()), _ -> {});
    }

    private static Instant now() {
        return Instant.EPOCH;
    }

    @Test
    void whatWasWrittenInTheFutureIsRefused() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        run.start(
                "eve",
                self -> forge(self, new Note<>(CANS, "can", "red", Optional.empty(), "eve", now().plus(LONG), LONG)));
        run.advance(1);
        assertThat(amy.ask(Query.of(CANS))).isEmpty();
    }

    @Test
    void withoutAMasterNotesWaitForOne() {
        var amy = new User(run, "amy");
        amy.write("can-1", "red");
        amy.board().write(CANS, "old", "red", Duration.ofSeconds(1));
        run.advance(5);
        assertThat(amy.ask(Query.of(CANS))).containsExactly("Silent[why=Nobody keeps board 'team'.]");
        keeper(run, "master");
        run.advance(1);
        assertThat(amy.ask(Query.of(CANS))).containsExactly("amy can-1: red");
    }

    @Test
    void nextMasterHearsAllFromThoseWhoWroteIt() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        var bob = new User(run, "bob");
        BoardWatch<String> watch = bob.board().watch(Query.of(CANS), () -> {});
        amy.write("can-1", "red");
        bob.write("can-2", "blue");
        run.advance(1);
        run.stop("amy");
        run.stop("master");
        run.advance(1);
        assertThat(watch.isCurrent()).isFalse();
        assertThat(words(watch)).containsExactly("amy can-1: red", "bob can-2: blue");
        bob.write("can-3", "green");
        keeper(run, "other");
        run.advance(1);
        assertThat(watch.isCurrent()).isTrue();
        assertThat(words(watch)).containsExactly("bob can-3: green", "bob can-2: blue");
        assertThat(bob.events)
                .containsExactly(
                        new BoardEvent.Kept("master"), new BoardEvent.Gone("master"), new BoardEvent.Kept("other"));
    }

    @Test
    void masterThatStartsAgainUnderItsNameKnowsAllAgain() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        BoardWatch<String> watch = amy.board().watch(Query.of(CANS), () -> {});
        amy.write("can-1", "red");
        run.advance(1);
        run.stop("master");
        keeper(run, "master");
        run.advance(10);
        assertThat(amy.ask(Query.of(CANS))).containsExactly("amy can-1: red");
        assertThat(words(watch)).containsExactly("amy can-1: red");
        assertThat(watch.isCurrent()).isTrue();
        assertThat(run.view("master").state()).isEqualTo("keeping 1 notes, which 1 watch");
    }

    @Test
    void ofTwoMastersOfOneBoardTheSecondStandsBy() {
        keeper(run, "first");
        keeper(run, "second");
        var amy = new User(run, "amy");
        var bob = new User(run, "bob");
        amy.write("can-1", "red");
        run.advance(1);
        assertThat(bob.ask(Query.of(CANS))).containsExactly("amy can-1: red");
        assertThat(run.view("second").state()).isEqualTo("standing by for 'first'");
        run.stop("first");
        run.advance(1);
        assertThat(bob.ask(Query.of(CANS))).containsExactly("amy can-1: red");
        assertThat(bob.board().keeper()).contains("second");
        assertThat(run.view("second").state()).isEqualTo("keeping 1 notes, which 0 watch");
    }

    @Test
    void boardsOfDifferentNamesHaveNothingToDoWithEachOther() {
        keeper(run, "master");
        run.start("others", self -> new BoardKeeper(self, "others", BoardKeeper.Limits.DEFAULT).begin());
        var heard = new ArrayList<String>();
        run.start("amy", self -> {
            var team = new TeamBoard(self, "team", _ -> {});
            var others = new TeamBoard(self, "others", _ -> {});
            self.scheduler().execute(() -> {
                team.write(CANS, "can-1", "red", LONG);
                others.write(CANS, "can-1", "blue", LONG);
                others.ask(Query.of(CANS), ending -> heard.addAll(words(ending)));
            });
        });
        run.advance(1);
        assertThat(heard).containsExactly("amy can-1: blue");
    }

    @Test
    void masterThatIsNotHeardIsReportedAndHearsEverythingWhenItIsBack() {
        var cut = new AtomicBoolean();
        run.deliverBy((message, listener) ->
                cut.get() && (listener.equals("master") || message.sender().equals("master"))
                        ? List.of()
                        : List.of(Duration.ZERO));
        keeper(run, "master");
        var amy = new User(run, "amy");
        BoardWatch<String> watch = new User(run, "bob").board().watch(Query.of(CANS), () -> {});
        amy.write("can-1", "red");
        run.advance(1);
        cut.set(true);
        amy.write("can-1", "blue");
        amy.write("can-2", "blue");
        run.advance(30);
        assertThat(words(watch)).containsExactly("amy can-1: red");
        assertThat(watch.isCurrent()).isFalse();
        amy.board().erase(CANS, "can-2");
        cut.set(false);
        run.advance(10);
        assertThat(words(watch)).containsExactly("amy can-1: blue");
        assertThat(watch.isCurrent()).isTrue();
        assertThat(run.view("master").state()).isEqualTo("keeping 1 notes, which 1 watch");
        assertThat(amy.events)
                .containsExactly(
                        new BoardEvent.Kept("master"),
                        new BoardEvent.Silent("master", "Nothing was heard of 'master' for 5.0 s."),
                        new BoardEvent.Heard("master"));
    }

    @Test
    void oneWhoFloodsTheBoardFillsItsOwnRoomOnly() {
        keeper(run, "master", new BoardKeeper.Limits(10, 100, 10, 2));
        var eve = new User(run, "eve");
        for (int i = 0; i < 1_500; i++) {
            eve.write("can-" + i, "red");
        }
        var amy = new User(run, "amy");
        amy.write("can-1", "blue");
        run.advance(5);
        assertThat(amy.ask(Query.of(CANS).by("amy"))).containsExactly("amy can-1: blue");
        assertThat(amy.ask(Query.of(CANS).newest(1_000))).hasSize(101);
        assertThat(eve.events.stream().filter(BoardEvent.Refused.class::isInstance))
                .hasSize(1_400)
                .contains(
                        new BoardEvent.Refused(
                                "cans/can-999",
                                "'eve' has 100 notes here already, which is the maximum for one agent."),
                        new BoardEvent.Refused(
                                "cans/can-1499", "'eve' has more notes than the maximum of 1000 for one agent."));
        eve.board().erase(CANS, "can-0");
        eve.write("can-new", "red");
        run.advance(1);
        assertThat(amy.ask(Query.of(CANS).named("can-new"))).hasSize(1);
    }

    @Test
    void oneWhoAsksWithoutEndIsEndedAndNobodyElse() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        amy.write("can-1", "red");
        run.start("eve", self -> {
            var board = new TeamBoard(self, "team", _ -> {});
            self.scheduler().after(Duration.ofSeconds(1), () -> {
                for (int i = 0; i < 20_000; i++) {
                    board.ask(Query.of(CANS), _ -> {});
                }
            });
        });
        run.advance(5);
        assertThat(run.view("eve").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("master").status()).isEqualTo(Status.RUNNING);
        assertThat(amy.ask(Query.of(CANS))).containsExactly("amy can-1: red");
    }

    @Test
    void thereIsRoomForSoManyAuthorsAndWatchesOnly() {
        keeper(run, "master", new BoardKeeper.Limits(2, 10, 3, 2));
        var amy = new User(run, "amy");
        var bob = new User(run, "bob");
        var zoe = new User(run, "zoe");
        amy.write("can", "red");
        bob.board().write(CANS, "can", "red", Duration.ofSeconds(5));
        run.advance(1);
        zoe.write("can", "red");
        for (int i = 0; i < 3; i++) {
            zoe.board().watch(Query.of(CANS), () -> {});
        }
        run.advance(1);
        assertThat(zoe.events)
                .contains(
                        new BoardEvent.Refused("cans/can", "2 agents have notes here, which is the maximum."),
                        new BoardEvent.Refused(
                                "watch cans, at most 100", "2 watch here, 2 of them (zoe); no more than 3 and 2 may."));
        run.advance(5);
        zoe.write("can", "red"); // what bob wrote has faded
        run.advance(1);
        assertThat(amy.ask(Query.of(CANS))).containsExactly("zoe can: red", "amy can: red");
    }

    @Test
    void quickChangesAreReportedAsOne() {
        keeper(run, "master");
        var amy = new User(run, "amy");
        var heard = new ArrayList<String>();
        var watch = new AtomicReference<BoardWatch<String>>();
        watch.set(new User(run, "bob").board().watch(Query.of(CANS), () -> heard.addAll(words(watch.get()))));
        run.advance(1);
        for (int i = 0; i < 50; i++) {
            amy.write("can", "red " + i);
            run.advance(0.01);
        }
        run.advance(1);
        assertThat(heard).hasSizeLessThan(8).last().isEqualTo("amy can: red 49");
    }

    /// Against a table of what each agent wrote last: when all is quiet again, master and watchers know just that.
    @Test
    void inBadWeatherAllKnowTheSameInTheEnd() {
        for (int seed = 0; seed < (Boolean.getBoolean("rsal.test.all") ? 60 : 15); seed++) {
            var random = new SplittableRandom(seed);
            var storm = new Run();
            storm.deliverBy(new Weather(random.split(), 0.2, 0.2, Duration.ofMillis(900)));
            keeper(storm, "master-1");
            List<User> users = Stream.of("amy", "bob", "zoe")
                    .map(name -> new User(storm, name))
                    .toList();
            BoardWatch<String> all = users.get(0).board().watch(Query.of(CANS), () -> {});
            BoardWatch<String> ofBob = users.get(2).board().watch(Query.of(CANS).by("bob"), () -> {});
            Map<String, Instant> model = new HashMap<>(); // when what was written fades
            for (int step = 0; step < 80; step++) {
                User user = users.get(random.nextInt(3));
                String name = "can-" + random.nextInt(4);
                String known = user + " " + name;
                model.keySet().removeIf(note -> note.startsWith(known + ":"));
                if (random.nextInt(4) == 0) {
                    user.board().erase(CANS, name);
                } else {
                    Duration lifetime = random.nextInt(3) == 0 ? Duration.ofSeconds(3) : LONG;
                    user.board().write(CANS, name, "v" + step, lifetime);
                    model.put(known + ": v" + step, storm.scheduler.instant().plus(lifetime));
                }
                storm.advance(random.nextDouble());
                if (step == 40 && seed % 3 == 0) {
                    storm.stop("master-1");
                    keeper(storm, "master-2");
                }
            }
            storm.advance(60);
            model.values().removeIf(fades -> !storm.scheduler.instant().isBefore(fades));
            assertThat(words(all)).as("seed %d", seed).containsExactlyInAnyOrderElementsOf(model.keySet());
            assertThat(words(ofBob))
                    .as("seed %d, of bob", seed)
                    .containsExactlyInAnyOrderElementsOf(model.keySet().stream()
                            .filter(note -> note.startsWith("bob"))
                            .toList());
            storm.deliverBy(ChannelModel.PERFECT);
            assertThat(users.get(1).ask(Query.of(CANS)))
                    .as("seed %d, asked", seed)
                    .containsExactlyInAnyOrderElementsOf(model.keySet());
        }
    }

    @Test
    void equalSeedsGiveTheSame() {
        assertThat(stormOf(7)).isEqualTo(stormOf(7)).isNotEqualTo(stormOf(8));
    }

    private static List<String> stormOf(int seed) {
        var storm = new Run();
        List<String> said = storm.transcript();
        storm.deliverBy(new Weather(new SplittableRandom(seed), 0.2, 0.2, Duration.ofMillis(900)));
        keeper(storm, "master");
        var amy = new User(storm, "amy");
        new User(storm, "bob").board().watch(Query.of(CANS), () -> {});
        for (int i = 0; i < 30; i++) {
            amy.write("can-" + i % 7, "v" + i);
            storm.advance(0.3);
        }
        return said;
    }
}
